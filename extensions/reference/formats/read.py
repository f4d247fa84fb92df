"""Reading a reference file of any known format, which its content decides."""

from __future__ import annotations

import csv
import struct
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np

from extensions.reference.mapping import PointMapping, TableColumns
from extensions.reference.recording import (
    UNITS,
    ReferencePulse,
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


# ---- a CSV of any program, with the names of its columns in a mapping file


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


# ---- vicon Nexus' ASCII export: the section Trajectories, and Events

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


# ---- qualisys Track Manager's TSV export of 3D data

_QUALISYS_TIME = "%Y-%m-%d, %H:%M:%S.%f"


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
        return datetime.strptime(cells[0], _QUALISYS_TIME)
    except (IndexError, ValueError):
        return None


# ---- optiTrack Motive's CSV export: markers, and positions of bones and rigid bodies

_PREFERRED = ("Marker", "Bone Marker", "Rigid Body Marker", "Bone", "Rigid Body")
_OPTITRACK_TIME = "%Y-%m-%d %I.%M.%S.%f %p"
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
    start = _optitrack_start(header.get("Capture Start Time", ""))
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


def _optitrack_start(text: str) -> datetime | None:
    try:
        return datetime.strptime(text.strip(), _OPTITRACK_TIME)
    except ValueError:
        return None


# ---- c3D, read by ezc3d: points, events, and edges of analogue channels

_BLOCK = 512  # bytes: the unit of positions in a C3D file
_MANY = 65535  # frames: beyond them the header does not contain the number


def read_c3d(path: Path, pulse: str = "") -> ReferenceRecording:
    """``pulse`` names an analogue channel whose rising edges are events too.

    Times count from frame 1, as those of the file's events do. Raises FileError.
    """
    import ezc3d  # deferred: loads its library

    _check_size(path)
    try:
        file = ezc3d.c3d(str(path))
    except (RuntimeError, OSError, ValueError, IndexError) as error:
        raise FileError(notice("reference.not_readable", file=path, why=str(error))) from error
    parameters = file["parameters"]
    rate = float(file["header"]["points"]["frame_rate"])
    if not rate > 0:
        raise FileError(notice("reference.no_rate", file=path))
    first = int(file["header"]["points"]["first_frame"])
    points = np.moveaxis(np.asarray(file["data"]["points"])[:3], 0, 2).transpose(1, 0, 2)
    residual = np.asarray(file["data"]["meta_points"]["residuals"])[0].T
    points = np.where((residual < 0)[:, :, None], np.nan, points)
    unit = (_texts(parameters, "POINT", "UNITS") or ["mm"])[0] or "mm"
    return ReferenceRecording(
        "C3D",
        tuple(_labels(parameters, "POINT"))[: points.shape[1]],
        (first + np.arange(len(points))) / rate,
        points * metres(unit, path),
        pulses=(*_events(parameters), *_edges(file, pulse, first / rate)),
    ).checked(path)


def _check_size(path: Path) -> None:
    """Raise FileError if the file is shorter than its header states: ezc3d may crash then."""
    try:
        with path.open("rb") as source:
            head = source.read(_BLOCK)
        size = path.stat().st_size
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
    if len(head) < _BLOCK or head[1] != 0x50:
        raise FileError(notice("reference.not_readable", file=path, why="it is not a C3D file"))
    points, analogs, first, last = struct.unpack_from("<4H", head, 2)
    (scale,) = struct.unpack_from("<f", head, 12)
    (begin,) = struct.unpack_from("<H", head, 16)
    bytes_each = 4 if scale < 0 else 2
    needed = (begin - 1) * _BLOCK + (last - first + 1) * (4 * points + analogs) * bytes_each
    if last < _MANY and first <= last and size < needed and _is_intel(path, head):
        raise FileError(notice("reference.cut_off", file=path))


def _is_intel(path: Path, head: bytes) -> bool:
    """Whether numbers are little-endian IEEE, so that the header was read correctly."""
    with path.open("rb") as source:
        source.seek((head[0] - 1) * _BLOCK + 3)
        return source.read(1) == bytes([84])


def _texts(parameters: Any, group: str, name: str) -> list[str]:
    if group not in parameters or name not in parameters[group]:
        return []
    return [str(v).strip() for v in parameters[group][name]["value"]]


def _labels(parameters: Any, group: str) -> list[str]:
    """LABELS, and LABELS2… of more than 255 points."""
    out = _texts(parameters, group, "LABELS")
    k = 2
    while more := _texts(parameters, group, f"LABELS{k}"):
        out += more
        k += 1
    return out


def _events(parameters: Any) -> list[ReferencePulse]:
    if "EVENT" not in parameters or "TIMES" not in parameters["EVENT"]:
        return []
    times = np.atleast_2d(np.asarray(parameters["EVENT"]["TIMES"]["value"], float))
    if times.shape[0] < 2:
        return []
    names = _texts(parameters, "EVENT", "LABELS")
    seconds = 60.0 * times[0] + times[1]
    return [ReferencePulse(float(t), n) for t, n in zip(seconds, names, strict=False)]


def _edges(file: Any, channel: str, start: float) -> list[ReferencePulse]:
    """Instants at which an analogue channel rises through the middle of its range."""
    names = _labels(file["parameters"], "ANALOG")
    rate = float(file["header"]["analogs"]["frame_rate"])
    if not channel or channel not in names or not rate > 0:
        return []
    x = np.asarray(file["data"]["analogs"])[0, names.index(channel)]
    return [ReferencePulse(start + t, channel) for t in rising_edges(x, rate)]


def rising_edges(x: np.ndarray, rate: float) -> list[float]:
    """Times (s) at which x (N,) rises through the middle of its range, between two samples."""
    middle = 0.5 * (np.nanmin(x) + np.nanmax(x))
    below = x < middle
    rows = np.flatnonzero(below[:-1] & ~below[1:])
    return [float(i + (middle - x[i]) / (x[i + 1] - x[i])) / rate for i in rows]
