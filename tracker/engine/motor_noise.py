"""Noise of the IMUs while the glove's motors run, by what was measured of this glove."""

from __future__ import annotations

import numpy as np

from tracker.glove.model import GloveModel
from tracker.messages import Array
from tracker.sensors.motor_events import MotorRun

AFTER = 0.15
"""s after the end of a run: the motor spins down, and filters process packets late."""


class MotorNoise:
    """``running`` (m, 3): channel, end (s) and share of the amplitude of the last commands; part of
    the saved state. A glove without measurements has no such noise."""

    def __init__(self, glove: GloveModel) -> None:
        known = [imu.vibration for imu in glove.imus if imu.vibration is not None]
        motors = max((len(v.gyro) for v in known), default=0)
        self._size = np.zeros((motors, 2))  # gyro, accel: of the IMU that is shaken most
        for v in known:
            rows = slice(len(v.gyro))
            self._size[rows] = np.maximum(self._size[rows], np.stack([v.gyro, v.accel], axis=1))
        self.running: Array = np.empty((0, 3))

    @property
    def is_known(self) -> bool:
        """Whether the vibration of a motor was measured."""
        return len(self._size) > 0

    def run(self, command: MotorRun, t: float) -> None:
        """Takes a command of ``t`` (s); it replaces an earlier one of the same motor."""
        if command.channel >= len(self._size):
            return
        keep = (self.running[:, 0] != command.channel) & (self.running[:, 1] > t)
        row = [command.channel, t + command.duration + AFTER, command.share]
        self.running = np.concatenate([self.running[keep], [row]])

    def at(self, t: float) -> tuple[float, float]:
        """rad/s/√Hz and m/s²/√Hz in addition to the noise at rest, at ``t`` (s)."""
        now = self.running[self.running[:, 1] > t]
        size = self._size[now[:, 0].astype(np.int64)] * now[:, 2:]
        gyro, accel = np.sqrt(np.sum(size**2, axis=0))
        return float(gyro), float(accel)
