"""All packets of a session's glove as arrays, and its notes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array, Event, ImuSample, IntArray
from tracker.session.notes import latest_versions
from tracker.session.reader import SessionReader

MARKS = ("note", "pulse")
"""Kinds of events that other programs want to know the instants of."""


@dataclass(frozen=True, eq=False)
class RawImu:
    """N packets of n IMUs: stamp_ns and arrival_ns (N,) since 1970; device_s (N,) the glove's own
    clock, NaN where unknown; seq (N,), -1 where unknown; accel m/s² and gyro rad/s (N, n, 3), NaN
    where ``valid`` (N, n) is False."""

    names: tuple[str, ...]
    stamp_ns: IntArray
    arrival_ns: IntArray
    device_s: Array
    seq: IntArray
    accel: Array
    gyro: Array
    valid: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.stamp_ns)

    def rows(self, rows: IntArray, zero_ns: int = 0) -> RawImu:
        """A selection of the packets; the computer's times are counted from ``zero_ns``."""
        return RawImu(
            self.names, self.stamp_ns[rows] - zero_ns, self.arrival_ns[rows] - zero_ns,
            self.device_s[rows], self.seq[rows], self.accel[rows], self.gyro[rows],
            self.valid[rows],
        )  # fmt: skip

    @property
    def rate(self) -> float:
        """Packets per second: the inverse of the median step; NaN for fewer than two."""
        return 1e9 / float(np.median(np.diff(self.stamp_ns))) if len(self) > 1 else float("nan")

    def channels(self) -> tuple[list[str], Array]:
        """Names ``<imu>_acc_x`` …, ``<imu>_gyr_z`` (6 n) and values (N, 6 n), m/s² and rad/s."""
        names = [f"{n}_{what}_{c}" for n in self.names for what in ("acc", "gyr") for c in "xyz"]
        return names, np.concatenate([self.accel, self.gyro], axis=2).reshape(len(self), -1)

    def channels_at(self, stamp_ns: IntArray) -> Array:
        """Returns (M, 6 n) interpolated linearly at other instants; NaN next to a missing one."""
        _, values = self.channels()
        out = np.full((len(stamp_ns), values.shape[1]), np.nan)
        if len(self) == 0:
            return out
        t, at = (self.stamp_ns - self.stamp_ns[0]) * 1e-9, (stamp_ns - self.stamp_ns[0]) * 1e-9
        for k, column in enumerate(values.T):
            out[:, k] = np.interp(at, t, column, left=np.nan, right=np.nan)
        return out


def read_raw_imu(reader: SessionReader, need: bool = True) -> RawImu:
    """Returns all packets in the order of their instants.

    Raises FileError if there are none and ``need`` is set.
    """
    found = [m for m in reader.messages([ImuSample]) if isinstance(m, ImuSample)]
    if not found and need:
        raise FileError(notice("session.no_imu", path=reader.path))
    found.sort(key=lambda m: m.t)
    names, wall = reader.info.glove.imu_names, reader.anchor.wall
    shape = (len(found), len(names), 3)
    return RawImu(
        names,
        np.array([wall(m.t) for m in found], np.int64),
        np.array([wall(m.t_arrival) for m in found], np.int64),
        np.array([m.t_device for m in found], float),
        np.array([m.seq for m in found], np.int64),
        np.array([m.accel for m in found], float).reshape(shape),
        np.array([m.gyro for m in found], float).reshape(shape),
        np.array([m.valid for m in found], bool).reshape(shape[:2]),
    )


def read_notes(reader: SessionReader, kinds: tuple[str, ...] = ("note",)) -> list[tuple[int, str]]:
    """(ns since 1970, text) of each note in its last version; also of events of other ``kinds``."""
    events = [m for m in reader.messages([Event]) if isinstance(m, Event)]
    return [(reader.anchor.wall(e.t), e.text) for e in latest_versions(events) if e.kind in kinds]
