"""Reads images and detects the board in a separate thread."""

from __future__ import annotations

import logging
import math
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from app.platform.tasks import TaskOwner
from app.words import error_text
from tracker.base.errors import GlovetrackError
from tracker.calibration.stereo.collect import Collector, ExposureResult
from tracker.calibration.stereo.solve import CalibrationError, SolveParams, solve
from tracker.calibration.stereo.views import (
    BoardFinder,
    BoardLook,
    Size,
    StereoView,
    sizes_of,
)
from tracker.sensors.image_input import ImageInput, Pair

_log = logging.getLogger(__name__)

NO_IMAGE = 0.05  # s to wait if the device has no image


@dataclass(frozen=True, eq=False)
class BoardSeen:
    """One exposure, the detected corners and the decision about the view."""

    number: int
    pair: Pair
    look: BoardLook
    answer: ExposureResult


class BoardWatcher:
    """Collects views until it is stopped. Thread-safe."""

    def __init__(self, make_source: Callable[[], ImageInput], finder: BoardFinder) -> None:
        self._make_source, self._finder = make_source, finder
        self._stopping = threading.Event()
        self._lock = threading.Lock()
        self._collector: Collector | None = None
        self._seen: BoardSeen | None = None
        self._errors: dict[StereoView, float] = {}
        self._number = 0
        self.live = True
        self.problem = ""
        self.ended = False
        self._thread = threading.Thread(target=self._run, name="glovetrack-board", daemon=True)
        self._thread.start()

    # --- the window's side

    def latest(self) -> BoardSeen | None:
        return self._seen

    def views(self) -> tuple[StereoView, ...]:
        with self._lock:
            return tuple(self._collector.views) if self._collector is not None else ()

    def error_px(self, view: StereoView) -> float:
        """Error of a view's corners in a calibration of all views so far; NaN before one."""
        return self._errors.get(view, math.nan)

    def remove(self, index: int) -> None:
        with self._lock:
            if self._collector is not None and index < len(self._collector.views):
                self._collector.remove(index)

    def restart(self) -> None:
        """Discard all views and start collecting again."""
        with self._lock:
            self._collector = None

    def stop(self) -> None:
        """Stop the thread and release the camera. May be called repeatedly."""
        self._stopping.set()
        self._thread.join()

    # --- the thread's side

    def _run(self) -> None:
        try:
            source = self._make_source()
            source.open()
        except GlovetrackError as error:
            _log.warning("The camera cannot be opened: %s", error)
            self.problem, self.ended = error_text(error), True
            return
        self.live = source.live
        try:
            self._read(source)
        except GlovetrackError as error:
            _log.warning("Reading the camera has ended: %s", error)
            self.problem = error_text(error)
        finally:
            source.close()
            self.ended = True

    def _read(self, source: ImageInput) -> None:
        while not self._stopping.is_set():
            pair = source.read()
            if pair is not None:
                self._take(pair, source.live)
            elif not source.live:
                return
            else:
                self._stopping.wait(NO_IMAGE)

    def _take(self, pair: Pair, live: bool) -> None:
        look = self._finder.look(*pair)
        with self._lock:
            if self._collector is None:
                self._collector = Collector(pair[0].shape[1])
            answer = self._collector.offer(look, live)
        self._number += 1
        self._seen = BoardSeen(self._number, pair, look, answer)
        if answer is ExposureResult.TAKEN:
            self._judge(sizes_of(pair))

    def _judge(self, sizes: Sequence[Size]) -> None:
        """Detect a bad view while there is time to replace it."""
        views = self.views()
        if len(views) < SolveParams().least_views:
            return
        try:
            found = solve(views, sizes)
        except CalibrationError:
            return  # the result page shows the reason
        self._errors = dict(zip(views, found.error.max(axis=1).tolist(), strict=True))


class Watching:
    """At most one `BoardWatcher`.

    A job, called ``closing``, releases the camera, which may take a second.
    """

    def __init__(self, tasks: TaskOwner, closing: str) -> None:
        self._tasks, self._closing = tasks, closing
        self.watcher: BoardWatcher | None = None

    def start(self, make_source: Callable[[], ImageInput], finder: BoardFinder) -> None:
        self.stop()
        self.watcher = BoardWatcher(make_source, finder)

    def stop(self) -> None:
        watcher, self.watcher = self.watcher, None
        if watcher is not None:
            self._tasks.run(self._closing, lambda _progress: watcher.stop())

    def views(self) -> tuple[StereoView, ...]:
        return self.watcher.views() if self.watcher is not None else ()

    def remove(self, index: int) -> None:
        """Discard a view; a negative ``index`` is ignored."""
        if self.watcher is not None and index >= 0:
            self.watcher.remove(index)
