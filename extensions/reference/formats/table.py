"""A CSV of any program, with the names of its columns in a mapping file."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np

from extensions.reference.formats.c3d import rising_edges
from extensions.reference.mapping import TableColumns
from extensions.reference.recording import ReferencePulse, ReferenceRecording, number
from tracker.base.errors import FileError
from tracker.base.notices import notice


def read_table(
    path: Path, lines: list[str], columns: TableColumns, unit: float
) -> ReferenceRecording:
    """The header is the first line that contains all the columns; ``unit`` in m.

    Raises FileError.
    """
    axes = [c for point in columns.points.values() for c in point]
    wanted = [c for c in (columns.time, columns.pulse) if c is not None] + axes
    rows = [[c.strip() for c in row] for row in csv.reader(lines, delimiter=columns.delimiter)]
    top = next((i for i, row in enumerate(rows) if set(wanted) <= set(row)), None)
    if top is None:
        nearest = max(rows, key=lambda row: len(set(wanted) & set(row)), default=[])
        missing = [c for c in wanted if c not in nearest]
        raise FileError(
            notice("reference.no_column", file=path, column=missing[0], known=tuple(nearest[:60]))
        )
    index = {name: i for i, name in reversed(list(enumerate(rows[top])))}
    body = [row for row in rows[top + 1 :] if any(row)]

    def column(name: str) -> np.ndarray:
        return np.array([number(r[index[name]]) if index[name] < len(r) else np.nan for r in body])

    t = np.arange(len(body)) / max(columns.rate, 1e-9)
    if columns.time is not None:
        t = column(columns.time) * columns.time_unit
    points = np.array([column(c) for c in axes]).T.reshape(len(body), -1, 3) * unit
    points = np.where(np.isfinite(points).all(axis=2, keepdims=True), points, np.nan)
    pulses = _pulses(column(columns.pulse), t, columns.pulse) if columns.pulse else ()
    return ReferenceRecording("CSV", tuple(columns.points), t, points, pulses=pulses).checked(path)


def _pulses(x: np.ndarray, t: np.ndarray, name: str) -> tuple[ReferencePulse, ...]:
    rows = rising_edges(x, 1.0)
    return tuple(ReferencePulse(float(np.interp(r, np.arange(len(t)), t)), name) for r in rows)
