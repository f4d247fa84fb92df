"""A buffer of recent glove packets, so that a late image is combined with the motion at its
time."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolMatrix, BoolVector, Matrix, Stack, Vector
from tracker.messages import ImuSample

LONGEST_STEP = 0.25  # s between packets, beyond which the data count as interrupted
SHORTEST_STEP = 1e-9  # s
AROUND = 0.01  # s to both sides, for the difference quotient of the angular velocity


@record("imu_moment", shapes={"accel": "n 3", "gyro": "n 3", "valid": "bool n"})
class Moment(NamedTuple):
    """Readings of all n IMUs at one time, or averaged about it, as in an `ImuSample`.

    t s; accel (n, 3) m/s²; gyro (n, 3) rad/s; valid (n,).
    """

    t: float
    accel: Matrix
    gyro: Matrix
    valid: BoolVector

    @staticmethod
    def of(sample: ImuSample) -> Moment:
        """Converts a packet to arrays for kernels."""
        return Moment(
            sample.t, sample.accel.copy(), sample.gyro.copy(), np.array(sample.valid, np.bool_)
        )


@record("imu_around")
class Around(NamedTuple):
    """Three successive moments; the outer two give the angular acceleration at ``now``."""

    before: Moment
    now: Moment
    after: Moment


Readings = ImuSample | Moment


class Packets(NamedTuple):
    """Packets in order: t (m,) s; accel (m, n, 3) m/s²; gyro (m, n, 3) rad/s; valid (m, n)."""

    t: Vector
    accel: Stack
    gyro: Stack
    valid: BoolMatrix


class Intervals(NamedTuple):
    """A time span, divided at every packet: mean readings of each interval.

    start, stop (k,) s; accel (k, n, 3) m/s², gyro (k, n, 3) rad/s, valid (k, n). While no packets
    arrive no IMU is valid.
    """

    start: Vector
    stop: Vector
    accel: Stack
    gyro: Stack
    valid: BoolMatrix

    @staticmethod
    def single(readings: ImuSample | Moment, start: float, stop: float) -> Intervals:
        """One interval with these mean readings."""
        mean = readings.accel[None].copy(), readings.gyro[None].copy(), readings.valid[None].copy()
        return Intervals(np.array([start]), np.array([stop]), *mean)

    def part(self, first: int, end: int) -> Intervals:
        """The intervals from ``first`` to before ``end``."""
        start, stop, accel, gyro, valid = self
        k = slice(first, end)
        return Intervals(start[k], stop[k], accel[k], gyro[k], valid[k])

    def mean(self, k: int) -> Moment:
        """The mean readings of the interval ``k``, at its middle."""
        t = float(self.start[k] + self.stop[k]) / 2
        return Moment(t, self.accel[k], self.gyro[k], self.valid[k])


class ImuBuffer:
    """The packets of the last ``span`` seconds of ``imus`` IMUs, in order of sampling time."""

    def __init__(self, imus: int, span: float = 1.0) -> None:
        self._imus, self._span = imus, span
        self._samples: deque[ImuSample] = deque()
        self._first = self._end = 0  # rows of the table that are in use
        self._table = self._rows(256)

    def _rows(self, count: int) -> Packets:
        """Rows for ``count`` packets, for compiled loops."""
        n = self._imus
        return Packets(
            np.empty(count),
            np.empty((count, n, 3)),
            np.empty((count, n, 3)),
            np.empty((count, n), np.bool_),
        )

    @property
    def imus(self) -> int:
        """Number of IMUs in a packet."""
        return self._imus

    def __len__(self) -> int:
        return len(self._samples)

    def __iter__(self) -> Iterator[ImuSample]:
        return iter(self._samples)

    @property
    def newest(self) -> ImuSample | None:
        return self._samples[-1] if self._samples else None

    def add(self, sample: ImuSample) -> bool:
        """Store a packet; returns False (and stores nothing) unless it is later than the newest."""
        if self._samples and sample.t <= self._samples[-1].t:
            return False
        if self._end == len(self._table.t):
            self._move_to_front()
        table, k = self._table, self._end
        table.t[k], table.accel[k], table.gyro[k] = sample.t, sample.accel, sample.gyro
        table.valid[k] = sample.valid
        self._end += 1
        self._samples.append(sample)
        while sample.t - self._samples[0].t > self._span:
            self._samples.popleft()
            self._first += 1
        return True

    def _move_to_front(self) -> None:
        """Move the rows in use to the front of a table at least half of which is free."""
        live = self.table
        count = len(live.t)
        self._table = self._rows(max(len(self._table.t), 2 * count))
        for column, rows in zip(self._table, live, strict=True):
            column[:count] = rows
        self._first, self._end = 0, count

    @property
    def table(self) -> Packets:
        """The stored packets."""
        table, used = self._table, slice(self._first, self._end)
        return Packets(table.t[used], table.accel[used], table.gyro[used], table.valid[used])

    def covers(self, t: float) -> bool:
        """Whether a packet at or after ``t`` has arrived."""
        return bool(self._samples) and self._samples[-1].t >= t

    def intervals(self, start: float, end: float) -> Intervals:
        """The intervals from ``start`` to ``end``; none where these are equal."""
        return Intervals(*cut(self.table, start, end))

    def at(self, t: float) -> Moment | None:
        """Readings at ``t``, interpolated between packets; the nearest packet outside the buffer;
        None if empty.

        An IMU is valid where both neighbours are.
        """
        if not self._samples:
            return None
        if t <= self._samples[0].t:
            return Moment.of(self._samples[0])
        if t > self._samples[-1].t:
            return Moment.of(self._samples[-1])
        return Moment(t, *_between(self.table, t))

    def around(self, t: float) -> Around | None:
        """Readings at ``t`` and `AROUND` s before and after; None without packets there."""
        before, now, after = self.at(t - AROUND), self.at(t), self.at(t + AROUND)
        if before is None or now is None or after is None or not before.t < now.t < after.t:
            return None
        return Around(before, now, after)

    def is_packet(self, t: float) -> bool:
        """Whether a packet of exactly this time is stored."""
        times = self.table.t
        k = int(np.searchsorted(times, t))
        return k < len(times) and bool(times[k] == t)

    def restore(self, samples: list[ImuSample]) -> None:
        """Replace all packets by these."""
        self._samples.clear()
        self._first = self._end = 0
        for sample in samples:
            self.add(sample)


@kernel(nogil=False)
def _between(packets: Packets, at: float) -> tuple[Matrix, Matrix, BoolVector]:
    """accel, gyro (n, 3) and valid (n,), interpolated linearly between two of the packets."""
    t, accel, gyro, valid = packets
    k = np.searchsorted(t, at)
    w = (at - t[k - 1]) / (t[k] - t[k - 1])
    between = (1 - w) * accel[k - 1] + w * accel[k], (1 - w) * gyro[k - 1] + w * gyro[k]
    return *between, np.logical_and(valid[k - 1], valid[k])


@kernel(nogil=False)
def cut(
    packets: Packets, start: float, end: float
) -> tuple[Vector, Vector, Stack, Stack, BoolMatrix]:
    """The fields of `Intervals` from ``start`` to ``end`` (s), divided at the packets."""
    t, accel, gyro, valid = packets
    m, n = valid.shape
    # 1. upper limit of the number of intervals
    k = int(np.searchsorted(t, start, side="right"))
    most = np.searchsorted(t, end) - k + 1 if end > start else 0
    starts, stops = np.empty(most), np.empty(most)
    mean_accel, mean_gyro = np.zeros((most, n, 3)), np.zeros((most, n, 3))
    both = np.zeros((most, n), np.bool_)
    at, count = start, 0
    while end - at > SHORTEST_STEP:
        # 2. the next one ends at a packet, or at ``end``
        stop = min(t[k], end) if k < m else end
        starts[count], stops[count] = at, stop
        # 3. mean readings: those at its middle, between the packets before and after
        if k < m and t[k] - at <= LONGEST_STEP:
            a, w = max(k - 1, 0), 1.0
            if k > 0:
                w = ((at + stop) / 2 - t[a]) / (t[k] - t[a])
            for j in range(n):
                both[count, j] = valid[a, j] and valid[k, j]
                for i in range(3):
                    mean_accel[count, j, i] = (1 - w) * accel[a, j, i] + w * accel[k, j, i]
                    mean_gyro[count, j, i] = (1 - w) * gyro[a, j, i] + w * gyro[k, j, i]
        at = stop
        count += 1
        k += 1
    return starts[:count], stops[:count], mean_accel[:count], mean_gyro[:count], both[:count]
