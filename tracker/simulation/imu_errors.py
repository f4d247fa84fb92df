"""Errors of the IMUs of one glove, constant over its sessions (MPU-9250, PS-MPU-9250A-01)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker import GRAVITY
from tracker.messages import Array
from tracker.simulation.smooth import rng_for


@dataclass(frozen=True)
class ImuParams:
    """Errors of an IMU; biases and scales are standard deviations of one draw per axis."""

    rate_hz: float = 100.0
    gyro_noise_deg: float = 0.01  # °/s/√Hz
    accel_noise_ug: float = 300.0  # µg/√Hz
    gyro_bias_deg: float = 1.5  # °/s
    accel_bias_mg: float = 25.0
    gyro_bias_limit_deg: float = 5.0  # the data sheet's ±5 °/s and ±60 mg
    accel_bias_limit_mg: float = 60.0
    gyro_walk_deg: float = 0.05  # °/s, slow part
    accel_walk_mg: float = 1.0
    walk_time: float = 40.0  # s, correlation of the slow part
    gyro_scale: float = 0.01
    accel_scale: float = 0.01
    scale_limit: float = 0.03  # the data sheet's ±3 % and ±2 %
    cross_axis: float = 0.007  # of both, for each pair of axes
    cross_axis_limit: float = 0.02
    g_sensitivity_deg: float = 0.06  # °/s/g, of each axis of the gyroscope to each acceleration
    gyro_slope_deg: float = 0.08  # °/s/°C; limit: ±30 °/s from -40 to 85 °C
    gyro_slope_limit_deg: float = 0.24
    accel_slope_mg: float = 0.5  # mg/°C; limit: the data sheet's ±1.5 mg/°C
    accel_slope_limit_mg: float = 1.5
    warm_up_c: float = 6.0  # °C, after switching on
    warm_up_time: float = 300.0  # s, time constant
    read_skew: float = 0.55e-3  # s from reading the first IMU to reading the last
    gyro_range_dps: float = 2000.0
    accel_range_g: float = 16.0
    skew_ppm: float = 50.0  # standard deviation of the glove clock's rate error
    latency: float = 0.003  # s from sampling to arrival
    jitter: float = 0.0005
    bunching: float = 0.0  # s, of a USB adapter: packets arrive in bursts at its multiples


class DrawnImuErrors:
    """Drawn once for each glove of ``n`` IMUs.

    gyro_bias and accel_bias (n, 3) rad/s and m/s² at 25 °C; gyro_slope and accel_slope (n, 3) per
    °C; gyro_matrix and accel_matrix (n, 3, 3): scale and cross-axis errors, measured = M true + b;
    g_sensitivity (n, 3, 3) rad/s per m/s².
    """

    def __init__(self, n: int, seed: int, p: ImuParams) -> None:
        rng = rng_for(seed, "imu errors")
        bias_limit, degree, mg = np.deg2rad(p.gyro_bias_limit_deg), np.deg2rad(1.0), 1e-3 * GRAVITY
        self.gyro_bias = _within(bias_limit, rng.normal(0, np.deg2rad(p.gyro_bias_deg), (n, 3)))
        self.accel_bias = mg * _within(
            p.accel_bias_limit_mg, rng.normal(0, p.accel_bias_mg, (n, 3))
        )
        gyro_scale = _within(p.scale_limit, rng.normal(0, p.gyro_scale, (n, 3)))
        accel_scale = _within(p.scale_limit, rng.normal(0, p.accel_scale, (n, 3)))
        more = rng_for(seed, "imu axes")
        self.gyro_matrix = _matrices(gyro_scale, more, p)
        self.accel_matrix = _matrices(accel_scale, more, p)
        self.g_sensitivity: Array = (
            more.normal(0, p.g_sensitivity_deg, (n, 3, 3)) * degree / GRAVITY
        )
        slope_deg = more.normal(0, p.gyro_slope_deg, (n, 3))
        self.gyro_slope = degree * _within(p.gyro_slope_limit_deg, slope_deg)
        slope_mg = more.normal(0, p.accel_slope_mg, (n, 3))
        self.accel_slope = mg * _within(p.accel_slope_limit_mg, slope_mg)

    def measured_rate(self, rate: Array, force: Array) -> Array:
        """rate (t, n, 3) rad/s as measured under the specific force (t, n, 3) m/s², at 25 °C."""
        turned: Array = np.einsum("nij,tnj->tni", self.gyro_matrix, rate)
        shaken: Array = np.einsum("nij,tnj->tni", self.g_sensitivity, force)
        return turned + shaken + self.gyro_bias

    def measured_force(self, force: Array) -> Array:
        """force (t, n, 3) m/s² as measured at 25 °C."""
        measured: Array = np.einsum("nij,tnj->tni", self.accel_matrix, force)
        return measured + self.accel_bias


def _within(limit: float, value: Array) -> Array:
    clipped: Array = np.clip(value, -limit, limit)
    return clipped


def _matrices(scale: Array, rng: np.random.Generator, p: ImuParams) -> Array:
    """(n, 3, 3) of scale errors (n, 3)."""
    cross = _within(p.cross_axis_limit, rng.normal(0, p.cross_axis, (len(scale), 3, 3)))
    eye = np.eye(3)
    return cross * (1 - eye) + (1 + scale)[:, :, None] * eye
