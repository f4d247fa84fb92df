"""CSV tables of IMUs: x-IMU3's, our own, and others whose header contains units.

A header names a column as ``Gyroscope X (deg/s)``, ``hand_acc_x [m/s^2]`` and the like; the text
before the quantity is the IMU's name, by default that of the file.
"""

from __future__ import annotations

import csv
import math
import re
from array import array
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, TextIO

import numpy as np

from tracker.base.errors import FileError
from tracker.base.files import check_regular
from tracker.base.notices import notice
from tracker.messages import Array, IntArray
from tracker.offline.imports.samples import (
    GRAVITY,
    LATEST,
    MOST,
    SINCE_1970,
    Clocks,
    ImportedSamples,
)

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
_LONGEST_NAME = 200  # characters of a column's name: longer ones take too long to search for units
_MOST_NUMBERS = 100_000_000
"""For one file, 0.8 GB of memory: five hours of seven IMUs at 100 Hz."""
_CLOCKS = ("time", "arrived", "device")


class _Column(NamedTuple):
    what: str
    imu: str
    axis: str
    factor: float


def read_table(path: Path, imu: str) -> ImportedSamples:
    """``imu``: the name of one that the header does not name.

    Raises FileError with the line for an invalid table.
    """
    try:
        check_regular(path)
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = csv.reader(_short(file, path))
            header = [cell.strip() for cell in next(rows, [])]
            columns = [_column(cell, imu, path) for cell in header]
            table = _numbers(rows, columns, path)
    except (UnicodeDecodeError, csv.Error) as error:
        raise FileError(notice("import.not_text", path=path, why=error)) from error
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
    return _samples(path, columns, table)


def _short(file: TextIO, path: Path) -> Iterator[str]:
    """Yields lines up to a maximum length: a file without line ends does not fill the memory."""
    n = 0
    while line := file.readline(_LONGEST_LINE + 1):
        n += 1
        if len(line) > _LONGEST_LINE:
            raise FileError(notice("import.long_line", path=path, line=n))
        yield line


def _column(cell: str, imu: str, path: Path) -> _Column | None:
    """None for a column that is not used. Raises FileError for unknown units."""
    if len(cell) > _LONGEST_NAME:
        return None
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
        raise FileError(
            notice("import.unknown_unit", path=path, column=cell, known=tuple(_UNITS[what]))
        )
    if what == "time":
        return _Column(_clock(found["what"].lower()), "", "", factor)
    return _Column(what, found["imu"].strip() or imu, found["axis"].lower(), factor)


def _clock(word: str) -> str:
    return word if word in ("arrived", "device") else "time"


class _Table(NamedTuple):
    """Returns numbers by column, NaN where empty; ``whole``: of clocks, as integers, -1 where
    empty."""

    values: dict[int, Array]
    whole: dict[int, IntArray]


