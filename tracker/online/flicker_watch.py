"""Recognises lamps that flicker at twice the mains frequency, from the brightness of images.

The brightness of a row is followed by the ratio of each image to the one before, averaged over
pixels without those that differ from the others: a hand covers few of a row's pixels. In images at
a constant rate, a flicker of 100 or 120 Hz appears at its difference from the nearest multiple of
that rate, in all rows, with a phase that depends on the row where the shutter is rolling. A peak
at that frequency, far above the rest of the spectrum and in successive windows, is a lamp. Where
the difference is near 0, bands stand still in images: they do not change markers' colours, and
cannot be distinguished from the room.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import Outbox, notice, warning
from tracker.messages import Array, IntArray

MAINS_HZ = (50.0, 60.0)
GREEN = 1  # channel of an image
DARKEST, BRIGHTEST = 16, 240  # levels between which ratios of pixels are meaningful


@dataclass(frozen=True)
class FlickerWatchParams:
    """Frequencies in Hz; brightness relative to its mean, in values of pixels."""

    row_step: int = 16  # every 16th row and
    column_step: int = 32  # every 32nd column is used
    window: float = 2.2  # s of images whose spectrum is computed
    windows: int = 2  # in a row, before flicker is reported or its end
    usual: float = 0.03  # of the ratio, by which pixels of a row differ from their median
    pixels: int = 8  # of a row, at least
    rows: int = 8  # of an image, at least
    slowest: float = 3.0  # of the beat: below are hands, clouds and automatic exposure
    near: float = 0.7  # from the expected beat: mains, camera clock and resolution
    apart: float = 1.5  # from the peak, beyond which the rest of the spectrum begins
    clear: float = 12.0  # power of the peak relative to the median of the rest
    worth: float = 0.02  # amplitude from which on it is reported
    gap: float = 2.5  # periods between two images, after which it starts over


@dataclass(frozen=True)
class LampFlicker:
    """Lamps at mains of ``mains_hz``, by which images vary with the relative ``amplitude``."""

    mains_hz: float
    amplitude: float


class FlickerWatch:
    """Takes the images of one camera in order."""

    def __init__(self, params: FlickerWatchParams | None = None) -> None:
        self._params = params or FlickerWatchParams()
        self._found: list[LampFlicker | None] = []
        self._begin()
        self.flicker: LampFlicker | None = None
        """What was reported and has not ended."""
        self.notices = Outbox()

    def _begin(self) -> None:
        """A new window."""
        self._before = np.zeros((0, 0), np.float32)
        self._t: list[float] = []
        self._number: list[int] = []  # exposures since the first image
        self._index = -1
        self._ratios: list[Array] = []

    def look(self, image: NDArray[np.uint8], t: float, index: int = -1) -> None:
        """The next image (h, w, 3) with its stamp (s), and its number if the camera counts."""
        p = self._params
        now = image[:: p.row_step, :: p.column_step, GREEN].astype(np.float32)
        steps = self._steps(t, index)
        if steps == 0 or now.shape != self._before.shape:
            self._begin()
            self._number.append(0)
        else:
            self._ratios.append(_ratio(self._before, now, p) / steps)
            self._number.append(self._number[-1] + steps)
        self._t.append(t)
        self._index, self._before = index, now
        if t - self._t[0] >= p.window:
            self._judge(_lamp(np.array(self._t), np.array(self._number), self._ratios, p))
            self._begin()

    def _steps(self, t: float, index: int) -> int:
        """The exposures since the last image; 0 if their number is unknown."""
        if not self._t or t <= self._t[-1]:
            return 0
        if len(self._t) > 1:
            period = (self._t[-1] - self._t[0]) / self._number[-1]
            if t - self._t[-1] > self._params.gap * period:
                return 0
        return max(index - self._index, 1) if index >= 0 else 1

    def _judge(self, found: LampFlicker | None) -> None:
        """Report flicker, or its end, after several windows in a row."""
        p = self._params
        self._found = [*self._found, found][-p.windows :]
        seen = [f for f in self._found if f is not None]
        same = len({f.mains_hz for f in seen}) == 1
        if self.flicker is None and len(seen) == p.windows and same:
            self.flicker = seen[-1]
            mains_hz = round(seen[-1].mains_hz)
            self.notices.post(
                warning(
                    "camera.lamps_flicker",
                    mains_hz=mains_hz,
                    lamp_hz=2 * mains_hz,
                    percent=100 * seen[-1].amplitude,
                )
            )
        elif self.flicker is not None and not seen and len(self._found) == p.windows:
            self.flicker = None
            self.notices.post(notice("camera.lamps_steady"))


def _ratio(before: NDArray[np.float32], now: NDArray[np.float32], p: FlickerWatchParams) -> Array:
    """(h,) logarithm of the ratio of brightness of each row (h, w); NaN where few pixels show it.

    Pixels of a moving hand differ from the median of their row and count little. A mean, unlike the
    median, is finer than a level of the pixels.
    """
    usable = (before > DARKEST) & (before < BRIGHTEST) & (now > DARKEST) & (now < BRIGHTEST)
    ratio = np.log(np.where(usable, now, 1.0) / np.where(usable, before, 1.0))
    middle = np.median(ratio, axis=1, keepdims=True)  # unusable pixels count as unchanged
    near = np.clip(ratio, middle - p.usual, middle + p.usual)
    count = np.count_nonzero(usable, axis=1)
    total = np.where(usable, near, 0.0).sum(axis=1)
    out: Array = np.where(count >= p.pixels, total / np.maximum(count, 1), np.nan)
    return out


def _lamp(
    t: Array, number: IntArray, ratios: Sequence[Array], p: FlickerWatchParams
) -> LampFlicker | None:
    """The lamp in a window of images at ``t`` (n,) s, the exposures ``number`` (n,) of a constant
    rate, by the ratios (n - 1 times (h,)) of successive images."""
    rate = number[-1] / (t[-1] - t[0])
    seen = np.array(ratios)
    seen = seen[:, np.isfinite(seen).all(axis=0)]
    if seen.shape[1] < p.rows:
        return None
    seen = (seen - seen.mean(axis=0)) * np.hanning(len(seen))[:, None]
    hz = np.arange(p.slowest, rate / 2, 0.1)
    turn = np.exp(-2j * np.pi * np.outer(hz / rate, number[1:]))
    of_step = 2.0 * np.sin(np.pi * hz / rate)  # a ratio of neighbours amplifies fast changes
    amplitude = np.abs(turn @ seen) * (4.0 / len(seen)) / of_step[:, None]  # of Hann's window
    power = np.mean(amplitude**2, axis=1)
    found = [_peak(hz, power, _beat(2 * mains, rate), p) for mains in MAINS_HZ]
    best = int(np.argmax(found))
    return LampFlicker(MAINS_HZ[best], float(np.sqrt(found[best]))) if found[best] > 0 else None


def _beat(lamp_hz: float, rate: float) -> float:
    """Hz at which a lamp appears in images of that rate."""
    return abs(lamp_hz - rate * round(lamp_hz / rate))


def _peak(hz: Array, power: Array, beat: float, p: FlickerWatchParams) -> float:
    """Power of the peak near a beat; 0 where none stands out."""
    near = np.abs(hz - beat) <= p.near
    if not near.any():
        return 0.0
    k = int(np.flatnonzero(near)[np.argmax(power[near])])
    rest = power[np.abs(hz - hz[k]) > p.apart]
    is_clear = power[k] > p.clear * np.median(rest) and power[k] >= rest.max()
    return float(power[k]) if is_clear and power[k] > p.worth**2 else 0.0
