"""Vibration that a glove's motors cause in its IMUs."""

from __future__ import annotations

import math
from collections import deque

import numpy as np

from tracker import GRAVITY
from tracker.messages import Array
from tracker.sensors.protocol import Haptic

MOTOR_HZ = 183.0
"""Of an eccentric motor at full amplitude; 100 packets a second alias it to 17 Hz."""
ACCEL, GYRO = 0.2 * GRAVITY, np.deg2rad(5.0)
"""m/s² and rad/s at full amplitude in the motor's own IMU: assumed is a coin motor that shakes a
fingertip by 0.5 g, of which the IMU's low-pass filter (92 Hz) passes 0.4."""
ELSEWHERE = 0.1
"""Share that the glove's other IMUs measure."""
FIRST_IMU, IMUS_PER_MOTOR = 2, 2
"""The IMU at the end of the first motor's finger, and IMUs for each finger after it."""
MOST_MS = 5000
KEPT = 50
"""Commands of which `MotorVibration.mean` knows."""


class MotorVibration:
    """The running motors, on the clock of the samples (s)."""

    def __init__(self, imu_count: int, rng: np.random.Generator) -> None:
        self._n, self._rng = imu_count, rng
        self._running: dict[int, tuple[float, float]] = {}  # end time, share of full amplitude
        self._runs: deque[tuple[int, float, float, float]] = deque(maxlen=KEPT)
        self._axis = rng.normal(0, 1 / math.sqrt(3), (2, imu_count, 3))

    def run(self, command: Haptic, now: float) -> None:
        """Starts or stops a motor."""
        duration = min(command.duration_ms, MOST_MS) / 1000
        share = command.amplitude / 255
        self._running[command.channel] = now + duration, share
        self._runs.append((command.channel, now, now + duration, share))

    def mean(self, channel: int, begin: float, end: float) -> float:
        """Mean share of full amplitude of a motor, or the brightness of a light in its place."""
        total, until = 0.0, end
        for number, on, off, share in reversed(tuple(self._runs)):
            if number == channel and on < until:
                total += share * max(min(off, until) - max(on, begin), 0.0)
                until = on  # a command replaces the one before
        return total / (end - begin)

    def at(self, t: float) -> tuple[Array, Array] | None:
        """accel (n, 3) m/s² and gyro (n, 3) rad/s to be added at ``t``; None if no motor runs."""
        self._running = {k: v for k, v in self._running.items() if t < v[0] and v[1] > 0}
        if not self._running:
            return None
        size = np.zeros(self._n)
        for channel, (_, share) in self._running.items():
            near = np.full(self._n, ELSEWHERE)
            own = FIRST_IMU + IMUS_PER_MOTOR * channel
            if own < self._n:
                near[own] = 1.0
            size = np.hypot(size, share * near)
        phase = 2 * math.pi * MOTOR_HZ * t
        shaken = size[:, None] * self._axis * math.sin(phase)
        return ACCEL * shaken[0], GYRO * shaken[1]
