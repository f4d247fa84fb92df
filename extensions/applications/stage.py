"""Where an application runs: chosen, set and looked at by any thread, fed by one."""

from __future__ import annotations

import logging
import threading
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Protocol

from extensions.applications.drawing import Drawing
from extensions.applications.hand import HandSample
from extensions.applications.interface import Command
from extensions.applications.runner import FAILED, KIND, ApplicationRunner, Outcome
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Estimate, Event

_log = logging.getLogger(__name__)


class CommandSink(Protocol):
    """Takes an application's commands to a device; passes over those that are not for it."""

    def take(self, commands: Sequence[Command], t: float) -> None:
        """What a sample at ``t`` (s) has brought; called for each sample, also without commands."""

    def close(self) -> None:
        """Let the device rest."""


class Viewer(Protocol):
    """Shows what an application draws, somewhere else."""

    def show(self, title: str, hand: HandSample, drawing: Drawing) -> None:
        """The newest; never waits."""

    def close(self) -> None: ...


class ApplicationStage:
    """Empty until `show`. ``tell`` gets each event, in the thread that feeds."""

    def __init__(
        self, hand: HandModel, glove: GloveModel, tell: Callable[[Event], None] = lambda _: None
    ) -> None:
        self._hand, self._glove = hand, glove
        self._runner: ApplicationRunner | None = None
        self._ending: list[ApplicationRunner] = []  # shown before, and not yet told that they end
        self._anew = False
        self._lock = threading.Lock()  # what is shown, what ends and where it begins anew
        self.tell = tell
        self.sinks: list[CommandSink] = []
        self.viewers: list[Viewer] = []
        self.outcome: Outcome | None = None
        self.counts: Counter[str] = Counter()
        self.last: Event | None = None
        self.latest: dict[str, Event] = {}  # of each kind of event
        self.problem = ""

    # --- from any thread

    @property
    def name(self) -> str:
        """Of the application that is shown; empty where there is none."""
        runner = self._runner
        return runner.name if runner is not None else ""

    @property
    def title(self) -> str:
        """What it is called; empty where there is none."""
        runner = self._runner
        return runner.application.title if runner is not None else ""

    @property
    def settings(self) -> Any:
        """The dataclass of its settings; None where there is none."""
        runner = self._runner
        return runner.settings if runner is not None else None

    def show(self, name: str, settings: Mapping[str, Any] | None = None) -> None:
        """Run another application, as new; an empty name: none. Raises ConfigError."""
        made = ApplicationRunner(name, self._hand, self._glove, settings) if name else None
        with self._lock:
            if self._runner is not None:
                self._ending.append(self._runner)
            self._runner, self._anew = made, False
            self.outcome, self.last, self.problem = None, None, ""
            self.counts = Counter()
            self.latest = {}

    def set(self, key: str, value: Any) -> None:
        """Change a setting. Raises ConfigError."""
        runner = self._runner
        if runner is not None:
            runner.set(key, value)

    def begin_anew(self) -> None:
        """From the next sample on, as in the beginning: a recording holds all of it."""
        with self._lock:
            self._anew = True

    # --- from the one that feeds

    def feed(self, estimate: Estimate) -> Iterator[Outcome]:
        """Give an estimate to the application, if there is one; to be gone through."""
        with self._lock:
            ending, self._ending = self._ending, []
            runner, anew = self._runner, self._anew
            resting = runner is None or bool(self.problem)
            self._anew = anew and resting
        for before in ending:
            if before.has_begun:
                self._hear(before.ended(estimate.t))
        if runner is None or resting:
            return
        if anew:
            self.counts.clear()
            self.latest = {}
            runner.begin_anew()
        try:
            for outcome in runner.feed(estimate):
                self._take(outcome)
                yield outcome
        except Exception as error:  # noqa: BLE001 - a stranger's code must not end ours
            self._fail(runner, estimate.t, error)

    def _take(self, outcome: Outcome) -> None:
        for sink in list(self.sinks):
            sink.take(outcome.commands, outcome.t)
        self.outcome = outcome
        for viewer in list(self.viewers):
            viewer.show(self.title, outcome.hand, outcome.drawing)
        for event in outcome.events:
            self._hear(event)

    def _hear(self, event: Event) -> None:
        self.counts[str(event.data["what"])] += 1
        self.last = event
        self.latest = {**self.latest, str(event.data["what"]): event}  # others read it meanwhile
        self.tell(event)

    def _fail(self, runner: ApplicationRunner, t: float, error: Exception) -> None:
        """It rests until it is chosen again."""
        _log.error("The application %s failed", runner.name, exc_info=error)
        self.problem = f"{type(error).__name__}: {error}"
        data: dict[str, object] = {"application": runner.name, "hand": runner.side, "what": FAILED}
        self._hear(Event(t, KIND, self.problem, data))

    def close(self) -> None:
        """Let all devices rest."""
        with self._lock:
            sinks, viewers = self.sinks, self.viewers
            self.sinks, self.viewers = [], []
        for sink in sinks:
            sink.close()
        for viewer in viewers:
            viewer.close()
