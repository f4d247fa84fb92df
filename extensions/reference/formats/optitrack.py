"""OptiTrack Motive's CSV export: markers, and positions of bones and rigid bodies."""

from __future__ import annotations

import csv
from datetime import datetime
from pathlib import Path

import numpy as np

from extensions.reference.recording import ReferenceRecording, metres, number, numbers, triples
from tracker.base.errors import FileError
from tracker.base.notices import notice

_PREFERRED = ("Marker", "Bone Marker", "Rigid Body Marker", "Bone", "Rigid Body")
_TIME = "%Y-%m-%d %I.%M.%S.%f %p"
Columns = dict[str, int]


def read_optitrack(path: Path, lines: list[str]) -> ReferenceRecording:
    """``lines`` of the file. Of a marker, a bone and a rigid body of one name, the first is used.

    Raises FileError.
    """
    head = next(csv.reader(lines[:1]))
    header = dict(zip(head[::2], head[1::2], strict=False))
    rows = list(csv.reader(lines))
    top = next((i for i, r in enumerate(rows) if r[:1] == ["Frame"]), None)
    if top is None or top < 2:
        raise FileError(
            notice("reference.not_readable", file=path, why="its columns have no names")
        )
    columns = _columns(rows[:top], rows[top])
    if not columns:
        raise FileError(notice("reference.empty", file=path))
    body = [r for r in rows[top + 1 :] if r and np.isfinite(number(r[0]))]
    table = numbers(body, max(columns.values()) + 3)
    points = triples(table, list(columns.values()))
    points *= metres(header.get("Length Units", "Meters"), path)
    start = _start(header.get("Capture Start Time", ""))
    return ReferenceRecording("OptiTrack CSV", tuple(columns), table[:, 1], points, start).checked(
        path
    )


def _columns(above: list[list[str]], axes: list[str]) -> Columns:
    """First column of each point's position by name."""
    labelled = {row[1].strip(): row for row in above if len(row) > 2 and row[1].strip()}
    kinds, names = labelled.get("Type", []), labelled.get("Name", [])
    what = next((r for r in reversed(above) if "Position" in r), [])
    found: dict[str, dict[str, int]] = {}
    for c in range(2, len(axes)):
        if axes[c].strip() != "X" or c >= len(names) or c >= len(what) or what[c] != "Position":
            continue
        kind = kinds[c].strip() if c < len(kinds) else ""
        found.setdefault(names[c].strip(), {}).setdefault(kind, c)
    order = {kind: i for i, kind in enumerate(_PREFERRED)}
    return {
        name: min(of.items(), key=lambda item: order.get(item[0], len(order)))[1]
        for name, of in found.items()
    }


def _start(text: str) -> datetime | None:
    try:
        return datetime.strptime(text.strip(), _TIME)
    except ValueError:
        return None
