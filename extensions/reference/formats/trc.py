"""TRC, the marker trajectories of OpenSim and Cortex."""

from __future__ import annotations

from pathlib import Path

from extensions.reference.recording import ReferenceRecording, metres, number, numbers, triples
from tracker.base.errors import FileError
from tracker.base.notices import notice


def read_trc(path: Path, lines: list[str]) -> ReferenceRecording:
    """``lines`` of the file. Raises FileError."""
    cells = [line.rstrip("\r\n").split("\t") for line in lines[:6]]
    if len(cells) < 6 or not cells[0][0].startswith("PathFileType"):
        raise FileError(notice("reference.not_readable", file=path, why="it is not a TRC file"))
    header = dict(zip(cells[1], cells[2], strict=False))
    columns = {name.strip(): i for i, name in enumerate(cells[3][2:], 2) if name.strip()}
    rows = [line.split("\t") for line in lines[5:] if line.strip()]
    rows = [[c.strip() for c in row] for row in rows if number(row[0]) == number(row[0])]
    table = numbers(rows, max([2, *(c + 3 for c in columns.values())]))
    scale = metres(header.get("Units", "mm"), path)
    points = triples(table, list(columns.values())) * scale
    return ReferenceRecording("TRC", tuple(columns), table[:, 1], points).checked(path)
