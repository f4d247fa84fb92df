"""What the six-axis IMU of a stereo camera on a head measures (Bosch BMI055, as such cameras have).

The data sheet's noise is 0.014 °/s/√Hz and 150 µg/√Hz. Its zero offsets of 1 °/s and 70 mg are
before the camera's own calibration, which leaves a fraction.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tracker import GRAVITY
from tracker.base.clock import nanoseconds, seconds
from tracker.geometry import so3
from tracker.messages import CameraImuSample
from tracker.simulation.head import Head
from tracker.simulation.smooth import rng_for

STEP = 2e-3
"""Step of the differences, s: a head sways in seconds."""


@dataclass(frozen=True)
class CameraImuParams:
    """Biases are standard deviations of one draw per axis."""

    rate_hz: float = 200.0
    gyro_noise_deg: float = 0.014  # °/s/√Hz
    accel_noise_ug: float = 150.0  # µg/√Hz
    gyro_bias_deg: float = 0.3  # °/s
    accel_bias_mg: float = 10.0
    latency: float = 0.003  # s from sampling to arrival


def camera_imu_samples(
    head: Head, seed: int, end: float, params: CameraImuParams | None = None
) -> Iterator[CameraImuSample]:
    """All samples until ``end`` (s), in order."""
    p = params or CameraImuParams()
    rng = rng_for(seed, "camera imu")
    root = np.sqrt(p.rate_hz / 2)  # a density's noise per sample
    gyro_sd = np.deg2rad(p.gyro_noise_deg) * root
    accel_sd = p.accel_noise_ug * 1e-6 * GRAVITY * root
    gyro_bias = np.deg2rad(rng.normal(0, p.gyro_bias_deg, 3))
    accel_bias = rng.normal(0, p.accel_bias_mg * 1e-3 * GRAVITY, 3)
    for k in range(int(end * p.rate_hz)):
        t = seconds(nanoseconds(k / p.rate_hz))
        before, now, after = (head.pose(t + d) for d in (-STEP, 0.0, STEP))
        turn = so3.log(before.R_GC.T @ after.R_GC) / (2 * STEP)
        a_G = (after.p_GC - 2 * now.p_GC + before.p_GC) / STEP**2
        force = now.R_GC.T @ (a_G + np.array([0.0, 0.0, GRAVITY]))
        yield CameraImuSample(
            t=t,
            t_arrival=seconds(nanoseconds(t + p.latency)),
            gyro=turn + gyro_bias + rng.normal(0, gyro_sd, 3),
            accel=force + accel_bias + rng.normal(0, accel_sd, 3),
        )
