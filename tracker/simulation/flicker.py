"""Lamps at the mains: their light flickers at twice its frequency, which images show as bands."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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
    """``shutter`` s that each row is exposed for; the middles of the first and the last row are
    ``readout`` s apart."""

    shutter: float
    readout: float


def flicker(
    images: Sequence[NDArray[np.uint8]], t: float, exposure: Exposure, params: FlickerParams
) -> list[NDArray[np.uint8]]:
    """Images (h, w, 3) of the exposure with midpoint t (s) under such lamps."""
    if params.depth == 0.0:
        return list(images)
    out = []
    for image in images:
        gain = row_gains(len(image), t, exposure, params).astype(np.float32)
        bright = image * gain[:, None, None]
        out.append(np.minimum(bright + 0.5, 255.0).astype(np.uint8))
    return out


def row_gains(rows: int, t: float, exposure: Exposure, params: FlickerParams) -> Array:
    """(rows,) by which the values of an image's rows are multiplied."""
    hz = 2 * params.mains_hz
    when = t + exposure.readout * np.linspace(-0.5, 0.5, rows)
    mean_of_shutter = float(np.sinc(hz * exposure.shutter))
    light = 1 + params.depth * mean_of_shutter * np.cos(2 * np.pi * hz * when + params.phase)
    gains: Array = np.maximum(light, 0.0) ** (1 / GAMMA)
    return gains
