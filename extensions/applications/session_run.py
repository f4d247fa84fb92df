"""Runs an application without a window; its events are printed, recorded or compared."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from extensions.applications.runner import BEGINS, ENDS, KIND, SETTING, ApplicationRunner, Outcome
from extensions.applications.sources import HandSource, recorded
from extensions.applications.stage import CommandSink
from tracker.base.clock import monotonic
from tracker.base.errors import FileError
from tracker.base.files import check_target
from tracker.base.notices import notice
from tracker.messages import Estimate, Event
from tracker.session.images import PackedFrame
from tracker.session.writer import SessionRecorder, new_session


@dataclass
class ApplicationReport:
    """Result of a run. ``took`` (s) per sample; ``differs``: the first event that differs from the
    session, empty if all are equal or none was compared."""

    application: str
    samples: int = 0
    primitives: int = 0  # of the last drawing
    commands: int = 0
    events: list[Event] = field(default_factory=list)
    took: list[float] = field(default_factory=list)
    differs: str = ""

    def to_json(self) -> dict[str, Any]:
        ms = 1e3 * np.array(self.took or [0.0])
        return {
            "application": self.application,
            "samples": self.samples,
            "commands": self.commands,
            "primitives": self.primitives,
            "events": dict(Counter(str(e.data["what"]) for e in self.events)),
            "step_ms": {"median": float(np.median(ms)), "p99": float(np.percentile(ms, 99))},
            "differs": self.differs,
        }

    def lines(self) -> list[str]:
        data = self.to_json()
        counts = ", ".join(f"{n} {k}" for k, n in data["events"].items()) or "none"
        step = data["step_ms"]
        out = [
            f"{self.application}: {self.samples} samples, {self.commands} commands",
            f"events: {counts}",
            f"a step takes {step['median']:.2f} ms (median), {step['p99']:.2f} ms (99 %)",
        ]
        return [*out, self.differs] if self.differs else out


def run(
    name: str,
    source: HandSource,
    settings: Mapping[str, Any] | None = None,
    sinks: Sequence[CommandSink] = (),
    recorder: SessionRecorder | None = None,
    look: Callable[[str, Outcome], None] = lambda title, outcome: None,
) -> ApplicationReport:
    """Feed the application with the complete source; ``look`` receives its title and the result of
    each sample. Raises ConfigError, FileError."""
    runner = ApplicationRunner(name, source.info.hand, source.info.glove, settings)
    report, last = ApplicationReport(name), 0.0
    for message in source.messages:
        if isinstance(message, Event) and message.kind == KIND:
            continue  # of an earlier run
        if recorder is not None:
            if isinstance(message, PackedFrame):
                recorder.write_packed(message)
            else:
                recorder.write(message)
        if isinstance(message, Estimate):
            last = message.t
            for event in _feed(runner, message, report, sinks, look):
                if recorder is not None:
                    recorder.write(event)
    if report.samples and recorder is not None:
        recorder.write(runner.ended(last))
    return report


def _feed(
    runner: ApplicationRunner,
    estimate: Estimate,
    report: ApplicationReport,
    sinks: Sequence[CommandSink] = (),
    look: Callable[[str, Outcome], None] = lambda title, outcome: None,
) -> list[Event]:
    events: list[Event] = []
    before = monotonic()
    for outcome in runner.feed(estimate):
        now = monotonic()
        report.took.append(now - before)
        for sink in sinks:
            sink.take(outcome.commands, outcome.t)
        report.samples += 1
        report.commands += len(outcome.commands)
        report.primitives = len(outcome.drawing)
        events += outcome.events
        look(runner.application.title, outcome)
        before = monotonic()
    report.events += events
    return events


@dataclass(frozen=True)
class Into:
    """Output of a run: a new session (None: none) made from ``inputs``; ``force`` overwrites."""

    out: Path | None = None
    inputs: Sequence[Path] = ()
    force: bool = False


def run_into(
    name: str,
    source: HandSource,
    into: Into,
    settings: Mapping[str, Any] | None = None,
    sinks: Sequence[CommandSink] = (),
    look: Callable[[str, Outcome], None] = lambda title, outcome: None,
) -> ApplicationReport:
    """`run` into a new session, which is written completely or not at all."""
    with ExitStack() as stack:
        recorder = None
        if into.out is not None:
            check_target(into.out, into.force, into.inputs)
            new = new_session(into.out, source.info, into.force, into.inputs)
            recorder = stack.enter_context(new)
        return run(name, source, settings, sinks, recorder, look)


def replay(path: Path) -> list[ApplicationReport]:
    """Run all applications of a session again with their settings and changes of these.

    Raises FileError if the session contains none.
    """
    with recorded(path) as source:
        recorded_events = [m for m in source.messages if isinstance(m, Event) and m.kind == KIND]
    runs = []
    for side in dict.fromkeys(str(e.data["hand"]) for e in recorded_events):
        events = [e for e in recorded_events if e.data["hand"] == side]
        begun = [i for i, e in enumerate(events) if e.data["what"] == BEGINS]
        runs += [events[i:j] for i, j in zip(begun, [*begun[1:], len(events)], strict=True)]
    if not runs:
        raise FileError(notice("applications.none_recorded", path=path))
    return [_again(path, run) for run in runs]


def _again(path: Path, events: Sequence[Event]) -> ApplicationReport:
    """Repeat the run that starts with the first of ``events``."""
    first, name = events[0], str(events[0].data["application"])
    settings: Any = first.data["settings"]
    changes = [e for e in events if e.data["what"] == SETTING]
    wanted = [e for e in events if e.data["what"] != ENDS and e.data["application"] == name]
    report = ApplicationReport(name)
    with recorded(path, str(first.data["hand"])) as source:
        runner = ApplicationRunner(name, source.info.hand, source.info.glove, settings)
        for message in source.messages:
            if not isinstance(message, Estimate) or message.t < first.t:
                continue
            while changes and changes[0].t <= message.t:
                change = changes.pop(0)
                runner.set(str(change.data["key"]), change.data["value"])
            _feed(runner, message, report)
            if message.t >= wanted[-1].t and len(report.events) >= len(wanted):
                break
    report.differs = difference(wanted, report.events[: len(wanted)])
    return report


def difference(wanted: Sequence[Event], found: Sequence[Event]) -> str:
    """Description of the first event that differs from ``wanted``; empty if all are equal."""
    for i, event in enumerate(wanted):
        if i >= len(found) or (found[i].t, found[i].data) != (event.t, event.data):
            again = found[i].data if i < len(found) else "nothing"
            return f"At {event.t:.3f} s the session holds {event.data}, and now it is {again}."
    return ""
