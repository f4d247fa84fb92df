"""Qualisys Track Manager's TSV export of 3D data."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import numpy as np

from extensions.reference.recording import (
    ReferencePulse,
    ReferenceRecording,
    number,
    numbers,
    triples,
)
from tracker.base.errors import FileError
from tracker.base.notices import notice

_TIME = "%Y-%m-%d, %H:%M:%S.%f"


def read_qualisys(path: Path, lines: list[str]) -> ReferenceRecording:
    """Millimetres; a point at exactly (0, 0, 0) is missing, as Qualisys writes it.

    Raises FileError.
    """
    header: dict[str, list[str]] = {}
    events: list[list[str]] = []
    begin = len(lines)
    for i, line in enumerate(lines):
        cells = [c.strip() for c in line.rstrip("\r\n").split("\t")]
        if cells[0] and np.isfinite(number(cells[0])):
            begin = i
            break
        if cells[0] == "EVENT":
            events.append(cells[1:])
        elif cells[0]:
            header[cells[0]] = cells[1:]
    names = tuple(n for n in header.get("MARKER_NAMES", []) if n)
    rate = number((header.get("FREQUENCY") or [""])[0])
    if not names or not rate > 0:
        raise FileError(notice("reference.no_rate", file=path))
    ahead = 2 if header.get("Frame", [""])[:1] == ["Time"] else 0
    rows = [line.rstrip("\r\n").split("\t") for line in lines[begin:] if line.strip()]
    table = numbers(rows, ahead + 3 * len(names))
    points = triples(table, range(ahead, ahead + 3 * len(names), 3)) * 1e-3
    points = np.where((points == 0).all(axis=2, keepdims=True), np.nan, points)
    t = table[:, 1] if ahead else np.arange(len(table)) / rate
    pulses = tuple(ReferencePulse(number(e[2]), e[0]) for e in events if len(e) > 2)
    start = _start(header.get("TIME_STAMP", []))
    return ReferenceRecording("Qualisys TSV", names, t, points, start, pulses).checked(path)


def _start(cells: list[str]) -> datetime | None:
    """TIME_STAMP is the computer's local time of the first frame."""
    try:
        return datetime.strptime(cells[0], _TIME)
    except (IndexError, ValueError):
        return None
