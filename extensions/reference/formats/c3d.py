"""C3D, read by ezc3d: points, events, and edges of analogue channels."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np

from extensions.reference.recording import ReferencePulse, ReferenceRecording, metres
from tracker.base.errors import FileError
from tracker.base.notices import notice

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
