"""Records the images of a light that a glove blinks, or of a screen that flashes for it."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

import cv2
import numpy as np

from extensions.loopback.light import DelayedLight, find_light, no_light
from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, notice
from tracker.messages import Array, ImuSample, StereoFrame

CELL = 16  # px, of the grid in which the light is searched
ON = 0.12  # s, less than the shortest pause
PAUSE = 0.2, 0.5  # s between pulses
SETTLE = 1.0  # s of images before the first pulse
FULL = 255
WAIT = 0.2  # s for an image


TAP = 20.0
"""m/s², change of a specific force from one packet to the next. A hand that shakes 3 times a second
with 3 g changes it by 6."""
APART = 0.35  # s between taps; a tap rebounds, and the flash must have ended
PACKET_WAIT = 0.005  # s


class Glove(Protocol):
    """A glove whose motor outputs can be switched."""

    def poll(self, timeout: float) -> Sequence[object]: ...

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> bool: ...


class TimedCamera(Protocol):
    def read(self, timeout: float) -> StereoFrame | None: ...


class Pulses(Protocol):
    """Lights something up at irregular times, in threads of its own."""

    def nothing(self) -> Notice:
        """There were no pulses."""
        ...

    def unseen(self, correlation: float) -> Notice:
        """No light follows them."""
        ...

    def start(self) -> None: ...

    def stop(self) -> Array:
        """(P, 2) s: begin and end of each pulse."""
        ...


class LoopBack(NamedTuple):
    """A measurement. ``light``: its delay is that from the pulses to the light, by the images'
    times; arrival (N,) s: from exposure to arrival of each image; place (2,) px of the light."""

    light: DelayedLight
    arrival: Array
    place: tuple[int, int]
    pulses: int
    images: int


class CommandedPulses:
    """Pulses of a motor output, the same ones in each measurement."""

    def __init__(
        self, glove: Glove, channel: int = 0, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._glove, self._channel, self._clock = glove, channel, clock
        self._sent: list[float] = []
        self._ended = threading.Event()
        names = {"loop-back pulses": self._blink, "loop-back glove": self._poll}
        self._threads = [threading.Thread(target=f, name=n, daemon=True) for n, f in names.items()]

    def nothing(self) -> Notice:
        return notice("loopback.no_commands")

    def unseen(self, correlation: float) -> Notice:
        return no_light(correlation)

    def start(self) -> None:
        for thread in self._threads:
            thread.start()

    def stop(self) -> Array:
        """(P, 2) s: begin and end of each pulse, as commanded."""
        self._ended.set()
        for thread in self._threads:
            thread.join()
        begins = np.array(self._sent)
        return np.column_stack([begins, begins + ON])

    def _blink(self) -> None:
        rng = np.random.default_rng(1)
        self._ended.wait(SETTLE)
        while not self._ended.wait(ON + rng.uniform(*PAUSE)):
            now = self._clock()
            if self._glove.vibrate(self._channel, FULL, round(1000 * ON)):
                self._sent.append(now)

    def _poll(self) -> None:
        while not self._ended.is_set():
            self._glove.poll(0.05)


class SensingGlove(Protocol):
    """A glove that sends packets."""

    def poll(self, timeout: float) -> Sequence[object]: ...


class Taps:
    """Pulses of a screen: it is lit for `ON` as soon as the packet of a tap has arrived.

    A pulse begins at the sampling instant of that packet, which is later than the tap by at most
    the interval of the packets. ``screen`` is called in another thread, with whether it is lit.
    """

    def __init__(
        self,
        glove: SensingGlove,
        screen: Callable[[bool], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._glove, self._screen, self._clock = glove, screen, clock
        self._force: Array | None = None  # (n, 3) m/s² of the packet before
        self._pulses: list[tuple[float, float]] = []  # s
        self._lit: tuple[float, float] | None = None  # s, when it was tapped and when it was lit
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._watch, name="loop-back taps", daemon=True)

    def nothing(self) -> Notice:
        if self._force is None:
            return notice("loopback.no_packets")
        return notice("loopback.no_taps")

    def unseen(self, correlation: float) -> Notice:
        return notice("loopback.no_screen", correlation=correlation)

    def start(self) -> None:
        self._thread.start()

    def stop(self) -> Array:
        """(P, 2) s: begin and end of each pulse."""
        self._ended.set()
        self._thread.join()
        return np.array(self._pulses).reshape(-1, 2)

    def _watch(self) -> None:
        while not self._ended.is_set():
            for item in self._glove.poll(PACKET_WAIT):
                if isinstance(item, ImuSample):
                    self._feel(item)
            if self._lit is not None and self._clock() >= self._lit[1] + ON:
                self._darken(*self._lit)

    def _feel(self, sample: ImuSample) -> None:
        before, self._force = self._force, sample.accel
        last = self._pulses[-1][0] if self._pulses else -np.inf
        if self._lit is not None or before is None or sample.t < last + APART:
            return
        if (np.linalg.norm(sample.accel - before, axis=1) > TAP).any():  # NaN: did not answer
            self._lit = sample.t, self._clock()
            self._screen(True)

    def _darken(self, tapped: float, lit: float) -> None:
        """The pulse ends by what the screen was lit for, so that both edges have one delay."""
        now, self._lit = self._clock(), None
        self._screen(False)
        self._pulses.append((tapped, tapped + now - lit))


def measure(
    pulses: Pulses,
    camera: TimedCamera,
    seconds: float,
    is_ended: Callable[[], bool] = lambda: False,
    clock: Callable[[], float] = time.monotonic,
) -> LoopBack:
    """Lets ``pulses`` light up for ``seconds``, or until ``is_ended``, and finds the light in the
    left images.

    Raises DeviceError without images, without pulses, and without a light that follows them.
    """
    times, arrival, cells, shape = [], [], [], (0, 0)
    pulses.start()
    end = clock() + seconds
    try:
        while clock() < end and not is_ended():
            frame = camera.read(WAIT)
            if frame is not None and frame.left is not None:
                grid = brightness(frame.left)
                times.append(frame.t)
                arrival.append(frame.t_arrival - frame.t)
                cells.append(grid.ravel())
                shape = grid.shape
    finally:
        sent = pulses.stop()
    if not cells:
        raise DeviceError(notice("loopback.no_images"))
    if not len(sent):
        raise DeviceError(pulses.nothing())
    light = find_light(np.array(times), np.array(cells), sent, pulses.unseen)
    row, column = divmod(light.cell, shape[1])
    place = CELL * column + CELL // 2, CELL * row + CELL // 2
    return LoopBack(light, np.array(arrival), place, len(sent), len(times))


def brightness(image: np.ndarray) -> Array:
    """(rows, columns): mean of the brightest channel of each cell of an image (h, w, 3)."""
    rows, columns = image.shape[0] // CELL, image.shape[1] // CELL
    brightest = image[: rows * CELL, : columns * CELL].max(axis=2)
    small = cv2.resize(brightest, (columns, rows), interpolation=cv2.INTER_AREA)
    return np.asarray(small, dtype=np.float32)
