"""Mains-powered lamps: their light flickers at twice the mains frequency, which causes bands in
images."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.kernels.arrays import ByteStack, Float32Vector, Written
from tracker.messages import Array

GAMMA = 2.2  # of the cameras' images


@dataclass(frozen=True)
class FlickerParams:
    """``depth`` is the relative amplitude of the light (0: daylight); a filament lamp has 0.1, an
    LED lamp without a smoothed supply 0.3 to 1."""

    depth: float = 0.0
    mains_hz: float = 50.0
    phase: float = 0.4  # rad, at t = 0


class Exposure(NamedTuple):
    """Each row is exposed for ``shutter`` s; the midpoints of the first and the last row are
    ``readout`` s apart."""

    shutter: float
    readout: float


def row_gains(rows: int, t: float, exposure: Exposure, params: FlickerParams) -> Array:
    """(rows,) factors for the values of an image's rows."""
    hz = 2 * params.mains_hz
    when = t + exposure.readout * np.linspace(-0.5, 0.5, rows)
    mean_of_shutter = float(np.sinc(hz * exposure.shutter))
    light = 1 + params.depth * mean_of_shutter * np.cos(2 * np.pi * hz * when + params.phase)
    gains: Array = np.maximum(light, 0.0) ** (1 / GAMMA)
    return gains


class Lamps:
    """The light of the images of one camera."""

    def __init__(self, exposure: Exposure, params: FlickerParams | None = None) -> None:
        self._exposure, self._params = exposure, params or FlickerParams()

    def gains(self, rows: int, t: float) -> NDArray[np.float32]:
        """(rows,) `row_gains` of the image with the midpoint t (s); 1 without flicker."""
        if self._params.depth == 0.0:
            return np.ones(rows, np.float32)
        return row_gains(rows, t, self._exposure, self._params).astype(np.float32)

    def light(
        self, image: NDArray[np.uint8], gains: NDArray[np.float32], out: NDArray[np.uint8]
    ) -> None:
        """Writes an image (h, w, 3) in this light to ``out``."""
        if self._params.depth != 0.0:
            brightened(image, gains, out)
        else:
            out[:] = image


@kernel(fastmath=True, wide=True)
def brightened(image: ByteStack, gain: Float32Vector, out: Written[ByteStack]) -> None:
    """Writes an image (h, w, 3), each row multiplied by its gain (h,), to ``out``."""
    half, top = np.float32(0.5), np.float32(255.0)
    width = image.shape[1] * image.shape[2]
    values, written = image.reshape(-1), out.reshape(-1)  # contiguous, for the compiler
    for v in range(len(gain)):
        row, into = values[v * width : (v + 1) * width], written[v * width : (v + 1) * width]
        own = gain[v]
        for k in range(width):
            into[k] = np.uint8(np.int32(min(np.float32(row[k]) * own + half, top)))
