"""One finger's two joints from its two IMUs, on a dorsum whose pose is known (Lemak et al. 2020).

The finger moves in a flexion plane that is fixed to the dorsum; its normal is the flexion axis of
the first joint at rest. Abduction is not tracked ("for pointing and grasping it need not be").
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.records import record
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.inertial.finger3d_estimators import (
    PlaneFinger,
    PlaneSavedState,
    QuaternionFinger,
    QuaternionSavedState,
)
from tracker.inertial.geometry3d import DorsumMotion, FingerGeometry
from tracker.inertial.madgwick import ADAPTIVE, MadgwickParams
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
