"""Reading a reference file of any known format, which its content decides."""

from __future__ import annotations

from pathlib import Path

from extensions.reference.formats.c3d import read_c3d
from extensions.reference.formats.optitrack import read_optitrack
from extensions.reference.formats.qualisys import read_qualisys
from extensions.reference.formats.table import read_table
from extensions.reference.formats.vicon import read_vicon
from extensions.reference.mapping import PointMapping
from extensions.reference.recording import (
    UNITS,
    ReferenceRecording,
    metres,
    number,
    numbers,
    triples,
)
from tracker.base.errors import FileError
from tracker.base.files import read_bounded
from tracker.base.notices import notice
from tracker.simulation.recorded.bvh import joint_positions

MOST_BYTES = 2_000_000_000
_MILLIMETRE = UNITS["mm"]


def read_reference(
    path: Path, mapping: PointMapping | None = None, pulse: str = ""
) -> ReferenceRecording:
    """Raises FileError if the file is unreadable, empty or of an unknown format.

    ``pulse`` names an analogue channel of C3D files whose rising edges are events.
    """
    mapping = mapping or PointMapping()
    if path.suffix.lower() == ".c3d":
        return read_c3d(path, pulse)
    lines = read_lines(path)
    if mapping.table is not None:
        return read_table(path, lines, mapping.table, mapping.unit or _MILLIMETRE)
    first = next((line.strip() for line in lines if line.strip()), "")
    if first.startswith("HIERARCHY"):
        return read_bvh(path, lines, mapping.unit or CENTIMETRE)
    if first.startswith("PathFileType"):
        return read_trc(path, lines)
    if first.startswith("NO_OF_FRAMES") or "\nMARKER_NAMES" in "\n".join(lines[:40]):
        return read_qualisys(path, lines)
    if first.startswith("Format Version"):
        return read_optitrack(path, lines)
    if any(line.strip().strip(",\t") == "Trajectories" for line in lines):
        return read_vicon(path, lines)
    raise FileError(notice("reference.unknown_format", file=path))


def read_lines(path: Path) -> list[str]:
    """The lines of a text file, in UTF-8 or a code page of Windows. Raises FileError."""
    try:
        data = read_bounded(path, MOST_BYTES, "a reference recording")
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
    for coding in ("utf-8-sig", "cp1252"):
        try:
            return data.decode(coding).splitlines()
        except UnicodeDecodeError:
            continue
    return data.decode("latin-1").splitlines()


CENTIMETRE = 0.01  # m: BVH does not name its unit; most programs write centimetres


def read_bvh(path: Path, lines: list[str], unit: float = CENTIMETRE) -> ReferenceRecording:
    """``unit`` in m. An end site has the name of its joint with ``.end``. Raises FileError."""
    try:
        joints, t, positions = joint_positions("\n".join(lines))
    except (ValueError, IndexError, StopIteration) as error:
        raise FileError(notice("reference.not_readable", file=path, why=str(error))) from error
    return ReferenceRecording("BVH", tuple(j.name for j in joints), t, positions * unit).checked(
        path
    )


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
