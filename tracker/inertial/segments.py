"""Orientations of many independent IMUs at once, without magnetometers, in one compiled call.

Each IMU is a strapdown integrator whose specific force is low-passed in the levelled frame G, where
the accelerations of a hand that stays in the room average out and gravity remains (the idea of
Laidig and Seel 2023, doi 10.1016/j.inffus.2022.10.014). The frame is re-levelled on that average a
few times a second; how steadily it has to be turned back shows the gyroscope's offset, and a rest
shows it directly. Heading is free.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from tracker.inertial import segments_kernel as kernel
from tracker.messages import Array


@dataclass(frozen=True)
class SegmentParams:
    """Times in s; thresholds of rest for a hand that lies still."""

    tilt_time: float = 2.0  # of each of two low passes on the specific force
    level_period: float = 0.1  # between two levellings
    offset_time: float = 60.0  # in which motion corrects a gyroscope's offset
    rest_time: float = 1.5  # of stillness that make a rest
    rest_filter: float = 0.5  # of the averages that stillness is judged by
    rest_gyro: float = np.deg2rad(2.0)  # rad/s
    rest_accel: float = 0.5  # m/s²
    rest_offset_time: float = 3.0  # in which a rest corrects the offset
    offset_limit: float = np.deg2rad(10.0)  # rad/s, twice the MPU-9250's zero-rate tolerance


class SegmentFilters:
    """q_GB of ``n`` IMUs whose axes are B's, sampled every ``dt`` s."""

    def __init__(self, n: int, dt: float, params: SegmentParams | None = None) -> None:
        self.params = params or SegmentParams()
        memory = np.zeros((n + 1, kernel.SIZE))
        coefficients = _coefficients(dt, self.params)
        memory[n, : len(coefficients)] = coefficients
        self._memory, self._state = memory, memory[:n]
        self._state[:, kernel.Q + 3] = 1.0
        # bound once: at half a microsecond an update, looking names up would show
        self._step = partial(kernel.step, memory)

    @property
    def state(self) -> Array:
        return self._state.copy()

    @state.setter
    def state(self, value: Array) -> None:
        self._state[:] = value

    @property
    def q_GB(self) -> Array:
        """(n, 4) xyzw; heading starts at zero."""
        return self._state[:, kernel.Q : kernel.Q + 4].copy()

    @property
    def gyro_offset(self) -> Array:
        """(n, 3) rad/s."""
        return self._state[:, kernel.OFFSET : kernel.OFFSET + 3].copy()

    @property
    def at_rest(self) -> Array:
        """(n,) True where an IMU has been still for long enough."""
        return np.asarray(self._state[:, kernel.STILL] >= self.params.rest_time)

    def update(self, gyro: Array, accel: Array) -> None:
        """One sample of all: gyro (n, 3) rad/s, accel (n, 3) m/s² specific force, both in B.

        A row with NaN is skipped: that IMU did not respond and keeps its orientation.
        """
        self._step(gyro, accel)

    def run(self, gyro: Array, accel: Array) -> Array:
        """q_GB (m, n, 4) of m samples (m, n, 3): the same as m calls of `update`."""
        out = np.empty((*gyro.shape[:2], 4))
        kernel.run(self._memory, np.ascontiguousarray(gyro), np.ascontiguousarray(accel), out)
        return out


def _coefficients(dt: float, p: SegmentParams) -> Array:
    """What the kernel needs per sample, in its order."""
    every = max(1, round(p.level_period / dt))
    return np.array(
        [
            dt,
            1 - np.exp(-dt / p.tilt_time),
            every,
            1 / p.offset_time,
            p.rest_time,
            1 - np.exp(-every * dt / p.rest_filter),
            p.rest_gyro,
            p.rest_accel,
            every * dt / p.rest_offset_time,
            p.offset_limit,
        ]
    )
