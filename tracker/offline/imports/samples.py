"""Samples of IMUs from other programs' files."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array, IntArray

SINCE_1970 = 3e8
"""s: a time beyond this (July 1979) is of the calendar, one before of a clock of the device."""
LATEST = 4e9
"""s since 1970: a time beyond this (2096) is damage. The file format ends at 9.2e9."""
LONGEST = 1e7
"""s between the middle sample of a file and another: 115 days. Beyond it a time is damage."""
MOST = 20_000_000
"""Samples of one file: 55 hours at 100 Hz."""
GRAVITY = 9.80665  # m/s²
PLAUSIBLE = (0.7, 1.4)
"""Share of gravity that the median acceleration has where people move."""


class Clocks(NamedTuple):
    """Clocks in a file of ours besides `Samples.t`: (N,) s of arrival, (N,) s of the glove's own
    clock, NaN where unknown, and numbers of packets (N,), -1 where unknown."""

    arrival: Array
    device: Array
    seq: IntArray


@dataclass(frozen=True, eq=False)
class ImportedSamples:
    """For one file: names (n), t (N,) s, accel m/s² and gyro rad/s (N, n, 3), NaN where missing.

    ``began_ns`` is the instant of t = 0, ns since 1970, if the file contains it.
    """

    names: tuple[str, ...]
    t: Array
    accel: Array
    gyro: Array
    began_ns: int | None = None
    clocks: Clocks | None = None

    @property
    def rate(self) -> float:
        """Samples per second: the inverse of the median step; NaN of fewer than two."""
        return 1.0 / float(np.median(np.diff(self.t))) if len(self.t) > 1 else float("nan")

    def rows(self, rows: IntArray) -> ImportedSamples:
        """Some of the samples."""
        c = self.clocks
        clocks = None if c is None else Clocks(c.arrival[rows], c.device[rows], c.seq[rows])
        return replace(
            self, t=self.t[rows], accel=self.accel[rows], gyro=self.gyro[rows], clocks=clocks
        )


def in_order(samples: ImportedSamples, name: str) -> tuple[ImportedSamples, int]:
    """Rising in time, and how many samples had to go for it. FileError without two."""
    known = np.flatnonzero(np.isfinite(samples.t) & (np.abs(samples.t) < LATEST))
    if len(known):
        known = known[np.abs(samples.t[known] - np.median(samples.t[known])) < LONGEST]
    rows = known[np.argsort(samples.t[known], kind="stable")]
    rising = np.diff(samples.t[rows], prepend=-np.inf) > 0
    if rising.sum() < 2:
        raise FileError(notice("import.no_times", file=name))
    return samples.rows(rows[rising]), len(samples.t) - int(rising.sum())


def doubts(samples: ImportedSamples, wanted: set[str]) -> list[str]:
    """Sentences on the IMUs ``wanted`` whose numbers can hardly be m/s²."""
    out = []
    for k, name in enumerate(samples.names):
        if name not in wanted:
            continue
        size = np.linalg.norm(samples.accel[:, k], axis=1)
        known = size[np.isfinite(size)]
        if len(known) == 0:
            out.append(f"{name} has no acceleration.")
            continue
        median = float(np.median(known))
        if not PLAUSIBLE[0] <= median / GRAVITY <= PLAUSIBLE[1]:
            out.append(
                f"{name} feels {median:.3g} m/s² where {GRAVITY:.2f} are usual: its unit or its "
                "range may be another one."
            )
    return out
