"""Devices and files that belong to the process that tracks, as the window sees them."""

from __future__ import annotations

import math
import threading
from collections.abc import Mapping
from functools import partial
from typing import Any

from app.engines.apart.messages import FileUpdate
from app.engines.apart.process import EngineProcess, process_ended
from app.words import notice_text
from tracker.base.clock import monotonic
from tracker.messages import Message
from tracker.sensors.camera import UnfitImages
from tracker.sensors.camera_controls import CameraReport, Control, Locks
from tracker.sensors.camera_fixed import FixedSetting
from tracker.sensors.glove_report import GloveReport

CONTROLS = "controls"
RENEW_AFTER = 0.5  # s


class ApartGlove:
    """`GloveDevice`; ``news`` is its last report."""

    def __init__(self, process: EngineProcess, side: str, news: GloveReport) -> None:
        self._process, self._target = process, f"glove {side}"
        self.news = news

    def report(self) -> GloveReport:
        return self.news

    def request_rate(self, rate_hz: int) -> None:
        self._process.tell(self._target, "request_rate", rate_hz)

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> bool:
        """Returns whether the request was sent; the glove's own answer is not waited for."""
        return self._process.tell_now(self._target, "vibrate", channel, amplitude, duration_ms)


class ApartCamera:
    """`CameraDevice`."""

    def __init__(self, fps: float) -> None:
        self.fps = fps
        self.unfit: UnfitImages | None = None


class ApartControls:
    """`CameraControls`: as they were `RENEW_AFTER` s ago at most, plus the time of a slow driver.
    The window waits only for the first answer."""

    def __init__(self, process: EngineProcess) -> None:
        self._process = process
        self._known: dict[str, Any] = {}
        self._due: dict[str, float] = {}  # s, when each is asked for again

    def controls(self) -> tuple[Control, ...]:
        found: tuple[Control, ...] = self._latest("controls")
        return found

    def reports(self) -> tuple[CameraReport, ...]:
        found: tuple[CameraReport, ...] = self._latest("reports")
        return found

    def fixed(self) -> tuple[FixedSetting, ...]:
        found: tuple[FixedSetting, ...] = self._latest("fixed")
        return found

    def request_locks(self, locks: Locks) -> None:
        self._process.tell(CONTROLS, "request_locks", locks)
        self._due.clear()

    def _latest(self, what: str) -> Any:
        if what not in self._known:
            self._store(what, self._process.ask_or((), CONTROLS, what))
        elif monotonic() >= self._due.get(what, 0.0):
            self._due[what] = math.inf  # until there is an answer
            self._process.ask_later(CONTROLS, what, answer=partial(self._store, what))
        return self._known[what]

    def _store(self, what: str, found: Any) -> None:
        self._known[what] = found
        self._due[what] = monotonic() + RENEW_AFTER


class ApartFile:
    """`RecordedFile`: a recording that the process writes, under the number ``key``."""

    def __init__(self, process: EngineProcess, key: int) -> None:
        self._process, self.key = process, key
        self._news = FileUpdate(0, False, "", False, {})
        self._paused = False
        self._closed = threading.Event()

    def take(self, news: FileUpdate) -> None:
        """What the process reports of it."""
        self._news = news
        if news.closed:
            self._closed.set()

    def end(self) -> None:
        """The process has ended; the recorder's own process completes the file."""
        if not self._closed.is_set():
            self._news = FileUpdate(self.written, True, notice_text(process_ended()), True, {})
            self._closed.set()

    @property
    def paused(self) -> bool:
        return self._paused

    @paused.setter
    def paused(self, on: bool) -> None:
        self._paused = on
        self._process.tell("files", "pause", self.key, on)

    @property
    def written(self) -> int:
        return self._news.written

    @property
    def broken(self) -> bool:
        return self._news.broken

    @property
    def problem(self) -> str:
        return self._news.problem

    @property
    def figures(self) -> Mapping[str, float]:
        return self._news.figures

    @property
    def closed(self) -> bool:
        return self._closed.is_set()

    def wait(self, longest: float) -> bool:
        return self._closed.wait(longest)

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        """Write a message that is not of the engine, for example of an excerpt."""
        return bool(self._ask("write", message, overloaded, side))

    def flush(self) -> None:
        self._ask("flush")

    def close(self) -> None:
        self._ask("close")
        self._closed.set()

    def _ask(self, method: str, *args: Any) -> Any:
        return self._process.ask("files", method, self.key, *args, wait=100.0)
