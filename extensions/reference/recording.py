"""What a laboratory's system recorded: trajectories of named points, and events."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array

UNITS = {"m": 1.0, "meters": 1.0, "dm": 0.1, "cm": 0.01, "centimeters": 0.01, "mm": 1e-3,
         "millimeters": 1e-3, "in": 0.0254, "inches": 0.0254}  # fmt: skip
"""Metres of each unit of length that files name."""


@dataclass(frozen=True)
class ReferencePulse:
    """An event at ``t`` s on the time axis of the points."""

    t: float
    name: str


@dataclass(frozen=True, eq=False)
class ReferenceRecording:
    """N instants of P points: ``t`` (N,) s, rising; ``points`` (N, P, 3) m in the laboratory's
    frame, NaN where missing.

    ``start``: the wall clock at t = 0, None if the file does not contain it; ``kind``: the format.
    """

    kind: str
    names: tuple[str, ...]
    t: Array
    points: Array
    start: datetime | None = None
    pulses: tuple[ReferencePulse, ...] = ()

    @property
    def rate(self) -> float:
        """Median samples per second."""
        return 1.0 / float(np.median(np.diff(self.t)))

    def checked(self, path: object) -> ReferenceRecording:
        """The same in the order of its times. Raises FileError without two instants and a point."""
        known = np.isfinite(self.t)
        order = np.argsort(np.where(known, self.t, np.inf), kind="stable")[: int(known.sum())]
        t = self.t[order]
        rows = order[np.r_[True, np.diff(t) > 0]] if len(t) else order
        if len(rows) < 2 or not np.isfinite(self.points[rows]).any():
            raise FileError(notice("reference.empty", file=path))
        return replace(self, t=self.t[rows], points=self.points[rows])


def metres(unit: str, path: object) -> float:
    """Metres of a unit that a file names. Raises FileError for another word."""
    word = unit.strip().lower()
    if word not in UNITS:
        raise FileError(notice("reference.unknown_unit", file=path, unit=unit, known=tuple(UNITS)))
    return UNITS[word]


def number(cell: str) -> float:
    """A cell of a table; NaN if it is empty or not a number."""
    try:
        return float(cell)
    except ValueError:
        return float("nan")


def numbers(rows: Sequence[Sequence[str]], columns: int) -> Array:
    """(N, columns) of rows of cells; NaN where a row is short."""
    out = np.full((len(rows), columns), np.nan)
    for i, row in enumerate(rows):
        values = [number(cell) for cell in row[:columns]]
        out[i, : len(values)] = values
    return out


def triples(table: Array, first: Sequence[int]) -> Array:
    """(N, P, 3) of the columns that begin at ``first`` (P,); incomplete points are NaN."""
    columns = np.array([[c, c + 1, c + 2] for c in first], int).reshape(-1, 3)
    wide = np.pad(table, ((0, 0), (0, 3)), constant_values=np.nan)
    points = wide[:, columns]
    return np.where(np.isfinite(points).all(axis=2, keepdims=True), points, np.nan)
