"""Measurements of seven MPU-9250 on a moving hand (InvenSense PS-MPU-9250A-01, tables 1 and 2)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from tracker import GRAVITY
from tracker.base.clock import nanoseconds, seconds
from tracker.messages import Array, ImuSample
from tracker.simulation.imu_errors import DrawnImuErrors, ImuParams
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.smooth import SmoothNoise, rng_for
from tracker.simulation.wearer import Wearer

GRAVITY_G = np.array([0.0, 0.0, -GRAVITY])
STEP = 1e-3
"""Step of the central differences, s: an error of 3e-4 on a tremor of 10 Hz."""
ROOM_C = 25.0
"""Temperature at which the biases are those of `DrawnImuErrors`, °C."""
COLD_C, COLD_SD_C = 26.0, 1.5
"""For the first chip when the glove is switched on, °C: mean and standard deviation of sessions."""
IMU_APART_C = 0.3
"""Difference between neighbouring IMUs, °C."""


class ImuSimulator:
    """Packets of one glove, by number; independent of the order of evaluation."""

    def __init__(
        self,
        wearer: Wearer,
        motion: SimulatedMotion,
        seed: int,
        params: ImuParams | None = None,
        device: int | None = None,
    ) -> None:
        """``device`` is the seed of the glove's own errors, for several sessions with one glove;
        default: ``seed``."""
        self._wearer, self._motion, self._seed = wearer, motion, seed
        self.params = p = params or ImuParams()
        n = len(wearer.glove.imus)
        self.errors = DrawnImuErrors(n, seed if device is None else device, p)
        rng = rng_for(seed, "imu errors")
        rng.normal(0, 1, (4, n, 3))  # drawn by `DrawnImuErrors` if both seeds are the same
        self._walk = SmoothNoise(rng, (2, n, 3), p.walk_time)
        self._late = np.linspace(0, p.read_skew, n) if p.read_skew and n > 1 else None
        self._cold_c = COLD_C + float(rng_for(seed, "imu temperature").normal(0, COLD_SD_C))
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
            valid = ~(at_end(accel[k], self._full_scale[0]) | at_end(gyro[k], self._full_scale[1]))
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

    @property
    def _full_scale(self) -> tuple[float, float]:
        """m/s² and rad/s of a raw value of 32768."""
        return self.params.accel_range_g * GRAVITY, float(np.deg2rad(self.params.gyro_range_dps))

    def temperature(self, t: Array) -> Array:
        """(n, I) °C of each chip at the times t (n,) s."""
        p = self.params
        rise = p.warm_up_c * (1 - np.exp(-np.maximum(t, 0.0) / p.warm_up_time))
        return self._cold_c + IMU_APART_C * np.arange(len(self.errors.gyro_bias)) + rise[:, None]

    def measure(self, t: Array, rng: np.random.Generator) -> tuple[Array, Array]:
        """accel (n, I, 3) m/s² and gyro (n, I, 3) rad/s with all errors, at the times t (s)."""
        p, errors = self.params, self.errors
        force, rate = true_imu(self._wearer, self._motion, t, self._late)
        walk = self._walk(t)
        warmer = (self.temperature(t) - ROOM_C)[..., None]
        gyro_noise = np.deg2rad(p.gyro_noise_deg) * np.sqrt(p.rate_hz / 2)
        accel_noise = p.accel_noise_ug * 1e-6 * GRAVITY * np.sqrt(p.rate_hz / 2)
        gyro = errors.measured_rate(rate, force) + rng.normal(0, gyro_noise, rate.shape)
        gyro += warmer * errors.gyro_slope + np.deg2rad(p.gyro_walk_deg) * walk[:, 0]
        accel = errors.measured_force(force) + rng.normal(0, accel_noise, force.shape)
        accel += warmer * errors.accel_slope + p.accel_walk_mg * 1e-3 * GRAVITY * walk[:, 1]
        accel_scale, gyro_scale = self._full_scale
        return _digital(accel, accel_scale), _digital(gyro, gyro_scale)


def true_imu(
    wearer: Wearer, motion: SimulatedMotion, t: Array, late: Array | None = None
) -> tuple[Array, Array]:
    """Specific force (n, I, 3) m/s² and angular rate (n, I, 3) rad/s in each I, without errors.

    ``late`` (I,) s, at most `STEP`: the delay after t at which each IMU is read.

    Central differences of second order: f = R_GIᵀ (p'' - g), ω = Log(R(t-h)ᵀ R(t+h)) / 2h.
    """
    t = np.asarray(t, float)
    steps = (-1, 0, 1) if late is None else (-1, 0, 1, 2)
    R, p = wearer.imus(motion, np.concatenate([t + k * STEP for k in steps]))
    R, p = (x.reshape(len(steps), len(t), *x.shape[1:]) for x in (R, p))
    force, rate = _differences(R[:3], p[:3])
    if late is None:
        return force, rate
    next_force, next_rate = _differences(R[1:], p[1:])
    share = (late / STEP)[:, None]
    return force + share * (next_force - force), rate + share * (next_rate - rate)


def _differences(R: Array, p: Array) -> tuple[Array, Array]:
    """Force and rate at the middle of three instants, from R (3, n, I, 3, 3), p (3, n, I, 3)."""
    acceleration = (p[0] - 2 * p[1] + p[2]) / STEP**2
    turn = np.swapaxes(R[0], -1, -2) @ R[2]
    rate = _small_log(turn) / (2 * STEP)
    # R(t±h) = R Exp(±ωh + αh²/2): the two halves of α cancel, so ω is that of I at t.
    force = np.einsum("tnji,tnj->tni", R[1], acceleration - GRAVITY_G)
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


def at_end(value: Array, full_scale: float) -> NDArray[np.bool_]:
    """Which IMUs (I,) have an axis at the end of its range, from values (I, 3) of a converter."""
    lsb = full_scale / 32768
    return np.asarray((np.abs(value) > full_scale - 1.5 * lsb).any(axis=1))
