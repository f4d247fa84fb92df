"""Hosts an application: it is selected, configured and observed by any thread and fed by one."""

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
    """Sends an application's commands to a device; ignores commands for other devices."""

    def take(self, commands: Sequence[Command], t: float) -> None:
        """Take the commands of a sample at ``t`` (s); called for each sample, also without any."""

    def close(self) -> None:
        """Stop the device."""


class Viewer(Protocol):
    """Shows an application's drawing outside the window."""

    def show(self, title: str, hand: HandSample, drawing: Drawing) -> None:
        """Show the newest drawing; does not block."""

    def close(self) -> None: ...


class ShownStage(Protocol):
    """A stage as a panel sees it; the attributes are those of `ApplicationStage`."""

    viewers: list[Viewer]

    @property
    def name(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def settings(self) -> Any: ...
    @property
    def outcome(self) -> Outcome | None: ...
    @property
    def counts(self) -> Counter[str]: ...
    @property
    def latest(self) -> Mapping[str, Event]: ...
    @property
    def problem(self) -> str: ...
    @property
    def delays_window(self) -> bool:
        """Whether it competes with the window for Python's lock."""

    def show(self, name: str, settings: Mapping[str, Any] | None = None) -> None: ...
    def set(self, key: str, value: Any) -> None: ...
    def restart(self) -> None: ...


class ApplicationStage:
    """Empty until `show`. ``tell`` receives each event in the feeding thread."""

    def __init__(
        self, hand: HandModel, glove: GloveModel, tell: Callable[[Event], None] = lambda _: None
    ) -> None:
        self._hand, self._glove = hand, glove
        self._runner: ApplicationRunner | None = None
        self._ending: list[ApplicationRunner] = []  # replaced, but their end is not yet reported
        self._restart = False
        self._lock = threading.Lock()  # guards the three fields above
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
    def delays_window(self) -> bool:
        """It runs in a thread of this process."""
        return True

    @property
    def name(self) -> str:
        """Name of the current application; empty without one."""
        runner = self._runner
        return runner.name if runner is not None else ""

    @property
    def title(self) -> str:
        """Title of the current application; empty without one."""
        runner = self._runner
        return runner.application.title if runner is not None else ""

    @property
    def settings(self) -> Any:
        """The dataclass of its settings; None without an application."""
        runner = self._runner
        return runner.settings if runner is not None else None

    def show(self, name: str, settings: Mapping[str, Any] | None = None) -> None:
        """Start another application; an empty name stops it. Raises ConfigError."""
        made = ApplicationRunner(name, self._hand, self._glove, settings) if name else None
        with self._lock:
            if self._runner is not None:
                self._ending.append(self._runner)
            self._runner, self._restart = made, False
            self.outcome, self.last, self.problem = None, None, ""
            self.counts = Counter()
            self.latest = {}

    def set(self, key: str, value: Any) -> None:
        """Change a setting. Raises ConfigError."""
        runner = self._runner
        if runner is not None:
            runner.set(key, value)

    def restart(self) -> None:
        """Start over with the next sample, so that a recording contains all of the run."""
        with self._lock:
            self._restart = True

    # --- from the feeding thread

    def feed(self, estimate: Estimate) -> Iterator[Outcome]:
        """Feed an estimate to the application, if any; yields the results."""
        with self._lock:
            ending, self._ending = self._ending, []
            runner, restart = self._runner, self._restart
            resting = runner is None or bool(self.problem)
            self._restart = restart and resting
        for before in ending:
            if before.has_begun:
                self._receive(before.ended(estimate.t))
        if runner is None or resting:
            return
        if restart:
            self.counts.clear()
            self.latest = {}
            runner.restart()
        try:
            for outcome in runner.feed(estimate):
                self._take(outcome)
                yield outcome
        except Exception as error:  # noqa: BLE001 - code of plug-ins must not stop the program
            self._fail(runner, estimate.t, error)

    def _take(self, outcome: Outcome) -> None:
        for sink in list(self.sinks):
            sink.take(outcome.commands, outcome.t)
        self.outcome = outcome
        for viewer in list(self.viewers):
            viewer.show(self.title, outcome.hand, outcome.drawing)
        for event in outcome.events:
            self._receive(event)

    def _receive(self, event: Event) -> None:
        self.counts[str(event.data["what"])] += 1
        self.last = event
        self.latest = {
            **self.latest,
            str(event.data["what"]): event,
        }  # replaced, because other threads read it
        self.tell(event)

    def _fail(self, runner: ApplicationRunner, t: float, error: Exception) -> None:
        """Stop a failed application until it is selected again."""
        _log.error("The application %s failed", runner.name, exc_info=error)
        self.problem = f"{type(error).__name__}: {error}"
        data: dict[str, object] = {"application": runner.name, "hand": runner.side, "what": FAILED}
        self._receive(Event(t, KIND, self.problem, data))

    def close(self) -> None:
        """Stop all devices."""

        with self._lock:
            sinks, viewers = self.sinks, self.viewers
            self.sinks, self.viewers = [], []
        for sink in sinks:
            sink.close()
        for viewer in viewers:
            viewer.close()
