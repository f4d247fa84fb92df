"""Vicon Nexus' ASCII export: the section Trajectories, and Events."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np

from extensions.reference.recording import (
    ReferencePulse,
    ReferenceRecording,
    metres,
    number,
    numbers,
    triples,
)
from tracker.base.errors import FileError
from tracker.base.notices import notice

_SECTIONS = ("Trajectories", "Events", "Devices", "Model Outputs", "Joints", "Segments")


def read_vicon(path: Path, lines: list[str]) -> ReferenceRecording:
    """Times count from frame 1, as those of events do. Raises FileError."""
    sections = _sections(lines)
    rows = sections.get("Trajectories", [])
    if len(rows) < 6:
        raise FileError(notice("reference.empty", file=path))
    rate = number(rows[1][0])
    if not rate > 0:
        raise FileError(notice("reference.no_rate", file=path))
    columns = {name.strip(): i for i, name in enumerate(rows[2]) if name.strip()}
    unit = next((c for c in rows[4][2:] if c.strip()), "mm")
    body = [r for r in rows[5:] if r and np.isfinite(number(r[0]))]
    table = numbers(body, max([2, *(c + 3 for c in columns.values())]))
    points = triples(table, list(columns.values())) * metres(unit, path)
    t = (table[:, 0] - 1) / rate
    pulses = tuple(
        ReferencePulse(number(r[3]), r[2].strip())
        for r in sections.get("Events", [])[3:]
        if len(r) > 3 and np.isfinite(number(r[3]))
    )
    return ReferenceRecording("Vicon CSV", tuple(columns), t, points, pulses=pulses).checked(path)


def _sections(lines: list[str]) -> dict[str, list[list[str]]]:
    """Rows of each section by its title."""
    delimiter = "\t" if sum("\t" in line for line in lines[:10]) > 2 else ","
    out: dict[str, list[list[str]]] = {}
    title = ""
    for row in csv.reader(lines, delimiter=delimiter):
        if row and row[0].strip() in _SECTIONS and not any(c.strip() for c in row[1:]):
            title = row[0].strip()
        if title and any(c.strip() for c in row):
            out.setdefault(title, []).append(row)
    return out