def _numbers(rows: Iterator[list[str]], columns: list[_Column | None], path: Path) -> _Table:
    """The columns that are used. Raises FileError, naming the line."""
    used = [k for k, column in enumerate(columns) if column is not None]
    clocks = [k for k in used if columns[k].what in _CLOCKS]  # type: ignore[union-attr]
    values, whole = {k: array("d") for k in used}, {k: array("q") for k in clocks}
    most = min(MOST, _MOST_NUMBERS // _numbers_of_row(columns))
    count = 0
    for n, row in enumerate(rows):
        if not row:
            continue
        if len(row) != len(columns):
            raise FileError(
                notice("import.cells", path=path, line=n + 2, cells=len(row), columns=len(columns))
            )
        if count == most:
            raise FileError(notice("import.many_lines", path=path, most=most))
        count += 1
        for k in used:
            values[k].append(_number(row[k], n + 2, path))
        for k in clocks:
            whole[k].append(_whole(row[k]))
    return _Table(
        {k: np.frombuffer(column, np.float64) for k, column in values.items()},
        {k: np.frombuffer(column, np.int64) for k, column in whole.items()},
    )


def _numbers_of_row(columns: list[_Column | None]) -> int:
    """Numbers that one row becomes: six of an IMU, even where the file has only some of them."""
    used = [column for column in columns if column is not None]
    return 6 * len({c.imu for c in used if c.imu}) + 2 * sum(not c.imu for c in used) or 1


def _number(cell: str, line: int, path: Path) -> float:
    """NaN of an empty one."""
    cell = cell.strip()
    try:
        return float(cell) if cell else math.nan
    except ValueError:
        raise FileError(notice("import.not_number", path=path, cell=cell[:40], line=line)) from None


def _whole(cell: str) -> int:
    """The number of a cell where it is a whole one of 64 bits, as times are; else -1."""
    text = cell.strip()
    number = int(text) if text.isascii() and text.isdigit() and len(text) < 20 else -1
    return number if number < 2**63 else -1


def _samples(path: Path, columns: list[_Column | None], table: _Table) -> ImportedSamples:
    clocks = {c.what: k for k, c in enumerate(columns) if c is not None and not c.imu}
    if "time" not in clocks:
        raise FileError(notice("import.no_time_column", path=path))
    names = tuple(dict.fromkeys(c.imu for c in columns if c is not None and c.imu))
    if not names:
        raise FileError(notice("import.no_imu_column", path=path))
    with np.errstate(over="ignore"):  # a number beyond all floats in another unit is infinite
        motion = _motion(columns, names, table)
        began, t = _seconds(table, clocks["time"], columns, path)
        more = _clocks(table, clocks, columns, began)
    return ImportedSamples(names, t, motion[0], motion[1], began, more)


def _motion(columns: list[_Column | None], names: tuple[str, ...], table: _Table) -> Array:
    """acc and gyr (2, N, IMUs, 3), NaN where the file has no such column."""
    row = {name: k for k, name in enumerate(names)}
    count = max(len(column) for column in table.values.values())
    motion = np.full((2, count, len(names), 3), np.nan)
    for k, column in enumerate(columns):
        if column is not None and column.imu:
            what = ("acc", "gyr").index(column.what)
            values = table.values.pop(k)
            motion[what, :, row[column.imu], "xyz".index(column.axis)] = values * column.factor
    return motion


def _seconds(
    table: _Table, k: int, columns: list[_Column | None], path: Path
) -> tuple[int | None, Array]:
    """The instant of the first row, ns since 1970 where it is of the calendar, and s from it.

    Whole numbers stay whole: a float has no room for nanoseconds since 1970.
    """
    column = columns[k]
    assert column is not None
    values, whole = table.values[k], table.whole[k]
    known = np.flatnonzero(np.isfinite(values))
    if len(known) == 0:
        raise FileError(notice("import.no_sample", path=path))
    first = int(known[0])
    began = values[first] * column.factor
    if began < SINCE_1970:
        return None, values * column.factor
    if began > LATEST:
        raise FileError(notice("import.not_time", path=path, value=values[first]))
    zero, unit_ns = int(whole[first]), round(column.factor * 1e9)
    if zero < 0 or unit_ns == 0:
        return round(began * 1e9), (values - values[first]) * column.factor
    steps = np.where(whole >= 0, whole - zero, values - values[first])
    return zero * unit_ns, np.where(np.isfinite(values), steps * column.factor, np.nan)


def _clocks(
    table: _Table, at: dict[str, int], columns: list[_Column | None], began: int | None
) -> Clocks | None:
    """What our own tables contain next to the time; None of others."""
    if "arrived" not in at or "packet" not in at or "device" not in at:
        return None
    zero, arrived = 0 if began is None else began, table.whole[at["arrived"]]
    arrival = (np.where(arrived >= 0, arrived, zero) - zero) * 1e-9
    packets = table.values[at["packet"]]
    seq = np.where(np.abs(packets) < 2**62, packets, -1.0).astype(np.int64)
    column = columns[at["device"]]
    assert column is not None
    return Clocks(arrival, table.values[at["device"]] * column.factor, seq)
