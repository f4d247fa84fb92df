"""Flashes a screen at each tap that a glove feels."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np

from extensions.loopback.measure import ON
from tracker.messages import Array, ImuSample

TAP = 20.0
"""m/s², change of a specific force from one packet to the next. A hand that shakes 3 times a second
with 3 g changes it by 6."""
APART = 0.35  # s between taps; a tap rebounds, and the flash must have ended
WAIT = 0.005  # s for packets


class SensingGlove(Protocol):
    """A glove that sends packets."""

    def poll(self, timeout: float) -> Sequence[object]: ...


class Taps:
    """Pulses of a screen: it is lit for `ON` as soon as the packet of a tap has arrived.

    A pulse begins at the sampling instant of that packet, which is later than the tap by at most
    the interval of the packets. ``screen`` is called in another thread, with whether it is lit.
    """

    nothing, unseen = "loopback.no_taps", "loopback.no_screen"

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

    def start(self) -> None:
        self._thread.start()

    def stop(self) -> Array:
        """(P, 2) s: begin and end of each pulse."""
        self._ended.set()
        self._thread.join()
        return np.array(self._pulses).reshape(-1, 2)

    def _watch(self) -> None:
        while not self._ended.is_set():
            for item in self._glove.poll(WAIT):
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
