"""Anatomy as pseudo-measurements: fixed joint axes, joint limits, synergies.

With R_rel = R_rest^T R_GBa^T R_GBc = Rz(abduction) Ry(flexion) Rx(twist), a joint without twist has
e_z^T R_rel e_y = 0 and a hinge e_x^T R_rel e_y = 0 as well: smooth for every angle, unlike the
angles themselves. (A joint free to twist has no such linear form and is left free.) Equation
numbers are those of docs/chain.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.layout import Blocks, ChainLayout
from tracker.fusion.chain.params import ConstraintParams
from tracker.fusion.chain.state import ChainState
from tracker.geometry.kernels import cross3, rotate, rotate_back, tmul3, zyx3
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector, Written
from tracker.messages import Array


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


class Joints(NamedTuple):
    """For the A active segments: parent (A,), R_rest (A, 3, 3)."""

    parent: IntVector
    R_rest: Stack


class Oblique(NamedTuple):
    """R_GB (A, 3, 3) of the active segments, and value (k,) of each axis row for this wearer."""

    R_GB: Stack
    value: Vector


class AxisRows(NamedTuple):
    """`Axis` of all axes: child (k,), e and f (k, 3), variance (k,)."""

    child: IntVector
    e: Matrix
    f: Matrix
    variance: Vector


class FlexionRows(NamedTuple):
    """`Flexion` of all joints: child, source (k,), numbers (k, 4) low, high, ratio, offset; and
    the variances of a limit and of a synergy."""

    child: IntVector
    source: IntVector
    numbers: Matrix
    limit: float
    synergy: float


class Constraints:
    """The rows that one hand with one glove has."""

    def __init__(self, layout: ChainLayout, params: ConstraintParams) -> None:
        self._blocks, self._joints = layout.blocks, Joints(layout.parent, layout.R_rest)
        axes, flexions = _axes(layout, params), _flexions(layout)
        self.axes, self.flexions = tuple(axes), tuple(flexions)
        self._axis_rows = AxisRows(
            np.array([a.child for a in axes], np.int64),
            np.array([a.e for a in axes]).reshape(-1, 3),
            np.array([a.f for a in axes]).reshape(-1, 3),
            np.array([a.sd**2 for a in axes], float),
        )
        self._flexion_rows = FlexionRows(
            np.array([f.child for f in flexions], np.int64),
            np.array([f.source for f in flexions], np.int64),
            np.array([[f.low, f.high, f.ratio, f.offset] for f in flexions]).reshape(-1, 4),
            params.limit**2,
            params.synergy**2,
        )

    def rows(self, state: ChainState) -> tuple[Array, Array, Array]:
        """Stacked H (m, N), innovation r (m,), variances (m,).

        A limit contributes a row only where it is exceeded.
        """
        oblique = Oblique(state.R_GB, state.axis)
        return _rows(self._blocks, self._joints, oblique, self._axis_rows, self._flexion_rows)


@kernel
def _relative(joints: Joints, R_GB: Stack, child: int) -> Matrix:
    """R_rel (3, 3) of the joint at ``child``."""
    return tmul3(joints.R_rest[child], tmul3(R_GB[joints.parent[child]], R_GB[child]))


@kernel
def _put(
    h: Written[Vector],
    at: Blocks,
    joints: Joints,
    child: int,
    J_a: Vector,
    J_c: Vector,
    gain: float,
) -> None:
    """Add a row's derivatives by the parent's and the child's orientation."""
    for r in range(3):
        h[at.theta + 3 * joints.parent[child] + r] += gain * J_a[r]
        h[at.theta + 3 * child + r] += gain * J_c[r]


@kernel
def _put_flexion(
    h: Written[Vector], at: Blocks, joints: Joints, R_GB: Stack, child: int, gain: float
) -> None:
    """Adds derivatives; flexion turns about the child's own y (its twist being small; eq. 36)."""
    y = np.array([0.0, 1.0, 0.0])
    R = _relative(joints, R_GB, child)
    _put(h, at, joints, child, -rotate(joints.R_rest[child], rotate(R, y)), y, gain)


@kernel(nogil=False)
def _rows(
    at: Blocks, joints: Joints, oblique: Oblique, axes: AxisRows, flexions: FlexionRows
) -> tuple[Matrix, Vector, Vector]:
    """`Constraints.rows`."""
    R_GB, n = oblique.R_GB, len(axes.child)
    most = n + 2 * len(flexions.child)
    H, r, var = np.zeros((most, at.size)), np.zeros(most), np.zeros(most)
    # 1. fixed axes: e^T R_rest^T Exp(-theta_a) R_a^T R_c Exp(theta_c) f (eq. 35)
    for k in range(n):
        c, e, f = axes.child[k], axes.e[k], axes.f[k]
        R = _relative(joints, R_GB, c)
        J_a = rotate(joints.R_rest[c], cross3(e, rotate(R, f)))
        _put(H[k], at, joints, c, J_a, cross3(f, rotate_back(R, e)), 1.0)
        H[k, at.axis + k] = -1.0
        r[k] = oblique.value[k] - np.dot(e, rotate(R, f))
        var[k] = axes.variance[k]
    m = n
    for k in range(len(flexions.child)):
        c, s = flexions.child[k], flexions.source[k]
        low, high, ratio, offset = flexions.numbers[k]
        value = zyx3(_relative(joints, R_GB, c))[1]
        # 2. limits, where they are exceeded (eq. 36)
        bound = min(max(value, low), high)
        if bound != value:
            _put_flexion(H[m], at, joints, R_GB, c, 1.0)
            r[m], var[m] = bound - value, flexions.limit
            m += 1
        # 3. synergies (eq. 36)
        if s >= 0:
            source = zyx3(_relative(joints, R_GB, s))[1]
            _put_flexion(H[m], at, joints, R_GB, c, 1.0)
            _put_flexion(H[m], at, joints, R_GB, s, -ratio)
            r[m], var[m] = ratio * source + offset - value, flexions.synergy
            m += 1
    return H[:m], r[:m], var[:m]


def _axes(layout: ChainLayout, params: ConstraintParams) -> list[Axis]:
    return [
        Axis(a.child, a.e, a.f, params.stiff_abduction if a.stiff else params.rotation)
        for a in layout.fixed_axes
    ]


def _flexions(layout: ChainLayout) -> list[Flexion]:
    hand = layout.hand
    source, gain = layout.drive.source, layout.drive.gain
    out: list[Flexion] = []
    for child, name in enumerate(layout.names):
        joint = hand.joint_of.get(name)
        if joint is None or "flexion" not in joint.axes:
            continue
        low, high = joint.limits["flexion"]
        ratio, offset = gain[child]
        out.append(Flexion(child, low, high, int(source[child]), ratio, offset))
    return out
