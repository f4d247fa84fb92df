"""In the process that tracks: what is new for the window since the last message."""

from __future__ import annotations

import logging
import time
from collections.abc import Mapping, Sequence
from typing import TypeVar, cast

from app.engines.apart.messages import EngineUpdate, FileUpdate, HandUpdate, NewFrame, Pixels
from app.engines.apart.pixels import PixelWriter
from app.engines.engine import EngineSetup
from app.engines.protocols import RecordedFile
from tracker.base.shared_memory import NoSharedMemory
from tracker.live.frame_results import MOST_SHOWN
from tracker.live.history import Timed
from tracker.live.listeners import RemoteListener
from tracker.messages import Calibration, StereoFrame

_log = logging.getLogger(__name__)
STATUS_EVERY = 0.1  # s: its medians are slow
REPORT_EVERY = 0.25  # s, of devices

T = TypeVar("T", bound=Timed)


class _Due:
    """True at most once in ``period`` s."""

    def __init__(self, period: float) -> None:
        self._period, self._next = period, float("-inf")

    def __call__(self, now: float) -> bool:
        if now < self._next:
            return False
        self._next = now + self._period
        return True


class HandWatch:
    """What is new of one hand."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self._imu_t = self._image_t = self._frame_t = float("-inf")
        self._calibration: Calibration | None = None
        self._status_due, self._report_due = _Due(STATUS_EVERY), _Due(REPORT_EVERY)

    def news(self, now: float) -> HandUpdate:
        """Everything since the last call; ``now`` in s."""
        hand, live, device = self._setup.tracked, self._setup.live, self._setup.connection.device
        imu = _since(hand.recent_imu(), self._imu_t)
        images = _since(hand.recent_images(), self._image_t)
        self._imu_t = imu[-1].t if imu else self._imu_t
        self._image_t = images[-1].t if images else self._image_t
        calibration = hand.calibration()
        changed = calibration is not self._calibration
        self._calibration = calibration
        return HandUpdate(
            imu,
            images,
            self._frames([image.t for image in images[-MOST_SHOWN:]]),
            calibration if changed else None,
            hand.status() if self._status_due(now) else None,
            live.hand.reference_estimate() if live is not None else None,
            device.report() if device is not None and self._report_due(now) else None,
            self._listeners(),
        )

    def _listeners(self) -> dict[str, object]:
        listeners = cast(Mapping[str, RemoteListener], self._setup.listeners)  # `remote_kinds`
        found = {name: listener.news() for name, listener in listeners.items()}
        return {name: news for name, news in found.items() if news is not None}

    def _frames(self, at: Sequence[float]) -> tuple[NewFrame, ...]:
        found = (self._setup.tracked.latest_frame(t) for t in at)
        return tuple(NewFrame(f[0].t, f[1], f[2]) for f in found if f is not None)

    def newest(self) -> StereoFrame | None:
        """The newest image that is shown; None if that has not changed since the last call."""
        shown = self._setup.tracked.latest_frame()
        if shown is None or shown[0].t == self._frame_t:
            return None
        self._frame_t = shown[0].t
        return shown[0]


def _since(messages: Sequence[T], t: float) -> tuple[T, ...]:
    """The messages after ``t`` s; they are in the order of time."""
    k = len(messages)
    while k and messages[k - 1].t > t:
        k -= 1
    return tuple(messages[k:])


class Newsroom:
    """What is new of an engine. For one thread, except ``files`` and ``profiles``."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self._hands = {hand.side: HandWatch(hand) for hand in setup.hands}
        self._profile = setup.profile
        self.files: Mapping[int, RecordedFile] = {}  # replaced, never changed
        self.profiles = 0  # changes by the user
        self.pixels = PixelWriter()
        self._is_full = False  # the system's shared memory

    def news(self) -> tuple[EngineUpdate, str]:
        """Everything since the last call, and the name of the memory of pixels if it is new."""
        setup, now = self._setup, time.monotonic()
        hands = {side: watch.news(now) for side, watch in self._hands.items()}
        pixels, memory = self._pixels()
        profiles, profile = self.profiles, setup.engine.profile  # in this order
        changed, self._profile = profile != self._profile, profile
        device = setup.camera.device
        return EngineUpdate(
            hands,
            pixels,
            tuple(setup.engine.drain_events()),
            setup.live.engine.failure if setup.live is not None else None,
            profile if changed else None,
            profiles,
            {key: _file_update(file) for key, file in self.files.items()},
            device.unfit if device is not None else None,
        ), memory

    def _pixels(self) -> tuple[Pixels | None, str]:
        """The newest image of any hand: both have the same camera."""
        found = [frame for w in self._hands.values() if (frame := w.newest()) is not None]
        if not found:
            return None, ""
        try:
            return self.pixels.put(max(found, key=lambda frame: frame.t))
        except NoSharedMemory as error:  # images are not shown, and everything else is
            if not self._is_full:
                _log.warning("%s", error)
            self._is_full = True
            return None, ""


def _file_update(file: RecordedFile) -> FileUpdate:
    return FileUpdate(file.written, file.broken, file.problem, file.closed, dict(file.figures))
