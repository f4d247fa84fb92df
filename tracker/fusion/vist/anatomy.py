"""Anatomical constraints as pseudo-measurements of zero (the paper's third sub-process).

Position: a child's proximal joint is the same point of its parent (six with seven IMUs).
Rotation: joints turn about their free axes only (seven: no twist at the thumb's MCP and at the
index's and middle's MCP and PIP, no abduction at the two PIP), as smooth rows e^T R_rel f = 0.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.constraints import Axis, Constraints
from tracker.fusion.chain.params import ConstraintParams
from tracker.fusion.vist.layout import ERRORS, PHI, TH, VistLayout
from tracker.fusion.vist.params import VistConstraint
from tracker.fusion.vist.points import in_joint_rows, jacobians, positions
from tracker.fusion.vist.state import VistState
from tracker.geometry.kernels import cross3
from tracker.messages import Array

SOFT = -1.0  # marks rows that the paper does not have


class Anatomy:
    """The rows of one hand with one glove: "Correction with anatomical constraints" of
    Lee et al. 2021, doi:10.1126/scirobotics.abe1315, whose own derivation is its note S7.
    """

    def __init__(self, layout: VistLayout, params: VistConstraint) -> None:
        self._layout, self._params = layout, params
        chain = layout.chain
        shared = Constraints(
            chain, ConstraintParams(rotation=params.rotation, stiff_abduction=SOFT)
        )
        self.axes: tuple[Axis, ...] = tuple(a for a in shared.axes if a.sd != SOFT)
        self.children = np.flatnonzero(chain.parent >= 0)
        self._parents = chain.parent[self.children]
        self._in_parent = chain.origin[self.children] - layout.imu_position[self._parents]
        self._in_child = -layout.imu_position[self.children]

    def rows(self, state: VistState) -> tuple[Array, Array, Array]:
        """Stacked H (m, 21 n), innovation (m,), variances (m,)."""
        H_p, r_p = self.position_rows(state)
        H_r, r_r = self.rotation_rows(state)
        variance = np.concatenate(
            [
                np.full(len(r_p), self._params.position**2),
                np.full(len(r_r), self._params.rotation**2),
            ]
        )
        return np.concatenate([H_p, H_r]), np.concatenate([r_p, r_r]), variance

    def position_rows(self, state: VistState) -> tuple[Array, Array]:
        """H (3 c, 21 n) and innovation (3 c,) m of the c joints."""
        size = self._layout.size
        there = positions(state, self._parents, self._in_parent)
        here = positions(state, self.children, self._in_child)
        H = in_joint_rows(jacobians(state, self._parents, self._in_parent), self._parents, size)
        H -= in_joint_rows(jacobians(state, self.children, self._in_child), self.children, size)
        return H.reshape(-1, size), -(there - here).ravel()

    def rotation_rows(self, state: VistState) -> tuple[Array, Array]:
        """H (a, 21 n) and innovation (a,) of the a fixed axes."""
        H = np.zeros((len(self.axes), self._layout.size))
        r = np.empty(len(self.axes))
        R_GB = state.R_GB
        for k, axis in enumerate(self.axes):
            r[k] = -self._axis_row(state, R_GB, axis, H[k])
        return H, r

    def _axis_row(self, state: VistState, R_GB: Array, axis: Axis, row: Array) -> float:
        """Fills ``row`` with the derivative of e^T R_rel f and returns the value."""
        c = axis.child
        a = int(self._layout.chain.parent[c])
        R_rest = self._layout.chain.R_rest[c]
        R_rel = R_rest.T @ R_GB[a].T @ R_GB[c]
        J_a = R_rest @ cross3(axis.e, R_rel @ axis.f)
        J_c = cross3(axis.f, R_rel.T @ axis.e)
        for s, J in ((a, J_a), (c, J_c)):  # beta_B = R_IB^T dth + dphi
            row[ERRORS * s + TH : ERRORS * s + TH + 3] = state.R_IB[s] @ J
            row[ERRORS * s + PHI : ERRORS * s + PHI + 3] = J
        return float(axis.e @ R_rel @ axis.f)
