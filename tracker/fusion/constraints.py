"""Anatomy as pseudo-measurements: fixed joint axes, joint limits, synergies.

With R_rel = R_rest^T R_GBa^T R_GBc = Rz(abduction) Ry(flexion) Rx(twist), a joint without twist has
e_z^T R_rel e_y = 0 and a hinge e_x^T R_rel e_y = 0 as well: smooth for every angle, unlike the
angles themselves. (A joint free to twist has no such linear form and is left free.)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.layout import ChainLayout
from tracker.fusion.params import ConstraintParams
from tracker.fusion.state import ChainState
from tracker.geometry import so3
from tracker.messages import Array

E_X, E_Y, E_Z = np.eye(3)


@dataclass(frozen=True, eq=False)
class Axis:
    """One row e^T R_rel f = 0 of the joint at active segment ``child``."""

    child: int
    e: Array
    f: Array
    sd: float


@dataclass(frozen=True, eq=False)
class Flexion:
    """The flexion of the joint at active segment ``child``: limits and, without IMU, a synergy."""

    child: int
    low: float
    high: float
    source: int  # active child whose flexion drives this one, -1: none
    ratio: float
    offset: float


class Constraints:
    """The rows that one hand with one glove has."""

    def __init__(self, layout: ChainLayout, params: ConstraintParams) -> None:
        self._layout, self._params = layout, params
        self.axes = tuple(_axes(layout, params))
        self.flexions = tuple(_flexions(layout))

    def rows(self, state: ChainState) -> tuple[Array, Array, Array]:
        """Stacked H (m, N), innovation r (m,), variances (m,)."""
        H: list[Array] = []
        r: list[float] = []
        var: list[float] = []
        for axis in self.axes:
            h, value = self._axis_row(state, axis)
            H.append(h)
            r.append(-value)
            var.append(axis.sd**2)
        for flexion in self.flexions:
            self._flexion_rows(state, flexion, H, r, var)
        return np.array(H).reshape(-1, self._layout.size), np.array(r), np.array(var)

    def relative(self, state: ChainState, child: int) -> Array:
        """R_rel of the joint at ``child``."""
        lay = self._layout
        a = lay.parent[child]
        return lay.R_rest[child].T @ state.R_GB[a].T @ state.R_GB[child]

    def _axis_row(self, state: ChainState, axis: Axis) -> tuple[Array, float]:
        R = self.relative(state, axis.child)
        # e^T R_rest^T Exp(-beta_a) R_a^T R_c Exp(beta_c) f
        J_a = self._layout.R_rest[axis.child] @ np.cross(axis.e, R @ axis.f)
        J_c = np.cross(axis.f, R.T @ axis.e)
        return self._row(axis.child, J_a, J_c), float(axis.e @ R @ axis.f)

    def _row(self, child: int, J_a: Array, J_c: Array) -> Array:
        lay = self._layout
        a = int(lay.parent[child])
        h = np.zeros(lay.size)
        h[lay.theta + 3 * a : lay.theta + 3 * a + 3] = J_a
        h[lay.theta + 3 * child : lay.theta + 3 * child + 3] = J_c
        return h

    def flexion(self, state: ChainState, child: int) -> float:
        """Flexion of the joint at ``child``, rad, continuous through ±90°."""
        return so3.zyx_from_matrix(self.relative(state, child))[1]

    def _flexion_row(self, state: ChainState, child: int) -> Array:
        """Flexion turns about the child's own y (its twist being small)."""
        R = self.relative(state, child)
        y_in_parent = self._layout.R_rest[child] @ (R @ E_Y)
        return self._row(child, -y_in_parent, E_Y)

    def _flexion_rows(
        self,
        state: ChainState,
        flexion: Flexion,
        H: list[Array],
        r: list[float],
        var: list[float],
    ) -> None:
        value = self.flexion(state, flexion.child)
        bound = min(max(value, flexion.low), flexion.high)
        if bound != value:
            H.append(self._flexion_row(state, flexion.child))
            r.append(bound - value)
            var.append(self._params.limit**2)
        if flexion.source >= 0:
            wanted = flexion.ratio * self.flexion(state, flexion.source) + flexion.offset
            row = self._flexion_row(state, flexion.child)
            H.append(row - flexion.ratio * self._flexion_row(state, flexion.source))
            r.append(wanted - value)
            var.append(self._params.synergy**2)


def _axes(layout: ChainLayout, params: ConstraintParams) -> list[Axis]:
    out: list[Axis] = []
    for child, name in enumerate(layout.names):
        joint = layout.hand.joint_of.get(name)
        if layout.parent[child] < 0:
            continue
        free = () if joint is None else joint.axes
        if "twist" in free:
            continue
        out.append(Axis(child, E_Z, E_Y, params.rotation))
        if "abduction" not in free:
            out.append(Axis(child, E_X, E_Y, params.rotation))
        elif name == "thumb_proximal":
            out.append(Axis(child, E_X, E_Y, params.thumb_abduction))
        if "flexion" not in free:
            out.append(Axis(child, E_X, E_Z, params.rotation))
    return out


def _flexions(layout: ChainLayout) -> list[Flexion]:
    hand = layout.hand
    synergies = {s.angle: s for s in hand.synergies}
    child_of = {f"{j.name}_flexion": hand.index[j.child] for j in hand.joints}
    out: list[Flexion] = []
    for child, name in enumerate(layout.names):
        joint = hand.joint_of.get(name)
        if joint is None or "flexion" not in joint.axes:
            continue
        low, high = joint.limits["flexion"]
        source, ratio, offset = -1, 0.0, 0.0
        s = synergies.get(f"{joint.name}_flexion")
        if s is not None and layout.imu_of[child] < 0 and child_of.get(s.of) in layout.row_of:
            source, ratio, offset = layout.row_of[child_of[s.of]], s.ratio, s.offset
        out.append(Flexion(child, low, high, source, ratio, offset))
    return out
