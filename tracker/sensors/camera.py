"""A stereo camera as the runner requires it: stamped pairs, and events about the device."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tracker.base.clock import monotonic, nanoseconds, seconds
from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, notice, warning
from tracker.messages import EYES, Event, StereoFrame
from tracker.sensors.camera_stamps import HasStamps, SteadyArrivals
from tracker.sensors.image_input import HasShortfalls, Image, ImageInput, Pair
from tracker.sensors.image_watch import ImageWatch, WatchParams
from tracker.vision.rig import StereoRig


@dataclass(frozen=True)
class CameraParams:
    """``delay``: s from the middle of an exposure to the image's arrival on an idle computer."""

    delay: float = 0.035
    retry: float = 0.4  # s between attempts to reopen a disconnected camera
    slow: float = 0.8  # share of the requested frame rate below which a warning is reported
    watch: WatchParams = field(default_factory=WatchParams)


class UnfitImages(NamedTuple):
    """Images that do not match the calibration, and the reason."""

    pair: Pair
    why: Notice


class StereoCamera:
    """Opens its input at the first read, and again after each disconnection.

    A dark side is None in the frame, and a repeated image is left out: neither
    counts as a new exposure. Files are paced by their own frame rate. Without a ``rig``
    images of any size are taken. A device with one camera gives frames without a right image.
    Images that do not match the rig are ``unfit`` and give no frames.
    """

    def __init__(
        self,
        source: ImageInput,
        rig: StereoRig | None,
        params: CameraParams | None = None,
        clock: Callable[[], float] = monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self.rig, self._source, self._params = rig, source, params or CameraParams()
        self._clock, self._sleep = clock, sleep
        self._events: deque[Event] = deque(maxlen=1000)
        self._reported: dict[str, Notice] = {}
        self._open = self._ended = False
        self._next_attempt = float("-inf")
        self._next_due: float | None = None
        self._arrivals: deque[float] = deque(maxlen=120)
        self._steady = SteadyArrivals()
        self._restart_watch()
        self._index = 0
        self.unfit: UnfitImages | None = None
        """The last image, if it does not match the rig: for display and for a new calibration."""
        self.repeated = 0
        """Images left out because they repeat the one before."""
        self.missed = 0
        """Images missing between two that arrived, at the requested rate."""

    def _restart_watch(self) -> None:
        self._watch = (ImageWatch(self._params.watch), ImageWatch(self._params.watch))
        self._arrivals.clear()
        self._steady.restart()

    @property
    def fps(self) -> float:
        """Measured over the last images; 0 before there are two."""
        if len(self._arrivals) < 2:
            return 0.0
        return (len(self._arrivals) - 1) / max(self._arrivals[-1] - self._arrivals[0], 1e-9)

    def read(self, timeout: float) -> StereoFrame | None:
        """The next exposure; None if there is none. A device may delay it by one exposure."""
        if not self._ready(timeout) or not self._due(timeout):
            return None
        try:
            pair = self._source.read()
            if pair is None:
                self._is_disconnected()
                return None
            pair = (in_colour(pair[0]), None if pair[1] is None else in_colour(pair[1]))
        except DeviceError as error:
            self._refuse(error.notice)
            return None
        why = self._misfit(pair)
        self.unfit = UnfitImages(pair, why) if why is not None else None
        if why is not None:
            self._report("link", why)
            return None
        return self._frame(pair)

    def drain_events(self) -> Sequence[Event]:
        """The events since the last call, oldest first."""
        out = list(self._events)
        self._events.clear()
        return out

    def close(self) -> None:
        """Frees the device; reads return nothing afterwards."""
        self._source.close()
        self._open, self._ended, self.unfit = False, True, None

    # ---- the device

    def _ready(self, timeout: float) -> bool:
        if self._open:
            return True
        if self._ended or self._clock() < self._next_attempt:
            self._sleep(timeout)
            return False
        try:
            self._source.open()
        except DeviceError as error:
            self._refuse(error.notice)
            return False
        self._open = True
        self._restart_watch()
        self._report("link", notice("camera.connected", camera=self._source.name))
        if isinstance(self._source, HasShortfalls):
            for what in self._source.shortfalls():
                self._report(what.code, what)
        return True

    def _due(self, timeout: float) -> bool:
        """Delays reads of a file to its frame rate; a device paces itself."""
        if self._source.live or self._source.fps <= 0:
            return True
        now = self._clock()
        due = now if self._next_due is None else self._next_due
        if due > now:
            self._sleep(min(due - now, timeout))
            if due - now > timeout:
                return False
        self._next_due = due + 1 / self._source.fps
        return True

    def _is_disconnected(self) -> None:
        if self._source.live:
            self._refuse(warning("camera.silent", camera=self._source.name))
        else:
            self.close()
            self._report("link", notice("camera.file_end", camera=self._source.name))

    def _refuse(self, why: Notice) -> None:
        self._source.close()
        self._open, self.unfit = False, None
        self._ended = not self._source.live  # a file is not reopened
        self._next_attempt = self._clock() + self._params.retry
        self._report("link", why)

    def _misfit(self, pair: Pair) -> Notice | None:
        """Why the rig does not match these images; None if it does."""
        if self.rig is None:
            return None
        if (pair[1] is None) != self.rig.one_camera:
            return warning("camera.one_for_two" if pair[1] is None else "camera.two_for_one")
        for image, camera, side in zip(pair, (self.rig.left, self.rig.right), EYES, strict=True):
            if image is None:
                continue
            height, width = image.shape[:2]
            if (width, height) != (camera.width, camera.height):
                sizes = {
                    "width": width,
                    "height": height,
                    "calibrated_width": camera.width,
                    "calibrated_height": camera.height,
                }
                if self.rig.one_camera:
                    return warning("camera.size_misfit", **sizes)
                return warning("camera.side_size_misfit", side=side, **sizes)
        return None

    # ---- the images

    def _frame(self, pair: Pair) -> StereoFrame | None:
        arrival = self._clock()
        stamp = self._source.stamp() if isinstance(self._source, HasStamps) else math.nan
        at_once = self._steady.arrival(arrival, stamp)
        self._count_missed(arrival)
        self._arrivals.append(arrival)
        self._watch_rate()
        sides = [self._judge(k, image, arrival) for k, image in enumerate(pair)]
        if self._source.live and any(w.repeated and not w.black for w in self._watch):
            self.repeated += 1
            return None
        left, right = sides
        if left is None and right is None:
            return None
        self._index += 1
        t = seconds(nanoseconds(at_once - self._params.delay))
        return StereoFrame(t, arrival, left, right, index=self._index - 1)

    def _count_missed(self, arrival: float) -> None:
        """A gap of less than two and a half intervals may be jitter of the system."""
        if self._arrivals and self._source.live and self._source.fps > 0:
            intervals = (arrival - self._arrivals[-1]) * self._source.fps
            self.missed += round(intervals) - 1 if intervals > 2.5 else 0

    def _judge(self, k: int, image: Image | None, t: float) -> Image | None:
        """The image; None if it is black or missing."""
        if image is None:
            return None
        watch = self._watch[k]
        watch.look(image, t)
        if watch.black:
            self._report(EYES[k], warning("camera.black", side=EYES[k]))
        elif watch.frozen and self._source.live:
            self._report(EYES[k], warning("camera.frozen", side=EYES[k]))
        elif watch.torn:
            self._report(EYES[k], warning("camera.torn", side=EYES[k]))
        elif EYES[k] in self._reported and not watch.repeated:
            del self._reported[EYES[k]]
            self._add(notice("camera.image_back", side=EYES[k]))
        return None if watch.black else image

    def _watch_rate(self) -> None:
        requested = self._source.fps
        full = len(self._arrivals) == self._arrivals.maxlen
        if full and self._source.live and 0 < self.fps < self._params.slow * requested:
            slow = warning("camera.slow", rate_hz=round(self.fps), asked_hz=round(requested))
            self._report("rate", slow)

    def _report(self, topic: str, what: Notice) -> None:
        """Add an event once, until another notice on the same topic."""
        if self._reported.get(topic) != what:
            self._reported[topic] = what
            self._add(what)

    def _add(self, what: Notice) -> None:
        self._events.append(Event.of(self._clock(), "device", what))


def in_colour(image: Image) -> Image:
    """An image (h, w, 3), of an infrared camera (h, w) too: grey, so that it has no colours."""
    if image.ndim == 3:
        return image
    return np.repeat(image[..., None], 3, axis=2)
