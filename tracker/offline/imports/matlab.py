"""MATLAB files (version 5): variables of one IMU, or a struct for each.

One IMU: ``acc`` or ``imu_acc`` (N, 3) m/s², ``gyr`` or ``imu_gyr`` (N, 3) rad/s, and ``t`` s or a
rate (``sampling_rate``, ``rate``, ``fs``) Hz. Several: structs with ``acc`` and ``gyr``, and ``t``.
"""

from __future__ import annotations

import contextlib
import math
import os
import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import loadmat, whosmat

from tracker.base.errors import FileError
from tracker.base.files import check_regular
from tracker.base.notices import notice
from tracker.messages import Array
from tracker.offline.imports.samples import MOST, ImportedSamples

_ACC, _GYR = ("acc", "imu_acc"), ("gyr", "imu_gyr")
_MOST_BYTES = 400_000_000
"""For a file once unpacked: two hours of seven IMUs at 1 kHz in 64 bits."""
_MOST_NUMBERS = 100_000_000
"""For one array; a damaged header may declare any number."""
_HEADER, _TAG, _COMPRESSED = 128, 8, 15  # bytes, bytes, kind of element of version 5
_PIECE = 1_000_000
_RATES = ("sampling_rate", "rate", "fs")


def read_matlab(path: Path, imu: str) -> ImportedSamples:
    """``imu``: the name of one without a name. Raises FileError for another kind of file."""
    found = _loaded(path)
    parts = {imu: found} | {n: vars(v) for n, v in found.items() if hasattr(v, "_fieldnames")}
    pairs = {name: _pair(name, part, path) for name, part in parts.items() if _has_both(part)}
    if not pairs:
        raise FileError(notice("import.no_imu", path=path))
    lengths = {len(acc) for acc, _ in pairs.values()}
    if len(lengths) > 1 or lengths == {0} or max(lengths) > MOST:
        raise FileError(notice("import.imu_lengths", path=path))
    t = _time(found, lengths.pop(), path)
    acc, gyr = (np.stack([pair[k] for pair in pairs.values()], axis=1) for k in (0, 1))
    return ImportedSamples(tuple(pairs), t, acc, gyr)


def _loaded(path: Path) -> dict[str, Any]:
    try:
        check_regular(path)
        if _unpacked_bytes(path) > _MOST_BYTES:
            raise FileError(notice("file.unpacked_size", path=path, limit_mb=_MOST_BYTES // 10**6))
        if sum(math.prod(shape) for _, shape, _ in whosmat(path)) > _MOST_NUMBERS:
            raise FileError(notice("import.many_numbers", path=path, most=_MOST_NUMBERS))
        loaded = loadmat(path, squeeze_me=True, struct_as_record=False)
    except FileError:
        raise
    except OSError as error:
        raise FileError(
            notice("file.not_readable", path=path, why=error.strerror or error)
        ) from error
    except NotImplementedError as error:  # version 7.3
        raise FileError(notice("import.matlab_version", path=path)) from error
    except Exception as error:  # scipy raises whatever a damaged file leads it to
        raise FileError(notice("import.not_matlab", path=path, why=error)) from error
    return {name: value for name, value in loaded.items() if not name.startswith("__")}


def _unpacked_bytes(path: Path) -> int:
    """Bytes of all elements once decompressed, counted no further than beyond the bound."""
    total = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(_HEADER)
        order = "<" if head[-2:] == b"IM" else ">"
        while total <= _MOST_BYTES and len(tag := file.read(_TAG)) == _TAG:
            kind, length = struct.unpack(f"{order}II", tag)
            if kind != _COMPRESSED:
                file.seek(length, os.SEEK_CUR)
                continue
            total += _inflated_bytes(file.read(min(length, _MOST_BYTES)), _MOST_BYTES - total)
    return total


def _inflated_bytes(packed: bytes, most: int) -> int:
    """Bytes that they become, up to a little more than ``most``; damage ends the count."""
    unpack, total = zlib.decompressobj(), 0
    with contextlib.suppress(zlib.error):
        while packed and total <= most:
            total += len(unpack.decompress(packed, _PIECE))
            packed = unpack.unconsumed_tail
    return total


def _has_both(part: dict[str, Any]) -> bool:
    return any(n in part for n in _ACC) and any(n in part for n in _GYR)


def _pair(name: str, part: dict[str, Any], path: Path) -> tuple[Array, Array]:
    acc, gyr = (
        _numbers(next(part[n] for n in names if n in part), (-1, 3), f"{name} in {path}")
        for names in (_ACC, _GYR)
    )
    if len(acc) != len(gyr):
        raise FileError(notice("import.pair_lengths", imu=name, path=path))
    return acc, gyr


def _time(found: dict[str, Any], n: int, path: Path) -> Array:
    if "t" in found:
        t = _numbers(found["t"], (-1,), f"t in {path}")
        if len(t) != n:
            raise FileError(notice("import.time_length", path=path, times=len(t), samples=n))
        return t
    for name in _RATES:
        if name in found:
            rate = float(np.append(_numbers(found[name], (-1,), f"{name} in {path}"), 0.0)[0])
            if 1.0 <= rate <= 1e5:
                return np.asarray(np.arange(n) / rate)
            raise FileError(notice("import.rate", path=path, name=name, rate_hz=rate))
    raise FileError(notice("import.no_time", path=path, rates=_RATES))


def _numbers(value: Any, shape: tuple[int, ...], what: str) -> Array:
    try:
        return np.asarray(value, float).reshape(shape)
    except (TypeError, ValueError) as error:
        raise FileError(notice("import.not_table", what=what)) from error
