"""Anatomy as pseudo-measurements: fixed joint axes, joint limits, synergies.

With R_rel = R_rest^T R_GBa^T R_GBc = Rz(abduction) Ry(flexion) Rx(twist), a joint without twist has
e_z^T R_rel e_y = 0 and a hinge e_x^T R_rel e_y = 0 as well: smooth for every angle, unlike the
angles themselves. (A joint free to twist has no such linear form and is left free.)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ConstraintParams
from tracker.fusion.chain.state import ChainState
from tracker.geometry.kernels import cross3, rotate, rotate_back, tmul3, zyx3
from tracker.kernels import kernel
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
        axes, flexions = _axes(layout, params), _flexions(layout)
        self.axes, self.flexions = tuple(axes), tuple(flexions)
        self._axis_child = np.array([a.child for a in axes], np.int64)
        self._axis_e = np.array([a.e for a in axes]).reshape(-1, 3)
        self._axis_f = np.array([a.f for a in axes]).reshape(-1, 3)
        self._axis_var = np.array([a.sd**2 for a in axes])
        self._flexion_child = np.array([f.child for f in flexions], np.int64)
        self._flexion_source = np.array([f.source for f in flexions], np.int64)
        self._flexion_numbers = np.array(
            [[f.low, f.high, f.ratio, f.offset] for f in flexions]
        ).reshape(-1, 4)

    def rows(self, state: ChainState) -> tuple[Array, Array, Array]:
        """Stacked H (m, N), innovation r (m,), variances (m,).

        A limit gives a row only where it is passed.
        """
        lay = self._layout
        return _rows(
            lay.parent,
            lay.R_rest,
            state.R_GB,
            self._axis_child,
            self._axis_e,
            self._axis_f,
            self._axis_var,
            self._flexion_child,
            self._flexion_source,
            self._flexion_numbers,
            self._params.limit**2,
            self._params.synergy**2,
            lay.theta,
            lay.size,
        )


@kernel
def _relative(parent, R_rest, R_GB, child):  # type: ignore[no-untyped-def]
    return tmul3(R_rest[child], tmul3(R_GB[parent[child]], R_GB[child]))


@kernel
def _put(h, parent, theta, child, J_a, J_c, gain):  # type: ignore[no-untyped-def]
    """Add a row's derivatives by the parent's and the child's orientation."""
    for r in range(3):
        h[theta + 3 * parent[child] + r] += gain * J_a[r]
        h[theta + 3 * child + r] += gain * J_c[r]


@kernel
def _put_flexion(h, parent, R_rest, R_GB, theta, child, gain):  # type: ignore[no-untyped-def]
    """Flexion turns about the child's own y (its twist being small)."""
    y = np.array([0.0, 1.0, 0.0])
    R = _relative(parent, R_rest, R_GB, child)
    _put(h, parent, theta, child, -rotate(R_rest[child], rotate(R, y)), y, gain)


@kernel
def _rows(  # type: ignore[no-untyped-def]
    parent, R_rest, R_GB, axis_child, axis_e, axis_f, axis_var,
    flexion_child, flexion_source, flexion_numbers, limit_var, synergy_var, theta, size,
):  # fmt: skip
    n = len(axis_child)
    most = n + 2 * len(flexion_child)
    H, r, var = np.zeros((most, size)), np.zeros(most), np.zeros(most)
    for k in range(n):
        c, e, f = axis_child[k], axis_e[k], axis_f[k]
        R = _relative(parent, R_rest, R_GB, c)
        # e^T R_rest^T Exp(-beta_a) R_a^T R_c Exp(beta_c) f
        _put(
            H[k],
            parent,
            theta,
            c,
            rotate(R_rest[c], cross3(e, rotate(R, f))),
            cross3(f, rotate_back(R, e)),
            1.0,
        )
        r[k] = -np.dot(e, rotate(R, f))
        var[k] = axis_var[k]
    m = n
    for k in range(len(flexion_child)):
        c, s = flexion_child[k], flexion_source[k]
        low, high, ratio, offset = flexion_numbers[k]
        value = zyx3(_relative(parent, R_rest, R_GB, c))[1]
        bound = min(max(value, low), high)
        if bound != value:
            _put_flexion(H[m], parent, R_rest, R_GB, theta, c, 1.0)
            r[m], var[m] = bound - value, limit_var
            m += 1
        if s >= 0:
            source = zyx3(_relative(parent, R_rest, R_GB, s))[1]
            _put_flexion(H[m], parent, R_rest, R_GB, theta, c, 1.0)
            _put_flexion(H[m], parent, R_rest, R_GB, theta, s, -ratio)
            r[m], var[m] = ratio * source + offset - value, synergy_var
            m += 1
    return H[:m], r[:m], var[:m]


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
    source, gain = layout.drive
    out: list[Flexion] = []
    for child, name in enumerate(layout.names):
        joint = hand.joint_of.get(name)
        if joint is None or "flexion" not in joint.axes:
            continue
        low, high = joint.limits["flexion"]
        ratio, offset = gain[child]
        out.append(Flexion(child, low, high, int(source[child]), ratio, offset))
    return out
