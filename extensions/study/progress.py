"""How far a participant is: a file that is replaced as a whole after each step.

A recording whose trial was not finished, and one that is repeated, is moved to the folder
``superseded`` of its participant; nothing is deleted.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from extensions.study.protocol import Protocol, Task
from extensions.study.schedule import TRIAL, ScheduleStep, steps_of
from tracker.base.errors import FileError, GlovetrackError
from tracker.base.files import make_folder, read_bounded, write_whole
from tracker.base.notices import failure
from tracker.session.recover import needs_recovery, recover

try:
    import fcntl
except ImportError:  # Windows: two programs are not prevented from running one participant
    fcntl = None  # type: ignore[assignment]

SCHEMA = 1
MOST_BYTES = 20_000_000
OPEN, RECORDING, RECORDED, ACCEPTED, FAILED, DONE = (
    "open", "recording", "recorded", "accepted", "failed", "done",
)  # fmt: skip
"""States of a step: not begun; its file is being written; is complete, without a decision;
accepted; recorded as often as allowed, without a good verdict; a practice trial or a rest that is
over."""
STATES = (OPEN, RECORDING, RECORDED, ACCEPTED, FAILED, DONE)
FINISHED = (ACCEPTED, FAILED, DONE)


@dataclass
class Try:
    """One recording of a trial. ``file``: relative to the participant's folder; ``outcome``:
    empty while it is undecided, else accepted, failed, repeated or interrupted; ``begun``: UTC;
    ``verdict`` as `extensions.study.verdict.TrialVerdict.as_json`."""

    file: str
    begun: str = ""
    outcome: str = ""
    verdict: dict[str, Any] | None = None
    recovered: str = ""


@dataclass
class Entry:
    """A step and what happened to it."""

    state: str = OPEN
    tries: list[Try] = field(default_factory=list)


class Progress:
    """The steps of one participant of the study in ``folder``, and their entries by name.

    Raises FileError for a damaged file.
    """

    def __init__(self, folder: Path, protocol: Protocol, participant: str) -> None:
        if participant not in protocol.participants:
            known = protocol.participants
            raise FileError(failure("study.no_participant", name=participant, known=known))
        self.protocol, self.participant = protocol, participant
        self.root = folder / f"sub-{participant}"
        self.steps = steps_of(protocol, participant)
        self.entries = {step.name: Entry() for step in self.steps}
        self._path = self.root / "progress.json"
        if self._path.exists():
            self._read()

    @property
    def step(self) -> ScheduleStep | None:
        """The first step that is not finished; None at the end."""
        return next((s for s in self.steps if self.entries[s.name].state not in FINISHED), None)

    @property
    def task(self) -> Task | None:
        """The task of the present trial; None in a rest and at the end."""
        step = self.step
        return self.protocol.tasks[step.task] if step is not None and step.task else None

    @property
    def tries(self) -> int:
        """Recordings of the present step so far, without interrupted ones."""
        tries = self.entry(self.step).tries if self.step is not None else []
        return sum(one.outcome != "interrupted" for one in tries)

    @property
    def trials(self) -> tuple[ScheduleStep, ...]:
        """All trials, without practice and rests."""
        return tuple(step for step in self.steps if step.kind == TRIAL)

    def entry(self, step: ScheduleStep) -> Entry:
        return self.entries[step.name]

    def path(self, step: ScheduleStep) -> Path:
        """The file of a trial."""
        return self.root / f"ses-{step.condition}" / f"{step.name}.mcap"

    # ---- changes, each of which is on the disk when the function returns

    def begin(self, step: ScheduleStep, begun: str) -> Path:
        """A trial's recording begins now; returns its path, whose folder exists."""
        path = self.path(step)
        make_folder(path.parent)
        self._supersede(step, "interrupted")  # what another program left under this name
        entry = self.entry(step)
        entry.tries.append(Try(self._relative(path), begun))
        entry.state = RECORDING
        self.save()
        return path

    def withdraw(self, step: ScheduleStep) -> None:
        """The trial's recording could not begin: it does not count as a try."""
        if os.path.lexists(self.path(step)):
            self.repeat(step, "interrupted")
            return
        entry = self.entry(step)
        entry.tries.pop()
        entry.state = OPEN
        self.save()

    def recorded(self, step: ScheduleStep) -> None:
        """The file of a trial is complete."""
        self.entry(step).state = RECORDED
        self.save()

    def judged(self, step: ScheduleStep, verdict: Mapping[str, Any]) -> None:
        """Enter a verdict on the trial's last recording."""
        self.entry(step).tries[-1].verdict = dict(verdict)
        self.save()

    def accept(self, step: ScheduleStep, failed: bool = False) -> None:
        """The trial's last recording counts; ``failed``: it is the last try, and not good."""
        entry = self.entry(step)
        entry.state = FAILED if failed else ACCEPTED
        entry.tries[-1].outcome = entry.state
        self.save()

    def repeat(self, step: ScheduleStep, outcome: str = "repeated") -> None:
        """The trial is open again; its last recording is superseded."""
        self._supersede(step, outcome)
        self.entry(step).state = OPEN
        self.save()

    def done(self, step: ScheduleStep) -> None:
        """A practice trial or a rest is over."""
        self.entry(step).state = DONE
        self.save()

    def resume(self) -> list[ScheduleStep]:
        """After a crash: recordings that were being written are superseded, their readable part
        is recovered next to them, and their trials are open again. Returns these trials."""
        found = []
        for step in self.trials:
            if self.entry(step).state == RECORDING:
                self.repeat(step, "interrupted")
                found.append(step)
        return found

    def save(self) -> None:
        """Replace the file. Raises DiskError."""
        make_folder(self.root)
        steps = {
            step.name: {"kind": step.kind, **asdict(self.entry(step))}
            for step in self.steps
            if self.entry(step) != Entry()
        }
        whole = {
            "schema": SCHEMA,
            "study": self.protocol.name,
            "participant": self.participant,
            "steps": steps,
        }
        write_whole(self._path, json.dumps(whole, indent=1) + "\n")

    # ----

    def _supersede(self, step: ScheduleStep, outcome: str) -> None:
        path, entry = self.path(step), self.entry(step)
        if entry.tries and not entry.tries[-1].outcome:
            entry.tries[-1].outcome = outcome
        if not os.path.lexists(path):
            return
        number = max(len(entry.tries), 1)
        moved = self.root / "superseded" / f"{step.name}_try-{number}.mcap"
        while os.path.lexists(moved):
            number += 1
            moved = moved.with_name(f"{step.name}_try-{number}.mcap")
        make_folder(moved.parent)
        path.rename(moved)
        if entry.tries:
            entry.tries[-1].file = self._relative(moved)
            entry.tries[-1].recovered = self._recovered(moved)

    def _recovered(self, path: Path) -> str:
        """The relative path of what could be read of an interrupted recording, or nothing."""
        with suppress(GlovetrackError):  # it has no message yet: there is nothing to recover
            if needs_recovery(path):
                return self._relative(recover(path).path)
        return ""

    def _relative(self, path: Path) -> str:
        return path.relative_to(self.root).as_posix()

    def _read(self) -> None:
        try:
            stored = json.loads(read_bounded(self._path, MOST_BYTES, "a progress file"))
            for name, found in stored["steps"].items():
                if found["state"] not in STATES:
                    raise ValueError(f"the state {found['state']!r} is unknown")
                if name in self.entries:
                    tries = [Try(**one) for one in found["tries"]]
                    self.entries[name] = Entry(found["state"], tries)
        except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
            raise FileError(
                failure("study.progress_damaged", path=self._path, why=error)
            ) from error


@contextmanager
def locked(progress: Progress) -> Iterator[None]:
    """No other program runs this participant meanwhile. Raises FileError if one does."""
    make_folder(progress.root)
    handle = os.open(progress.root / ".lock", os.O_RDWR | os.O_CREAT)
    try:
        _lock(handle, progress)
        yield
    finally:
        os.close(handle)


def _lock(handle: int, progress: Progress) -> None:
    if fcntl is None:
        return
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        where = {"participant": progress.participant, "folder": progress.root.parent}
        raise FileError(failure("study.in_use", **where)) from error
