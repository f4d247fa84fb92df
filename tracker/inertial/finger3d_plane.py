"""A finger's planar estimators on a dorsum that moves in three dimensions.

P stands still in the flexion plane as the dorsum carries it, so θ is each phalanx against the
dorsum. What the dorsum turns about the plane's normal, P turns under the finger.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from tracker import GRAVITY
from tracker.base.records import record
from tracker.geometry import so3
from tracker.inertial.geometry3d import DorsumMotion, FingerGeometry, force_at
from tracker.inertial.learned import Learned
from tracker.inertial.learned_kernel import LearnedState
from tracker.inertial.plane import ComplexArray, Levers, in_plane, runge_kutta
from tracker.inertial.switching import Switching, SwitchingParams, SwitchingState
from tracker.messages import Array

OFFSET = 60e-3 * GRAVITY  # m/s², zero-g tolerance of an MPU-9250


@record("finger.plane", shapes={"w": "3"})
@dataclass(eq=False)
class PlaneKept:
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
    def kept(self) -> PlaneKept:
        """All that changes, as it is: for a copy."""
        return PlaneKept(self._planar.state, self._w)

    @kept.setter
    def kept(self, value: PlaneKept) -> None:
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
