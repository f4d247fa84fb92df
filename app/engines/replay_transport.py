"""Where a replay stands and what the user asked of it: play, seek, step, range, loop, speed."""

from __future__ import annotations

import threading
import time

IDLE_S = 0.03


class Transport:
    """Asked by the window's thread, obeyed by the replay's own; times are s from the file's start.

    Between the two stand plain attributes, each written by one side as a whole.
    """

    def __init__(self, duration: float) -> None:
        self.duration = duration
        self._stopping = threading.Event()
        self._seek_to: float | None = 0.0
        self._playing, self._speed, self._position = True, 1.0, 0.0
        self._loop, self._range = False, (0.0, duration)
        self._images_due = 0  # that a paused replay goes on to show
        self._steps_back = 0

    # --- the window's side

    @property
    def position(self) -> float:
        return self._position

    @property
    def playing(self) -> bool:
        return self._playing

    @property
    def range(self) -> tuple[float, float]:
        """The in and the out point, s."""
        return self._range

    def seek(self, position: float) -> None:
        self._seek_to = self._clamped(position)

    def play(self, on: bool) -> None:
        start, stop = self._range
        if on and not start <= self._position < stop - 1e-3:
            self.seek(start)
        self._playing = on

    def set_speed(self, speed: float) -> None:
        self._speed = speed

    def set_loop(self, on: bool) -> None:
        self._loop = on

    def set_range(self, start: float, stop: float) -> None:
        """Play from ``start`` to ``stop`` s only."""
        start, stop = sorted((self._clamped(start), self._clamped(stop)))
        self._range = (start, stop)

    def _clamped(self, position: float) -> float:
        return min(max(position, 0.0), self.duration)

    def step(self, images: int) -> None:
        """Stop, and go that many images on, or back where negative."""
        self._playing = False
        if images > 0:
            self._images_due += images
        else:
            self._steps_back -= images

    # --- the replay's side

    def _sent_elsewhere(self) -> bool:
        return self._stopping.is_set() or self._steps_back > 0 or self._seek_to is not None

    def _wait_for(self, position: float) -> bool:
        """Sleep until ``position`` is due; False when stopped or sent elsewhere."""
        while not self._sent_elsewhere():
            if not self._playing and self._images_due > 0:
                self._position = max(self._position, position)
                return True  # a paused replay shows the image it was sent to
            if self._playing and self._position >= self._range[1]:
                self._ended(self._range[1])
                continue
            ahead = position - self._position
            if ahead <= 0:
                return True
            before = time.monotonic()
            self._stopping.wait(min(IDLE_S, ahead / self._speed))
            if self._playing:
                passed = (time.monotonic() - before) * self._speed
                self._position = min(position, self._position + passed)
        return False

    def _ended(self, position: float) -> None:
        """The out point or the file's end: around again, or stop there."""
        self._position = position
        if self._loop and self._playing:
            self.seek(self._range[0])
        else:
            self._playing = False
