"""Which IMUs can be believed: silent, not finite, saturated for long, or stuck at one value."""

from __future__ import annotations

import numpy as np

from tracker.messages import Array, ImuSample, IntArray

STUCK_AFTER = 10  # identical packets; noise alone moves a living MPU-9250 by several LSB


class ImuHealth:
    """Marks the IMUs of each packet that must not be used."""

    def __init__(self, n: int) -> None:
        self._last: Array = np.full((n, 6), np.nan)
        self._same: IntArray = np.zeros(n, np.int64)

    def check(self, sample: ImuSample) -> ImuSample:
        """The packet with ``valid`` cleared where an IMU is not to be believed."""
        reading = np.concatenate([sample.accel, sample.gyro], axis=1)
        finite = np.all(np.isfinite(reading), axis=1)
        same = np.all(reading == self._last, axis=1)
        self._same = np.where(same, self._same + 1, 0)
        self._last = reading
        valid = np.asarray(sample.valid) & finite & (self._same < STUCK_AFTER)
        if np.array_equal(valid, sample.valid) and finite.all():
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

    def state(self) -> tuple[Array, IntArray]:
        return self._last.copy(), self._same.copy()

    def restore(self, state: tuple[Array, IntArray]) -> None:
        self._last, self._same = state[0].copy(), state[1].copy()
