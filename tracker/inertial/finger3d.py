"""One finger's two joints from its two IMUs, on a dorsum whose pose is known (Lemak et al. 2020).

The finger moves in a flexion plane that is fixed to the dorsum; its normal is the flexion axis of
the first joint at rest. Abduction is not tracked ("for pointing and grasping it need not be").
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np

from tracker import GRAVITY
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.records import record
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.inertial.descent import NORMAL_B, descend, integrate_rates
from tracker.inertial.geometry3d import DorsumMotion, FingerGeometry, chain_accelerations, force_at
from tracker.inertial.learned import Learned
from tracker.inertial.learned_kernel import LearnedState
from tracker.inertial.madgwick import ADAPTIVE, MadgwickParams
from tracker.inertial.plane import ComplexArray, Levers, in_plane, runge_kutta
from tracker.inertial.switching import Switching, SwitchingParams, SwitchingState
from tracker.messages import Array

VARIANTS = ("switching", "switching_offset", "learned", "madgwick", "madgwick_adaptive")


class JointRotations(NamedTuple):
    """R_01 (3, 3) from the first phalanx's B to the dorsum's, R_12 from the second to the first."""

    R_01: Array
    R_12: Array


@record("finger.readings", shapes={"gyro": "2 3", "accel": "2 3"})
@dataclass(frozen=True, eq=False)
class ImuPair:
    """Readings of a finger's IMUs in their phalanges' B: gyro (2, 3) rad/s, accel (2, 3) m/s².

    A row with NaN stands for an IMU that did not answer.
    """

    gyro: Array
    accel: Array


@record("finger")
@dataclass(eq=False)
class FingerSavedState:
    """All of a finger's estimator that changes: the last sample, and what its variant keeps."""

    last: ImuPair | None
    inner: PlaneSavedState | QuaternionSavedState


class _Inner(Protocol):
    saved: Any

    def update(self, dorsum: DorsumMotion, gyro: Array, accel: Array) -> tuple[Array, Array]: ...


class FingerEstimator3D:
    """Both relative joint rotations of one finger, one sample at a time, every ``dt`` s: the
    estimators of Lemak et al. 2020, doi:10.3390/computers9020040, on a dorsum that moves.

    ``variant`` is one of VARIANTS; ``flexion`` (rad) of both joints is the known start.
    """

    def __init__(
        self,
        geometry: FingerGeometry,
        dt: float,
        variant: str = "switching",
        flexion: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        if variant not in VARIANTS:
            raise ConfigError(notice("engine.finger_estimator", name=variant, known=VARIANTS))
        self._inner: _Inner
        if variant.startswith("madgwick"):
            params = ADAPTIVE if variant == "madgwick_adaptive" else MadgwickParams()
            self._inner = QuaternionFinger(geometry, dt, params, flexion)
        else:
            self._inner = PlaneFinger(geometry, dt, variant, flexion)
        self._last: ImuPair | None = None

    def update(self, dorsum: DorsumMotion, imus: ImuPair) -> JointRotations:
        """Take one sample of dorsum and both IMUs."""
        held = _hold(imus, self._last)
        self._last = held
        return JointRotations(*self._inner.update(dorsum, held.gyro, held.accel))

    @property
    def saved(self) -> FingerSavedState:
        """The state to save, not copied."""
        return FingerSavedState(self._last, self._inner.saved)

    @saved.setter
    def saved(self, value: FingerSavedState) -> None:
        self._last, self._inner.saved = value.last, value.inner


def _hold(imus: ImuPair, last: ImuPair | None) -> ImuPair:
    """Rows that did not answer repeat the last ones: a rate changes little in one sample."""
    missing = ~np.isfinite(imus.gyro + imus.accel).all(axis=1, keepdims=True)
    if not missing.any():
        return imus
    if last is None:
        last = ImuPair(np.zeros((2, 3)), np.zeros((2, 3)))
    return ImuPair(
        np.where(missing, last.gyro, imus.gyro), np.where(missing, last.accel, imus.accel)
    )


def finger_geometry(hand: HandModel, glove: GloveModel, first: str, second: str) -> FingerGeometry:
    """Geometry of the finger whose IMUs sit on the segments ``first`` and its child ``second``."""
    imu_of = {imu.segment: imu for imu in glove.imus}
    for name in (first, second):
        if name not in imu_of:
            raise ConfigError(notice("glove.no_imu_on", glove=glove.name, segment=name))
    proximal, middle = (hand.segments[hand.index[name]] for name in (first, second))
    return FingerGeometry(
        joint_0=proximal.origin,
        joint_1=middle.origin,
        R_rest_0=proximal.R_rest,
        R_rest_1=middle.R_rest,
        sensor_0=imu_of[first].position,
        sensor_1=imu_of[second].position,
    )


def finger_pairs(hand: HandModel, glove: GloveModel) -> tuple[tuple[str, str], ...]:
    """Segments (first on the dorsum, its child) that carry a finger's two IMUs."""
    carrying = {imu.segment for imu in glove.imus}
    return tuple(
        (s.parent, s.name)
        for s in hand.segments
        if s.name in carrying
        and s.parent in carrying
        and hand.segments[hand.index[s.parent]].parent == hand.segments[0].name
    )


def flexion_angle(R_parentB: Array, R_rest: Array) -> float:
    """Angle (rad) about the flexion axis of a joint rotation, -π/2 to 3π/2."""
    R = R_rest.T @ R_parentB
    angle = float(np.arctan2(R[0, 2] - R[2, 0], R[0, 0] + R[2, 2]))
    return angle + 2 * np.pi if angle < -np.pi / 2 else angle


# ---- estimators of one finger, with two IMUs, on a dorsum that moves in three dimensions
#
# `PlaneFinger`: a planar estimator in the flexion plane. P is fixed in that plane, which moves
# with the dorsum, so θ is each phalanx against the dorsum. The dorsum's rate about the plane's
# normal is the rate at which P turns below the finger.
#
# The modified Madgwick filter in quaternion form (section 2.3): two vectors correct each gyro-
# integrated orientation, the specific force, compared with gravity plus the acceleration of the
# chain below the sensor, and the flexion plane's normal, which the dorsum's pose gives and which
# replaces the magnetic field.

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
