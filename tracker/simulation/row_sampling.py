"""Points of a moving scene when the rows that show them are exposed, one row after the other."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.messages import Array, IntArray
from tracker.vision.rig import Camera, StereoRig

STEP = 2.5e-3  # s between instants, between which pixels move in straight lines to 0.03 mm
MARGIN = 2e-3  # s that a point may move on in rows while the hand's rows are exposed
LEAST_ROWS = 16  # of a band of an image: blocks of JPEG lie whole in one
BAND_PX = (
    0.7  # by default, by which a hand moves at most while a band is exposed, if that is tall enough
)

BLURRED = 3  # exposures of an image with motion blur


class RowBand(NamedTuple):
    """Rows from ``first`` to before ``end`` of an image, drawn as of ``delay`` s later."""

    first: int
    end: int
    delay: float


def row_delay(rig: StereoRig, camera: Camera, row: Array) -> Array:
    """(…) s by which rows (…) px of one of the rig's images are exposed after its middle row."""
    per_row = rig.line_time * rig.left.height / camera.height
    out: Array = (row - (camera.height - 1) / 2) * per_row
    return out


def instants_for(rig: StereoRig, camera: Camera, row: Array) -> Array:
    """(k,) s after the middle row's exposure: instants between which points are sampled whose rows
    (n,) px are these at the middle one; NaN of points that are not seen."""
    rows = np.clip(row[np.isfinite(row)], 0, camera.height - 1)
    if len(rows) == 0:
        return np.array([-MARGIN, MARGIN])
    delay = row_delay(rig, camera, rows)
    low, high = 1.1 * float(delay.min()) - MARGIN, 1.1 * float(delay.max()) + MARGIN
    return np.linspace(low, high, int(np.ceil((high - low) / STEP)) + 1)


class OwnRow(NamedTuple):
    """The instants that n points are between: ``before`` (n,), and ``weight`` (n,) of the next."""

    before: IntArray
    weight: Array

    @staticmethod
    def of(instants: Array, delay: Array) -> OwnRow:
        """Where the instants (k,) s meet the ``delay`` (k, n) s of the points' rows at them."""
        ahead = instants[:, None] - np.nan_to_num(delay)
        passed = np.count_nonzero(ahead <= 0, axis=0) - 1
        before = np.clip(passed, 0, len(instants) - 2)
        every = np.arange(delay.shape[1])
        a, b = ahead[before, every], ahead[before + 1, every]
        return OwnRow(before, np.clip(-a / (b - a), 0.0, 1.0))

    def of_values(self, values: Array) -> Array:
        """(n, …) of values (k, n, …) at the instants."""
        every = np.arange(len(self.before))
        a, b = values[self.before, every], values[self.before + 1, every]
        weight = self.weight.reshape(-1, *[1] * (values.ndim - 2))
        out: Array = (1 - weight) * a + weight * b
        return out


def band_px(exposures: int) -> float:
    """px by which a hand may move in a band: more with fewer ``exposures`` per image, between which
    it moves too."""
    return BAND_PX * BLURRED / max(min(exposures, BLURRED), 1)


def bands_of(
    rig: StereoRig,
    camera: Camera,
    speed: float,
    rows: tuple[int, int] | None = None,
    most_px: float = BAND_PX,
) -> list[RowBand]:
    """Bands of all rows, in which a hand of ``speed`` px/s moves less than ``most_px`` or which are
    `LEAST_ROWS` rows; the hand is in ``rows`` (default: all). Above and below these, the bands
    extend to the image's edges."""
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
