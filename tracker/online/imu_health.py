"""Detects IMUs that must not be used: not responding, not finite, saturated for long, or stuck."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.records import record
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntVector, Matrix, Written
from tracker.messages import Array, ImuSample, IntArray

STUCK_AFTER = 10  # identical packets; noise alone changes a working MPU-9250 by several LSB


@record("imu_health", shapes={"last": "n 6", "same": "int n"})
@dataclass(eq=False)
class ImuHealthSavedState:
    """last (n, 6): accel and gyro of the previous packet; same (n,): number of repetitions."""

    last: Array
    same: IntArray


class ImuHealth:
    """Marks the IMUs of each packet that must not be used."""

    def __init__(self, n: int) -> None:
        self._last: Array = np.full((n, 6), np.nan)
        self._same: IntArray = np.zeros(n, np.int64)

    def check(self, sample: ImuSample) -> ImuSample:
        """The packet with ``valid`` cleared for IMUs that must not be used."""
        valid, clean = _judge(
            sample.accel, sample.gyro, sample.valid, self._last, self._same, STUCK_AFTER
        )
        if clean:
            return sample
        return ImuSample(
            sample.t,
            sample.t_arrival,
            sample.t_device,
            sample.seq,
            np.where(valid[:, None], sample.accel, 0.0),
            np.where(valid[:, None], sample.gyro, 0.0),
            valid,
        )

    @property
    def saved(self) -> ImuHealthSavedState:
        """The state to save, not copied."""
        return ImuHealthSavedState(self._last, self._same)

    def restore(self, saved: ImuHealthSavedState) -> None:
        """Continues from a `saved` state, which it then owns."""
        self._last, self._same = saved.last, saved.same


@kernel(nogil=False)
def _judge(
    accel: Matrix,
    gyro: Matrix,
    valid: BoolVector,
    last: Written[Matrix],
    same: Written[IntVector],
    stuck_after: int,
) -> tuple[BoolVector, bool]:
    """Which IMUs (n,) can be used, and whether these are all that are valid and finite.

    Updates ``last`` (n, 6), the previous readings, and ``same`` (n,), the number of repetitions.
    """
    n = len(valid)
    out, clean = np.empty(n, np.bool_), True
    for j in range(n):
        finite, again = True, True
        for k in range(6):
            x = accel[j, k] if k < 3 else gyro[j, k - 3]
            finite = finite and np.isfinite(x)
            again = again and x == last[j, k]
            last[j, k] = x
        same[j] = same[j] + 1 if again else 0
        out[j] = valid[j] and finite and same[j] < stuck_after
        clean = clean and finite and out[j] == valid[j]
    return out, clean
