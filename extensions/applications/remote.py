"""Applications of a hand that another process tracks: they run there, next to the glove's motors.

The window has an `ApplicationProxy` with a `RemoteStage`, which shows what the last `StageNews`
contained and passes the user's choices on.
"""

from __future__ import annotations

import threading
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from extensions.applications.runner import Outcome
from extensions.applications.sharing import ArrayReceiver, Packed
from extensions.applications.stage import Viewer
from tracker.live.listeners import ListenerLine
from tracker.messages import Estimate, Event


@dataclass(frozen=True)
class StageNews:
    """The state of a stage: see `ApplicationStage`. ``shown`` counts the applications that were
    started or stopped before."""

    shown: int = 0
    name: str = ""
    title: str = ""
    settings: Any = None
    outcome: Outcome | None = None
    counts: Counter[str] = field(default_factory=Counter)
    last: Event | None = None
    latest: Mapping[str, Event] = field(default_factory=dict)
    problem: str = ""


class RemoteStage:
    """`ShownStage` of an application in another process. Written by one thread, read by any."""

    def __init__(self, line: ListenerLine) -> None:
        self._line = line
        self._news = StageNews()  # replaced, never changed
        self._replacing = threading.Lock()
        self.viewers: list[Viewer] = []

    @property
    def name(self) -> str:
        return self._news.name

    @property
    def title(self) -> str:
        return self._news.title

    @property
    def settings(self) -> Any:
        return self._news.settings

    @property
    def outcome(self) -> Outcome | None:
        return self._news.outcome

    @property
    def counts(self) -> Counter[str]:
        return self._news.counts

    @property
    def last(self) -> Event | None:
        return self._news.last

    @property
    def latest(self) -> Mapping[str, Event]:
        return self._news.latest

    @property
    def problem(self) -> str:
        return self._news.problem

    @property
    def delays_window(self) -> bool:
        """It runs in another process."""
        return False

    def show(self, name: str, settings: Mapping[str, Any] | None = None) -> None:
        """As `ApplicationStage.show`. Raises GlovetrackError."""
        shown: StageNews = self._line.ask("show", name, settings)
        self._replace(shown)

    def set(self, key: str, value: Any) -> None:
        """As `ApplicationStage.set`. Raises GlovetrackError."""
        self._line.ask("set", key, value)

    def restart(self) -> None:
        self._line.tell("restart")

    def take(self, news: StageNews) -> None:
        """News that were sent before the last `show` are discarded."""
        if self._replace(news) and news.outcome is not None:
            for viewer in list(self.viewers):
                viewer.show(news.title, news.outcome.hand, news.outcome.drawing)

    def _replace(self, news: StageNews) -> bool:
        with self._replacing:
            if news.shown < self._news.shown:
                return False
            self._news = news
            return True

    def close(self) -> None:
        """Close the viewers."""
        viewers, self.viewers = self.viewers, []
        for viewer in viewers:
            viewer.close()


class ApplicationProxy:
    """The window's representative of `LiveApplication`, which receives the estimates itself."""

    def __init__(self, line: ListenerLine) -> None:
        self.stage = RemoteStage(line)
        self._receiver = ArrayReceiver()

    def take(self, news: Packed) -> None:
        """What `LiveApplication.news` has returned."""
        self.stage.take(self._receiver.unpack(news))

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        """The listener has received the estimate in its process."""

    def restart(self) -> None:
        """The listener restarts with the recording in its process."""

    def close(self) -> None:
        self.stage.close()
