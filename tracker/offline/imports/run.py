"""``glovetrack import``: raw IMUs of other programs as a session, which can be tracked."""

from __future__ import annotations

import contextlib
import math
import os
import struct
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.io import loadmat, whosmat

from tracker.base.clock import NS, ClockAnchor, nanoseconds, seconds
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import check_regular, check_target
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.glove import library
from tracker.messages import Array, ImuSample
from tracker.offline.commands import ImportArguments
from tracker.offline.imports.samples import MOST, Clocks, ImportedSamples, doubts, in_order
from tracker.offline.imports.table import read_table
from tracker.session.description import describe
from tracker.session.writer import new_session

GAP = 0.05
"""s between two samples, beyond which nothing is put between them."""
RATE = 100.0
"""Hz to which faster recordings are averaged, as the glove itself is sampled."""
FASTEST = 1.5
"""Times `RATE` up to which the rate of a recording is not changed."""


class ImportedPackets(NamedTuple):
    """t (N,) s from ``began_ns`` since 1970 (None: unknown), accel m/s² and gyro rad/s (N, n, 3) of
    the glove's n IMUs, NaN where missing; ``clocks`` if it is one file of ours with clocks."""

    t: Array
    accel: Array
    gyro: Array
    began_ns: int | None
    clocks: Clocks | None

    def samples(self) -> Iterator[ImuSample]:
        """Yields the packets, from 0 s on; missing readings are marked invalid."""
        motion = np.concatenate([self.accel, self.gyro], axis=2)
        valid: NDArray[np.bool_] = np.asarray(np.isfinite(motion).all(axis=2))
        first = self.t[0]
        for k, t in enumerate(self.t):
            at = seconds(nanoseconds(float(t - first)))
            accel = np.where(valid[k, :, None], self.accel[k], np.nan)
            gyro = np.where(valid[k, :, None], self.gyro[k], np.nan)
            arrival, device, seq = at, float("nan"), -1
            if self.clocks is not None:
                c = self.clocks
                arrival = max(at, seconds(nanoseconds(float(c.arrival[k] - first))))
                device, seq = float(c.device[k]), int(c.seq[k])
            yield ImuSample(at, arrival, device, seq, accel, gyro, valid[k])


def chosen(names: Sequence[str], imus: Sequence[str], requested: dict[str, str]) -> dict[str, str]:
    """Maps IMUs of the glove to IMUs of the files: as ``requested``, by name, or the only one.

    Raises ConfigError that lists the IMUs.
    """
    for imu, name in requested.items():
        if imu not in imus or name not in names:
            raise ConfigError(
                notice("import.imu_unknown", imu=imu, name=name, found=names, imus=imus)
            )
    if requested:
        return requested
    same = {imu: name for imu in imus for name in names if imu.lower() == name.lower()}
    if not same and len(names) == 1:
        return {imus[0]: names[0]}
    if not same:
        raise ConfigError(notice("import.imus_unassigned", found=names, imus=imus))
    return same


def together(
    files: Sequence[ImportedSamples], imus: Sequence[str], wanted: dict[str, str]
) -> ImportedPackets:
    """Raises FileError if the files do not overlap in time, or only some contain the date."""
    dated = {f.began_ns is not None for f in files}
    if len(dated) > 1:
        raise FileError(notice("import.some_dated"))
    began = min((f.began_ns for f in files if f.began_ns is not None), default=None)
    shifted = [f.t + (0.0 if began is None else ((f.began_ns or 0) - began) * 1e-9) for f in files]
    used = [k for k, f in enumerate(files) if set(wanted.values()) & set(f.names)]
    main = max(used, key=lambda k: sum(n in wanted.values() for n in files[k].names))
    fast = files[main].rate > FASTEST * RATE
    low = max(shifted[k][0] for k in used)
    high = min(shifted[k][-1] for k in used)
    if fast and (high - low) * RATE > MOST:
        raise FileError(notice("import.too_long", limit_s=MOST / RATE))
    t = np.arange(low, high, 1 / RATE) if fast else shifted[main]
    t = t[(t >= low) & (t <= high)]
    if len(t) < 2:
        raise FileError(notice("import.no_overlap"))
    motion = np.full((2, len(t), len(imus), 3), np.nan)
    for imu, name in wanted.items():
        k = next(k for k in used if name in files[k].names)
        row = files[k].names.index(name)
        for what, values in enumerate((files[k].accel[:, row], files[k].gyro[:, row])):
            motion[what, :, imus.index(imu)] = at_instants(shifted[k], values, t)
    alone = len(used) == 1 and not fast and len(t) == len(files[main].t)
    first_ns = None if began is None else began + nanoseconds(float(t[0]))
    return ImportedPackets(t, motion[0], motion[1], first_ns, files[main].clocks if alone else None)


def at_instants(t_old: Array, values: Array, t: Array) -> Array:
    """(N, 3) at ``t``, which are the same instants, slower, or about as fast: means over each step
    where there are more than `FASTEST` samples in it, lines between the neighbours otherwise."""
    known = np.asarray(np.isfinite(values).all(axis=1))
    out = np.full((len(t), 3), np.nan)
    if known.sum() < 2:
        return out
    at, values = t_old[known], values[known]
    step = float(np.median(np.diff(t)))
    if step > FASTEST * float(np.median(np.diff(at))):
        return _means(at, values, t, step)
    after = np.clip(np.searchsorted(at, t - 1e-9), 0, len(at) - 1)
    before = np.clip(np.searchsorted(at, t + 1e-9, side="right") - 1, 0, len(at) - 1)
    near = (at[after] - at[before] <= GAP) & (at[before] <= t + 1e-9) & (at[after] >= t - 1e-9)
    for k in range(3):
        out[near, k] = np.interp(t[near], at, values[:, k])
    return out


