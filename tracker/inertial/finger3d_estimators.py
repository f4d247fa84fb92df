"""Estimators of one finger, with two IMUs, on a dorsum that moves in three dimensions.

`PlaneFinger`: a planar estimator in the flexion plane. P is fixed in that plane, which moves with
the dorsum, so θ is each phalanx against the dorsum. The dorsum's rate about the plane's normal is
the rate at which P turns below the finger.

The modified Madgwick filter in quaternion form (section 2.3): two vectors correct each
gyro-integrated orientation, the specific force, compared with gravity plus the acceleration of the
chain below the sensor, and the flexion plane's normal, which the dorsum's pose gives and which
replaces the magnetic field.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np

from tracker import GRAVITY
from tracker.base.records import record
from tracker.geometry import so3
from tracker.inertial.descent import NORMAL_B, descend, integrate_rates
from tracker.inertial.geometry3d import DorsumMotion, FingerGeometry, chain_accelerations, force_at
from tracker.inertial.learned import Learned
from tracker.inertial.learned_kernel import LearnedState
from tracker.inertial.madgwick import MadgwickParams
from tracker.inertial.plane import ComplexArray, Levers, in_plane, runge_kutta
from tracker.inertial.switching import Switching, SwitchingParams, SwitchingState
from tracker.messages import Array

OFFSET = 60e-3 * GRAVITY  # m/s², zero-g tolerance of an MPU-9250


@record("finger.plane", shapes={"w": "3"})
@dataclass(eq=False)
class PlaneSavedState:
    """All of a planar finger that changes: its estimator's state, and the dorsum's last two rates
    (3,) rad/s, newest last."""

    planar: SwitchingState | LearnedState
    w: list[Array]


class _Planar(Protocol):
    state: Any

    def turn(self, angle: float) -> None: ...

    def update(self, gyro: Array, accel: ComplexArray, root: complex) -> Array: ...


class PlaneFinger:
    """`switching`, `switching_offset` or `learned` for one finger of a real glove.

    Lemak et al. 2020, doi:10.3390/computers9020040, sections 2.2.4 and 2.2.5, in its own plane.
    """

    def __init__(
        self,
        geometry: FingerGeometry,
        dt: float,
        variant: str,
        flexion: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        self._geometry, self._dt = geometry, dt
        R = geometry.R_rest_1
        self._rest_1 = float(np.arctan2(R[0, 2], R[0, 0]))  # a bend of the straight finger
        theta = (flexion[0], flexion[0] + self._rest_1 + flexion[1])
        self._planar: _Planar = _planar(variant, dt, _levers(geometry), theta)
        self._w: list[Array] = []  # the dorsum's last two rates, newest last

    def update(self, dorsum: DorsumMotion, gyro: Array, accel: Array) -> tuple[Array, Array]:
        """R_01, R_12 from the dorsum and both IMUs (2, 3)."""
        g = self._geometry
        self._planar.turn(self._turned(dorsum.w_B))
        alpha = self._alpha(dorsum.w_B)
        root_B = force_at(dorsum, alpha, g.joint_0)
        root = complex(in_plane(g.R_rest_0.T @ root_B))
        theta = self._planar.update(gyro[:, 1].copy(), in_plane(accel), root)
        self._w = [*self._w[-1:], dorsum.w_B.copy()]
        flexion_1 = theta[1] - theta[0] - self._rest_1
        return g.R_rest_0 @ so3.ry(theta[0]), g.R_rest_1 @ so3.ry(flexion_1)

    @property
    def saved(self) -> PlaneSavedState:
        """The state to save, not copied."""
        return PlaneSavedState(self._planar.state, self._w)

    @saved.setter
    def saved(self, value: PlaneSavedState) -> None:
        self._planar.state, self._w = value.planar, value.w

    def _turned(self, w_B: Array) -> float:
        """Angle (rad) by which the dorsum has turned about the plane's normal since last time."""
        if not self._w:
            return 0.0
        normal = self._geometry.R_rest_0[:, 1]
        new, last = float(w_B @ normal), float(self._w[-1] @ normal)
        older = float(self._w[0] @ normal) if len(self._w) > 1 else 2 * last - new
        return float(runge_kutta(new, last, older, self._dt))

    def _alpha(self, w_B: Array) -> Array:
        """The dorsum's angular acceleration, rad/s², by a backward difference."""
        if not self._w:
            return np.zeros(3)
        alpha: Array = (w_B - self._w[-1]) / self._dt
        return alpha


def _planar(
    variant: str, dt: float, levers: Levers, theta: tuple[float, float]
) -> Switching | Learned:
    if variant == "learned":
        return Learned(dt, levers, theta=theta)
    if variant == "switching_offset":
        return Switching(dt, levers, SwitchingParams.with_offset(OFFSET), theta)
    return Switching(dt, levers, SwitchingParams(longest=abs(levers.length_0)), theta)


def _levers(geometry: FingerGeometry) -> Levers:
    """The geometry's levers in the plane."""
    g = geometry
    return Levers(*(complex(in_plane(v)) for v in (g.sensor_0, g.joint_1, g.sensor_1)))


@record("finger.moment", shapes={"gyro": "2 3", "accel": "2 3"})
class _Moment(NamedTuple):
    """Data of one sample: gyro, accel (2, 3) in B; w_B (3,) of the dorsum, its R_GB (3, 3)."""

    gyro: Array
    accel: Array
    dorsum: DorsumMotion


@record("finger.quaternion", shapes={"q_GB": "2 4"})
@dataclass(eq=False)
class QuaternionSavedState:
    """The saved state: q_GB (2, 4) xyzw, None before the first sample, and the last two
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
    def saved(self) -> QuaternionSavedState:
        """The state to save, not copied."""
        return QuaternionSavedState(self._q_GB, self._past)

    @saved.setter
    def saved(self, value: QuaternionSavedState) -> None:
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
