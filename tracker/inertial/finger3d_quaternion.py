"""The modified Madgwick filter in quaternion form, both IMUs of a finger (section 2.3).

Two vectors correct each gyro-integrated orientation: the specific force, compared with gravity plus
the acceleration of the chain below the sensor, and the flexion plane's normal, which the dorsum's
pose gives and which takes the place of the magnetic field.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.geometry import so3
from tracker.inertial.descent import NORMAL_B, descend, integrate_rates
from tracker.inertial.geometry3d import DorsumMotion, FingerGeometry, chain_accelerations, force_at
from tracker.inertial.madgwick import MadgwickParams
from tracker.messages import Array


@record("finger.moment", shapes={"gyro": "2 3", "accel": "2 3"})
class _Moment(NamedTuple):
    """Data of one sample: gyro, accel (2, 3) in B; w_B (3,) of the dorsum, its R_GB (3, 3)."""

    gyro: Array
    accel: Array
    dorsum: DorsumMotion


@record("finger.quaternion", shapes={"q_GB": "2 4"})
@dataclass(eq=False)
class QuaternionKept:
    """All of it that changes: q_GB (2, 4) xyzw, None before the first sample, and the last two
    samples, newest last."""

    q_GB: Array | None
    past: list[_Moment]


class QuaternionFinger:
    """q_GB of both phalanges by gradient descent; central differences, so one sample late.

    Lemak et al. 2020, doi:10.3390/computers9020040, section 2.3: eqs. 10 to 12, 15 and 18.
    """

    def __init__(
        self,
        geometry: FingerGeometry,
        dt: float,
        params: MadgwickParams,
        flexion: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        self._geometry, self._dt, self._params = geometry, dt, params
        self._start = flexion
        self._q_GB: Array | None = None  # (2, 4) xyzw
        self._past: list[_Moment] = []  # the last two samples, newest last

    def update(self, dorsum: DorsumMotion, gyro: Array, accel: Array) -> tuple[Array, Array]:
        """R_01, R_12 from the dorsum and both IMUs (2, 3)."""
        if self._q_GB is None:
            self._q_GB = self._start_orientations(dorsum.R_GB)
        now = _Moment(gyro, accel, dorsum)
        if len(self._past) == 2:
            self._correct(self._past[1], self._past[0], now)
        if self._past:
            middle = 0.5 * (gyro + self._past[-1].gyro)
            integrate_rates(self._q_GB, middle, self._dt)  # eq. 10
        self._past = [*self._past[-1:], now]
        R_G0, R_G1 = so3.matrix_from_quat(self._q_GB)
        return dorsum.R_GB.T @ R_G0, R_G0.T @ R_G1

    @property
    def kept(self) -> QuaternionKept:
        """All that changes, as it is: for a copy."""
        return QuaternionKept(self._q_GB, self._past)

    @kept.setter
    def kept(self, value: QuaternionKept) -> None:
        self._q_GB, self._past = value.q_GB, value.past

    def _start_orientations(self, R_GB: Array) -> Array:
        """q_GB (2, 4) of both phalanges in the known start."""
        R_0 = R_GB @ self._geometry.R_rest_0 @ so3.ry(self._start[0])
        R_1 = R_0 @ self._geometry.R_rest_1 @ so3.ry(self._start[1])
        return so3.quat_from_matrix(np.stack([R_0, R_1]))

    def _correct(self, at: _Moment, before: _Moment, after: _Moment) -> None:
        """One descent step at the sample between two others."""
        assert self._q_GB is not None
        g, p, span = self._geometry, self._params, 2 * self._dt
        alpha_B = (after.dorsum.w_B - before.dorsum.w_B) / span
        root_G = at.dorsum.R_GB @ force_at(at.dorsum, alpha_B, g.joint_0)
        alpha = (after.gyro - before.gyro) / span
        levers = (g.sensor_0, g.joint_1, g.sensor_1)
        mu_G = chain_accelerations(self._q_GB, at.gyro, alpha, *levers)
        force_G = root_G + mu_G if p.compensate else np.stack([root_G, root_G])
        normal_G = at.dorsum.R_GB @ g.R_rest_0 @ NORMAL_B
        beta = np.full(2, p.beta)
        if p.spurious > 0:
            fallen = beta / (1 + (np.linalg.norm(mu_G, axis=1) / p.spurious) ** 2)
            beta = np.maximum(p.least, fallen)
        descend(self._q_GB, force_G, at.accel, normal_G, 2 * beta * self._dt)