def _means(at: Array, values: Array, t: Array, step: float) -> Array:
    """Returns means of the samples within half a ``step`` (s) of each instant; else NaN."""
    first, last = np.searchsorted(at, t - step / 2), np.searchsorted(at, t + step / 2)
    sums = np.concatenate([np.zeros((1, 3)), np.cumsum(values, axis=0)])
    count = (last - first).astype(float)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray((sums[last] - sums[first]) / count[:, None])


FOLDERS_FILE = "Inertial.csv"
"""What x-IMU3's program writes in a folder for each IMU."""
ENGINE = "inertial"
"""The default engine for such a session, which has no images."""


@dataclass(frozen=True)
class ImportOptions:
    """``imus``: IMU of the glove to that of the files; glove and hand by name or file."""

    glove: str = ""
    hand: str = ""
    imus: dict[str, str] = field(default_factory=dict)


def import_imus(
    sources: Sequence[Path], out: Path, options: ImportOptions | None = None, force: bool = False
) -> dict[str, Any]:
    """Writes a session of the samples in ``sources``; returns a summary.

    Raises ConfigError and FileError.
    """
    options = options or ImportOptions()
    paths = [path for source in sources for path in _files(source)]
    check_target(out, force, paths)
    read = [in_order(_read(path), path.name) for path in paths]
    files = [samples for samples, _ in read]
    names = [name for samples in files for name in samples.names]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise ConfigError(notice("import.imu_twice", imus=sorted(twice)))
    texts = library.texts(options.glove or library.DEFAULT_GLOVE, options.hand or None)
    _, glove = library.load(options.glove or library.DEFAULT_GLOVE, options.hand or None)
    wanted = chosen(names, glove.imu_names, options.imus)
    packets = together(files, glove.imu_names, wanted)
    anchor = ClockAnchor(packets.began_ns or _began(paths[0], packets), 0)
    extra = {"source": ", ".join(p.name for p in paths)[:1000], "imported": "raw samples of IMUs"}
    settings = f'engine = "{ENGINE}"\n'
    info = describe(*texts, anchor, engine=ENGINE, settings_text=settings, extra=extra)
    with new_session(out, info, force, paths) as recorder:
        for sample in packets.samples():
            recorder.write(sample)
    report = _report(packets, wanted, files, sum(lost for _, lost in read))
    rows = [glove.imu_names.index(imu) for imu in wanted]
    missing = ~np.isfinite(packets.gyro[:, rows]).all(axis=2)
    return report | {"missing": dict(zip(wanted, missing.sum(axis=0).tolist(), strict=True))}


def _files(source: Path) -> list[Path]:
    """The file itself; of a folder all `FOLDERS_FILE` in it and in its folders."""
    if not source.is_dir():
        return [source]
    found = sorted(source.glob(FOLDERS_FILE)) + sorted(source.glob(f"*/{FOLDERS_FILE}"))
    if not found:
        raise FileError(notice("import.folder_empty", file=FOLDERS_FILE, folder=source))
    return found


def _read(path: Path) -> ImportedSamples:
    """By its ending; an IMU that has no name is named as its file, or as the folder of it."""
    own = path.parent.name if path.name == FOLDERS_FILE else path.stem
    if path.suffix.lower() == ".mat":
        return read_matlab(path, own)
    if path.suffix.lower() in (".csv", ".txt"):
        return read_table(path, own)
    raise FileError(notice("import.unknown_kind", path=path))


def _began(path: Path, packets: ImportedPackets) -> int:
    """Without a time of day in the file, its last modification is used as its end."""
    return path.stat().st_mtime_ns - round(float(packets.t[-1] - packets.t[0]) * NS)


def _report(
    packets: ImportedPackets, wanted: dict[str, str], files: list[ImportedSamples], left_out: int
) -> dict[str, Any]:
    used = [f for f in files if set(f.names) & set(wanted.values())]
    return {
        "packets": len(packets.t),
        "duration_s": float(packets.t[-1] - packets.t[0]),
        "rate_hz": 1.0 / float(np.median(np.diff(packets.t))),
        "recorded_hz": [f.rate for f in used],
        "imus": wanted,
        "left_out": left_out,
        "doubts": [text for f in used for text in doubts(f, set(wanted.values()))],
    }


def run_import(args: ImportArguments) -> int:
    check_json(args, args.sources)
    pairs = [word.partition("=") for word in args.imu]
    options = ImportOptions(args.glove, args.hand, {imu: name for imu, _, name in pairs})
    report = import_imus(args.sources, args.out, options, args.force)
    lines = [
        f"{args.out}: {report['packets']} packets at {report['rate_hz']:.0f} Hz, "
        f"{report['duration_s']:.1f} s, of {', '.join(report['imus'].values())}.",
        *report["doubts"],
    ]
    finish(args, report, lines, [*args.sources, args.out])
    return 0


# ---- MATLAB files (version 5): variables of one IMU, or a struct for each
#
# One IMU: ``acc`` or ``imu_acc`` (N, 3) m/s², ``gyr`` or ``imu_gyr`` (N, 3) rad/s, and ``t`` s or
# a rate (``sampling_rate``, ``rate``, ``fs``) Hz. Several: structs with ``acc`` and ``gyr``, and
# ``t``.

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
