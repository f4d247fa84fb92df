"""Our planar estimator: a Kalman filter that learns the sensors' offsets while the pose is known.

Per sensor the state is (θ, b_g, b_x, b_z): the phalanx's angle, the gyroscope's offset and both
in-plane offsets of the accelerometer. Offsets become observable when the pose is known: during the
static start, at rests and through `correct` (vision). Accelerometers are compared with gravity plus
the acceleration the chain's own motion predicts (eq. 2 of Lemak et al. 2020); angular acceleration
is a central difference, so they are used one sample late and the state is carried on to now.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker import GRAVITY
from tracker.inertial import learned_kernel as kernel
from tracker.inertial.planar import PlanarReadings, WithState, start_angles
from tracker.inertial.plane import SENSORS, ComplexArray, Levers
from tracker.messages import Array


@dataclass(frozen=True)
class LearnedParams:
    """Noises per √Hz, standard deviations at the start, and when a pose counts as known."""

    gyro_noise: float = np.deg2rad(0.01)  # rad/s/√Hz, MPU-9250
    accel_noise: float = 300e-6 * GRAVITY  # m/s²/√Hz, MPU-9250
    start_sd: float = np.deg2rad(0.05)  # rad, of the known start
    gyro_offset_sd: float = np.deg2rad(5.0)  # rad/s
    accel_offset_sd: float = 60e-3 * GRAVITY  # m/s²
    gyro_walk: float = 2e-6  # rad/s/√s
    accel_walk: float = 5e-5  # m/s²/√s
    lever_share: float = 0.05  # of |μ|: what finger lengths and differentiation leave
    static_start: float = 0.2  # s for which the wearer holds the known pose, if the sensors agree
    rest_time: float = 0.5  # s of stillness that make a rest
    rest_gyro: float = np.deg2rad(1.5)  # rad/s within which a rest's rates stay
    rest_accel: float = 0.3  # m/s² within which its readings stay
    rest_rate_sd: float = np.deg2rad(1.0)  # rad/s that an unnoticed slow motion may have


class Learned(WithState[kernel.LearnedState]):
    """Angles and offsets of the two sensors of one finger. Its model of the sensors' accelerations
    is that of Lemak et al. 2020, doi:10.3390/computers9020040, eq. 2; the filter is ours.
    """

    def __init__(
        self,
        dt: float,
        levers: Levers,
        params: LearnedParams | None = None,
        theta: Array | tuple[float, float] = (0.0, 0.0),
    ) -> None:
        p = params or LearnedParams()
        self.params = p
        self._model = kernel.Model(
            dt=dt,
            levers=levers,
            gyro_sd=p.gyro_noise * float(np.sqrt(0.5 / dt)),
            accel_sd=p.accel_noise * float(np.sqrt(0.5 / dt)),
            gyro_walk=p.gyro_walk,
            accel_walk=p.accel_walk,
            lever_share=p.lever_share,
            static_samples=p.static_start / dt,
            rest_samples=p.rest_time / dt,
            rest_gyro=p.rest_gyro,
            rest_accel=p.rest_accel,
            rest_sd=p.rest_rate_sd / float(np.sqrt(dt)),
        )
        super().__init__(kernel.start(start_angles(theta), _start_covariance(p)))

    @property
    def gyro_offset(self) -> Array:
        """(2,) rad/s."""
        return self._state.x[:, 1].copy()

    @property
    def accel_offset(self) -> ComplexArray:
        """(2,) m/s² in the plane of each phalanx."""
        return np.asarray(self._state.x[:, 2] + 1j * self._state.x[:, 3], complex)

    @property
    def angle_sd(self) -> Array:
        """(2,) rad."""
        return np.sqrt(self._state.P[:, 0, 0])

    def turn(self, angle: float) -> None:
        """P's own axes have turned by ``angle`` rad in the plane since the last sample."""
        self._state.x[:, 0] -= angle
        self._state.root[0] *= np.exp(-1j * angle)

    def update(self, gyro: Array, accel: ComplexArray, root: complex) -> Array:
        kernel.step(self._state, self._model, gyro, accel, root)
        return self._state.x[:, 0].copy()

    def correct(self, theta: Array, sd: float) -> Array:
        """Take angles (2,) rad in P that something else knows, each with ``sd`` rad; NaN: not."""
        for k in range(SENSORS):
            if np.isfinite(theta[k]):
                kernel.correct_angle(self._state, k, float(theta[k]), sd * sd)
        return self._state.x[:, 0].copy()

    def run(self, readings: PlanarReadings) -> Array:
        out = np.empty(readings.gyro.shape)
        gyro, accel, root = readings
        kernel.run(self._state, self._model, gyro, accel, root, out)
        return out


class KnownStart(NamedTuple):
    """Variances of θ, b_g, b_x, b_z."""

    theta: float
    gyro: float
    along: float
    palmar: float


def _start_covariance(p: LearnedParams) -> KnownStart:
    accel = p.accel_offset_sd**2
    return KnownStart(p.start_sd**2, p.gyro_offset_sd**2, accel, accel)
