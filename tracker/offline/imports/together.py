"""Files of one recording on one timeline: an IMU of the glove for each source, packet by packet."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import nanoseconds, seconds
from tracker.base.errors import ConfigError, FileError
from tracker.messages import Array, ImuSample
from tracker.offline.imports.samples import MOST, Clocks, ImportedSamples

GAP = 0.05
"""s between two samples, beyond which nothing is put between them."""
RATE = 100.0
"""Hz to which faster recordings are averaged, as the glove itself is sampled."""
FASTEST = 1.5
"""Times `RATE` up to which a recording is left as it is."""


class ImportedPackets(NamedTuple):
    """t (N,) s from ``began_ns`` since 1970 (None: unknown), accel m/s² and gyro rad/s (N, n, 3) of
    the glove's n IMUs, NaN where there is none; ``clocks`` where one file of ours tells them."""

    t: Array
    accel: Array
    gyro: Array
    began_ns: int | None
    clocks: Clocks | None

    def samples(self) -> Iterator[ImuSample]:
        """Messages, from 0 s on; what is missing is not valid."""
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


def chosen(names: Sequence[str], imus: Sequence[str], asked: dict[str, str]) -> dict[str, str]:
    """IMU of the glove to IMU of the files: as ``asked``, else of the same name, else the only one.

    Raises ConfigError, naming what there is.
    """
    there = f"There are {', '.join(names)} in the files and {', '.join(imus)} on the glove."
    for imu, name in asked.items():
        if imu not in imus or name not in names:
            raise ConfigError(f"{imu}={name} names an IMU that is not there. {there}")
    if asked:
        return asked
    same = {imu: name for imu in imus for name in names if imu.lower() == name.lower()}
    if not same and len(names) == 1:
        return {imus[0]: names[0]}
    if not same:
        raise ConfigError(f"Say which IMU is which, by --imu GLOVE=FILE. {there}")
    return same


def together(
    files: Sequence[ImportedSamples], imus: Sequence[str], wanted: dict[str, str]
) -> ImportedPackets:
    """Raises FileError where the files have no time in common, or only some tell the calendar's."""
    told = {f.began_ns is not None for f in files}
    if len(told) > 1:
        raise FileError("Only some of the files tell the time of day; they cannot be put together.")
    began = min((f.began_ns for f in files if f.began_ns is not None), default=None)
    shifted = [f.t + (0.0 if began is None else ((f.began_ns or 0) - began) * 1e-9) for f in files]
    used = [k for k, f in enumerate(files) if set(wanted.values()) & set(f.names)]
    main = max(used, key=lambda k: sum(n in wanted.values() for n in files[k].names))
    fast = files[main].rate > FASTEST * RATE
    low = max(shifted[k][0] for k in used)
    high = min(shifted[k][-1] for k in used)
    if fast and (high - low) * RATE > MOST:
        raise FileError(f"The files last longer than {MOST / RATE:.0f} s, the most that fits.")
    t = np.arange(low, high, 1 / RATE) if fast else shifted[main]
    t = t[(t >= low) & (t <= high)]
    if len(t) < 2:
        raise FileError("The files have no time in common: were they of one clock?")
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
    """Means of what lies within half a ``step`` (s) of each instant; NaN where nothing does."""
    first, last = np.searchsorted(at, t - step / 2), np.searchsorted(at, t + step / 2)
    sums = np.concatenate([np.zeros((1, 3)), np.cumsum(values, axis=0)])
    count = (last - first).astype(float)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray((sums[last] - sums[first]) / count[:, None])
