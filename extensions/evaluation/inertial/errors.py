"""Errors of the MPU-9250 (InvenSense, Product Specification, revision 1.1, tables 1 and 2)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker import GRAVITY
from tracker.inertial.planar import PlanarReadings
from tracker.messages import Array


@dataclass(frozen=True)
class SensorErrors:
    """Noise densities and the size of turn-on offsets; white noise fills half the sampling rate."""

    gyro_noise: float = np.deg2rad(0.01)  # rad/s/√Hz, rate noise spectral density
    accel_noise: float = 300e-6 * GRAVITY  # m/s²/√Hz, noise power spectral density
    gyro_offset: float = np.deg2rad(5.0)  # rad/s, initial zero-rate tolerance ±5 °/s
    accel_offset: float = 60e-3 * GRAVITY  # m/s², initial zero-g tolerance ±60 mg (x, y)

    def gyro_sd(self, rate_hz: float) -> float:
        return self.gyro_noise * float(np.sqrt(rate_hz / 2))

    def accel_sd(self, rate_hz: float) -> float:
        return self.accel_noise * float(np.sqrt(rate_hz / 2))


MPU9250 = SensorErrors()
SERIES = ("white", "offset", "both")


@dataclass(frozen=True, eq=False)
class Errors:
    """Errors of two sensors' readings: gyro, accel (n, 2, 3) in each phalanx's B."""

    gyro: Array
    accel: Array

    def planar(self, ideal: PlanarReadings) -> PlanarReadings:
        """The readings with the in-plane components of the errors."""
        accel = self.accel[..., 0] - 1j * self.accel[..., 2]
        return PlanarReadings(ideal.gyro + self.gyro[..., 1], ideal.accel + accel, ideal.root)


def draw(
    n: int, series: str, rate_hz: float, seed: tuple[int, ...], errors: SensorErrors = MPU9250
) -> Errors:
    """Draw the errors of one run; offsets equal their tolerance with a random sign per axis."""
    rng = np.random.default_rng(seed)
    signs = rng.choice([-1.0, 1.0], (2, 2, 3))
    gyro, accel = np.zeros((2, n, 2, 3))
    if series in ("offset", "both"):
        gyro += errors.gyro_offset * signs[0]
        accel += errors.accel_offset * signs[1]
    if series in ("white", "both"):
        gyro += errors.gyro_sd(rate_hz) * rng.standard_normal((n, 2, 3))
        accel += errors.accel_sd(rate_hz) * rng.standard_normal((n, 2, 3))
    return Errors(gyro, accel)
