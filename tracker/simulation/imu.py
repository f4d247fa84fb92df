"""Measurements of seven MPU-9250 on a moving hand (InvenSense PS-MPU-9250A-01, tables 1 and 2)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tracker import GRAVITY
from tracker.base.clock import nanoseconds, seconds
from tracker.messages import Array, ImuSample
from tracker.simulation.motion import Motion
from tracker.simulation.smooth import SmoothNoise, rng_for
from tracker.simulation.wearer import Wearer

GRAVITY_G = np.array([0.0, 0.0, -GRAVITY])
STEP = 1e-3
"""Step of the central differences, s: an error of 3e-4 on a tremor of 10 Hz."""


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
    accel_scale: float = 0.005
    gyro_range_dps: float = 2000.0
    accel_range_g: float = 16.0
    skew_ppm: float = 50.0  # standard deviation of the glove clock's rate error
    latency: float = 0.003  # s from sampling to arrival
    jitter: float = 0.0005
    bunching: float = 0.0  # s, of a USB adapter: packets arrive in bursts at its multiples


class ImuSimulator:
    """Packets of one glove, by number; independent of the order of evaluation."""

    def __init__(
        self, wearer: Wearer, motion: Motion, seed: int, params: ImuParams | None = None
    ) -> None:
        self._wearer, self._motion, self._seed = wearer, motion, seed
        self.params = p = params or ImuParams()
        n = len(wearer.glove.imus)
        rng = rng_for(seed, "imu errors")
        bias_limit = np.deg2rad(p.gyro_bias_limit_deg)
        self.gyro_bias: Array = np.clip(
            rng.normal(0, np.deg2rad(p.gyro_bias_deg), (n, 3)), -bias_limit, bias_limit
        )
        limit_mg = p.accel_bias_limit_mg
        accel_mg = np.clip(rng.normal(0, p.accel_bias_mg, (n, 3)), -limit_mg, limit_mg)
        self.accel_bias: Array = accel_mg * 1e-3 * GRAVITY
        self._gyro_factor = 1 + rng.normal(0, p.gyro_scale, (n, 3))
        self._accel_factor = 1 + rng.normal(0, p.accel_scale, (n, 3))
        self._walk = SmoothNoise(rng, (2, n, 3), p.walk_time)
        self.period = (1 + 1e-6 * rng.normal(0, p.skew_ppm)) / p.rate_hz
        self._device_start = float(rng.uniform(0.5, 5.0))
        self._phase = float(rng.uniform(0, 1) / p.rate_hz)

    def times(self, first: int, count: int) -> Array:
        """True sampling instants (s) of packets first to first + count - 1, whole nanoseconds."""
        exact = self._phase + self.period * np.arange(first, first + count)
        return np.array([seconds(nanoseconds(float(t))) for t in exact])

    def samples(self, t0: float, t1: float) -> Iterator[ImuSample]:
        """All packets sampled from t0 up to t1 (s), in order, with the true instant as ``t``."""
        first = max(int(np.ceil((t0 - self._phase) / self.period)), 0)
        last = int(np.ceil((t1 - self._phase) / self.period))
        block = max(round(self.params.rate_hz), 1)  # noise is drawn one second at a time
        for b in range(first // block, -(-last // block)):
            yield from self._block(b, block, first, last)

    def _block(self, b: int, size: int, first: int, last: int) -> Iterator[ImuSample]:
        t = self.times(b * size, size)
        accel, gyro = self.measure(t, rng_for(self._seed, "imu noise", b))
        arrival = self._arrivals(t, rng_for(self._seed, "imu arrival", b))
        device = self._device_start + np.arange(b * size, (b + 1) * size) / self.params.rate_hz
        for k in range(max(first - b * size, 0), min(last - b * size, size)):
            valid = np.ones(accel.shape[1], bool)
            yield ImuSample(
                float(t[k]), float(arrival[k]), float(device[k]), b * size + k,
                accel[k].copy(), gyro[k].copy(), valid,
            )  # fmt: skip

    def _arrivals(self, t: Array, rng: np.random.Generator) -> Array:
        p = self.params
        arrival = t + p.latency + np.abs(rng.normal(0, p.jitter, len(t)))
        if p.bunching > 0:
            arrival = np.ceil(arrival / p.bunching) * p.bunching
        arrival = np.maximum.accumulate(arrival)
        return np.array([seconds(nanoseconds(float(a))) for a in arrival])

    def measure(self, t: Array, rng: np.random.Generator) -> tuple[Array, Array]:
        """accel (n, I, 3) m/s² and gyro (n, I, 3) rad/s with all errors, at the times t (s)."""
        p = self.params
        force, rate = true_imu(self._wearer, self._motion, t)
        walk = self._walk(t)
        gyro_noise = np.deg2rad(p.gyro_noise_deg) * np.sqrt(p.rate_hz / 2)
        accel_noise = p.accel_noise_ug * 1e-6 * GRAVITY * np.sqrt(p.rate_hz / 2)
        gyro = rate * self._gyro_factor + self.gyro_bias + rng.normal(0, gyro_noise, rate.shape)
        gyro += np.deg2rad(p.gyro_walk_deg) * walk[:, 0]
        accel = force * self._accel_factor + self.accel_bias
        accel += (
            rng.normal(0, accel_noise, force.shape) + p.accel_walk_mg * 1e-3 * GRAVITY * walk[:, 1]
        )
        return _digital(accel, p.accel_range_g * GRAVITY), _digital(
            gyro, np.deg2rad(p.gyro_range_dps)
        )


def true_imu(wearer: Wearer, motion: Motion, t: Array) -> tuple[Array, Array]:
    """Specific force (n, I, 3) m/s² and angular rate (n, I, 3) rad/s in each I, without errors.

    Central differences of second order: f = R_GIᵀ (p'' - g), ω = Log(R(t-h)ᵀ R(t+h)) / 2h.
    """
    t = np.asarray(t, float)
    R, p = wearer.imus(motion, np.concatenate([t - STEP, t, t + STEP]))
    n = len(t)
    acceleration = (p[:n] - 2 * p[n : 2 * n] + p[2 * n :]) / STEP**2
    turn = np.swapaxes(R[:n], -1, -2) @ R[2 * n :]
    rate = _small_log(turn) / (2 * STEP)
    # R(t±h) = R Exp(±ωh + αh²/2): the two halves of α cancel, so ω is that of I at t.
    force = np.einsum("tnji,tnj->tni", R[n : 2 * n], acceleration - GRAVITY_G)
    return force, rate


def _small_log(R: Array) -> Array:
    """Rotation vectors (…, 3) of rotations below 90° (…, 3, 3)."""
    v = np.stack(
        [R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]], -1
    )
    sine = np.linalg.norm(v, axis=-1, keepdims=True) / 2
    safe = np.maximum(sine, 1e-12)
    return v / 2 * np.where(sine < 1e-9, 1.0, np.arcsin(np.minimum(safe, 1.0)) / safe)


def _digital(value: Array, full_scale: float) -> Array:
    """The output of a 16-bit converter: clipped and rounded to full_scale / 32768."""
    lsb = full_scale / 32768
    out: Array = np.clip(np.round(value / lsb), -32768, 32767) * lsb
    return out
