"""Samples points of a moving scene at the exposure of their rows, for rolling shutters."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.messages import Array, IntArray
from tracker.vision.rig import Camera, StereoRig

STEP = 2.5e-3  # s between instants; linear motion between them is accurate to 0.03 mm
MARGIN = 2e-3  # s by which a point's row may be exposed outside of the hand's rows
LEAST_ROWS = 16  # of a band of an image, so that no JPEG block is split
BAND_PX = 0.7  # default maximum motion of a hand in a band, if that has more rows than the minimum

BLURRED = 3  # exposures of an image with motion blur


class RowBand(NamedTuple):
    """Rows from ``first`` to before ``end`` of an image, drawn as of ``delay`` s later."""

    first: int
    end: int
    delay: float


def row_delay(rig: StereoRig, camera: Camera, row: Array) -> Array:
    """(…) s from the exposure of the middle row of one of the rig's images to that of the rows (…)
    px."""
    per_row = rig.line_time * rig.left.height / camera.height
    out: Array = (row - (camera.height - 1) / 2) * per_row
    return out


def instants_for(rig: StereoRig, camera: Camera, row: Array) -> Array:
    """(k,) instants, s after the middle row's exposure, to sample points whose rows are (n,) px at
    that time; NaN for points that are not visible."""
    rows = np.clip(row[np.isfinite(row)], 0, camera.height - 1)
    if len(rows) == 0:
        return np.array([-MARGIN, MARGIN])
    delay = row_delay(rig, camera, rows)
    low, high = 1.1 * float(delay.min()) - MARGIN, 1.1 * float(delay.max()) + MARGIN
    return np.linspace(low, high, int(np.ceil((high - low) / STEP)) + 1)


class OwnRow(NamedTuple):
    """The instants around each of n points: index ``before`` (n,), and ``weight`` (n,) of the next
    one."""

    before: IntArray
    weight: Array

    @staticmethod
    def of(instants: Array, delay: Array) -> OwnRow:
        """Finds the times at which the instants (k,) s equal the ``delay`` (k, n) s of the points'
        rows."""
        ahead = instants[:, None] - np.nan_to_num(delay)
        passed = np.count_nonzero(ahead <= 0, axis=0) - 1
        before = np.clip(passed, 0, len(instants) - 2)
        every = np.arange(delay.shape[1])
        a, b = ahead[before, every], ahead[before + 1, every]
        return OwnRow(before, np.clip(-a / (b - a), 0.0, 1.0))

    def of_values(self, values: Array) -> Array:
        """(n, …) interpolated from values (k, n, …) at the instants."""
        every = np.arange(len(self.before))
        a, b = values[self.before, every], values[self.before + 1, every]
        weight = self.weight.reshape(-1, *[1] * (values.ndim - 2))
        out: Array = (1 - weight) * a + weight * b
        return out


def band_px(exposures: int) -> float:
    """px by which a hand may move during a band: more with fewer ``exposures`` per image, between
    which it moves as well."""
    return BAND_PX * BLURRED / max(min(exposures, BLURRED), 1)


def bands_of(
    rig: StereoRig,
    camera: Camera,
    speed: float,
    rows: tuple[int, int] | None = None,
    most_px: float = BAND_PX,
) -> list[RowBand]:
    """Divides all rows into bands during which a hand with ``speed`` px/s moves less than
    ``most_px``, but of at least `LEAST_ROWS` rows; the hand is in ``rows`` (default: all). Above
    and below these, the bands extend to the image's edges."""
    first, end = rows or (0, camera.height)
    low, high = first // LEAST_ROWS, max(-(-end // LEAST_ROWS), first // LEAST_ROWS + 1)
    readout = rig.line_time * rig.left.height * (high - low) * LEAST_ROWS / camera.height
    count = int(np.clip(np.ceil(speed * readout / most_px), 1, high - low))
    edges = np.round(np.linspace(low, high, count + 1)).astype(int) * LEAST_ROWS
    edges[-1] = min(edges[-1], camera.height)
    middle = row_delay(rig, camera, (edges[:-1] + edges[1:] - 1) / 2)
    edges[0], edges[-1] = 0, camera.height
    return [
        RowBand(int(a), int(b), float(delay))
        for a, b, delay in zip(edges[:-1], edges[1:], middle, strict=True)
    ]
