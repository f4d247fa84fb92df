"""CSV tables of IMUs: x-IMU3's, our own, and others whose header tells units.

A header names a column as ``Gyroscope X (deg/s)``, ``hand_acc_x [m/s^2]`` and the like; what stands
before the quantity is the IMU's name, and where nothing does it is the file's.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tracker.errors import FileError
from tracker.messages import Array
from tracker.offline.imports.samples import GRAVITY, MOST, SINCE_1970, Clocks, Samples

_DEG = np.pi / 180
_UNITS = {
    "acc": {"m/s^2": 1.0, "m/s²": 1.0, "m/s2": 1.0, "g": GRAVITY, "mg": GRAVITY / 1e3},
    "gyr": {"rad/s": 1.0, "deg/s": _DEG, "°/s": _DEG, "dps": _DEG, "deg/sec": _DEG},
    "time": {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9},
}  # fmt: skip
_QUANTITY = re.compile(
    r"(?P<imu>.*?)[\s_.]*(?P<what>acc|gyr)(?:el|o|elerometer|eleration|oscope)?[\s_.]*"
    r"(?P<axis>[xyz])\s*[\[(](?P<unit>[^\])]*)[\])]",
    re.IGNORECASE,
)
_TIME = re.compile(
    r"(?P<what>time|timestamp|t|sampled|arrived|device)\s*[\[(](?P<unit>[^\])]*)[\])]",
    re.IGNORECASE,
)
_LONGEST_LINE = 100_000  # characters


class _Column(NamedTuple):
    what: str
    imu: str
    axis: str
    factor: float


def read_table(path: Path, imu: str) -> Samples:
    """``imu``: the name of one that the header does not name.

    Raises FileError, naming the line, for what is no such table.
    """
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = csv.reader(_short(file, path))
            header = [cell.strip() for cell in next(rows, [])]
            columns = [_column(cell, imu, path) for cell in header]
            numbers = _numbers(rows, len(header), path)
    except (UnicodeDecodeError, csv.Error) as error:
        raise FileError(f"{path} is no table of text: {error}.") from error
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error.strerror}.") from error
    return _samples(path, columns, numbers)


def _short(file: Iterator[str], path: Path) -> Iterator[str]:
    for n, line in enumerate(file):
        if len(line) > _LONGEST_LINE:
            raise FileError(f"{path}: line {n + 1} is too long for a table.")
        yield line


def _column(cell: str, imu: str, path: Path) -> _Column | None:
    """None for one that is none of ours. Raises FileError for units that are not known."""
    if cell == "packet":
        return _Column("packet", "", "", 1.0)
    found = _TIME.fullmatch(cell)
    what = "time"
    if found is None:
        found = _QUANTITY.fullmatch(cell)
        if found is None:
            return None
        what = found["what"].lower()
    factor = _UNITS[what].get(found["unit"].strip().lower())
    if factor is None:
        known = ", ".join(_UNITS[what])
        raise FileError(f"{path}: the unit of {cell!r} is not known; there are {known}.")
    if what == "time":
        return _Column(_clock(found["what"].lower()), "", "", factor)
    return _Column(what, found["imu"].strip() or imu, found["axis"].lower(), factor)


def _clock(word: str) -> str:
    return word if word in ("arrived", "device") else "time"


def _numbers(rows: Iterator[list[str]], width: int, path: Path) -> list[list[str]]:
    out: list[list[str]] = []
    for n, row in enumerate(rows):
        if not row:
            continue
        if len(row) != width:
            raise FileError(f"{path}: line {n + 2} has {len(row)} cells, the header {width}.")
        if len(out) == MOST:
            raise FileError(f"{path} has more than {MOST} lines.")
        out.append(row)
    return out


def _samples(path: Path, columns: list[_Column | None], rows: list[list[str]]) -> Samples:
    clocks = {c.what: k for k, c in enumerate(columns) if c is not None and not c.imu}
    if "time" not in clocks:
        raise FileError(f"{path} has no column of time with its unit, as 'Time (s)'.")
    names = tuple(dict.fromkeys(c.imu for c in columns if c is not None and c.imu))
    if not names:
        raise FileError(f"{path} has no column of an IMU with its unit, as 'Gyroscope X (deg/s)'.")
    motion = np.full((2, len(rows), len(names), 3), np.nan)
    for k, column in enumerate(columns):
        if column is not None and column.imu:
            values = _values(rows, k, path) * column.factor
            what = ("acc", "gyr").index(column.what)
            motion[what, :, names.index(column.imu), "xyz".index(column.axis)] = values
    began, t = _seconds(rows, clocks["time"], columns, path)
    return Samples(
        names, t, motion[0], motion[1], began, _clocks(rows, clocks, columns, began, path)
    )


def _values(rows: list[list[str]], k: int, path: Path) -> Array:
    """(N,) of column ``k``; NaN where it is empty. Raises FileError, naming the line."""
    out = np.full(len(rows), np.nan)
    for n, row in enumerate(rows):
        cell = row[k].strip()
        if cell:
            try:
                out[n] = float(cell)
            except ValueError:
                raise FileError(f"{path}: {cell[:40]!r} in line {n + 2} is no number.") from None
    return out


def _seconds(
    rows: list[list[str]], k: int, columns: list[_Column | None], path: Path
) -> tuple[int | None, Array]:
    """The instant of the first row, ns since 1970 where it is of the calendar, and s from it.

    Whole numbers stay whole: a float has no room for nanoseconds since 1970.
    """
    column = columns[k]
    assert column is not None
    values = _values(rows, k, path)
    known = np.flatnonzero(np.isfinite(values))
    if len(known) == 0:
        raise FileError(f"{path} holds no sample.")
    first = int(known[0])
    if values[first] * column.factor < SINCE_1970:
        return None, values * column.factor
    zero, unit_ns = _whole(rows[first][k]), round(column.factor * 1e9)
    if zero is None or unit_ns == 0:
        return round(values[first] * column.factor * 1e9), (values - values[first]) * column.factor
    steps = [(_whole(row[k]) or zero) - zero for row in rows]
    t = np.where(np.isfinite(values), np.array(steps, float) * column.factor, np.nan)
    return zero * unit_ns, t


def _whole(cell: str) -> int | None:
    """The number of a cell where it is a whole one of a length that a time has."""
    text = cell.strip()
    return int(text) if text.isascii() and text.isdigit() and len(text) < 20 else None


def _clocks(
    rows: list[list[str]],
    at: dict[str, int],
    columns: list[_Column | None],
    began: int | None,
    path: Path,
) -> Clocks | None:
    """What our own tables tell beside the time; None of others."""
    if "arrived" not in at or "packet" not in at or "device" not in at:
        return None
    zero = 0 if began is None else began
    arrival = np.array([(_whole(r[at["arrived"]]) or zero) - zero for r in rows], float) * 1e-9
    seq = np.nan_to_num(_values(rows, at["packet"], path), nan=-1.0).astype(np.int64)
    column = columns[at["device"]]
    assert column is not None
    return Clocks(arrival, _values(rows, at["device"], path) * column.factor, seq)
