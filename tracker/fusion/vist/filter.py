"""The extended Kalman filter of the paper: prediction, marker correction, anatomy.

Anatomical constraints as pseudo-measurements of zero (the paper's third sub-process).

Position: a child's proximal joint is the same point of its parent (six with seven IMUs).
Rotation: joints turn about their free axes only (seven: no twist at the thumb's MCP and at the
index's and middle's MCP and PIP, no abduction at the two PIP), as smooth rows e^T R_rel f = 0.

Loose coupling: poses of segments instead of markers correct the filter. The mean of the markers is
at p_GI + R_GB (lambda∘d)  with the mean nominal lever d, so its derivatives are those of `points`;
the error of the orientation is  beta = R_IB^T dth + dphi.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import block_diag

from tracker.fusion.ablations.segment_pose import by_segment, fit_pose, softened
from tracker.fusion.chain.constraints import Axis, Constraints
from tracker.fusion.chain.params import ConstraintParams
from tracker.fusion.kalman import update_with
from tracker.fusion.vist.layout import ERRORS, PHI, TH, P, V, VistLayout
from tracker.fusion.vist.markers import Expected, Matched
from tracker.fusion.vist.params import VistConstraint, VistParams
from tracker.fusion.vist.points import in_joint_rows, jacobians, own_covariance, positions
from tracker.fusion.vist.rest import rest_rows
from tracker.fusion.vist.state import VistState, inject
from tracker.geometry import so3
from tracker.geometry.kernels import cross3
from tracker.messages import Array


def loose_rows(
    state: VistState, layout: VistLayout, matched: Matched, huber: float
) -> tuple[Array, Array, Array]:
    """H (6 s, 21 n), innovation (6 s,) m and rad, noise (6 s, 6 s) of the s segments whose pose is
    determined by the matched markers."""
    H, r, R = [np.zeros((0, layout.size))], [np.zeros(0)], [np.zeros((0, 0))]
    for segment, rows in by_segment(layout.chain.marker_segment[matched.marker]):
        lever = layout.marker_lever[matched.marker[rows]]
        shape = state.scale[segment] * lever
        pose = fit_pose(shape, matched.p_G[rows], matched.cov[rows])
        if pose is None:
            continue
        H_s, centre, R_GB = pose_rows(state, layout, segment, lever.mean(axis=0))
        r_s = np.concatenate([pose.centre_G - centre, so3.log(R_GB.T @ pose.R_GB)])
        H.append(H_s)
        r.append(r_s)
        R.append(softened(pose.cov, r_s, H_s @ state.P @ H_s.T, huber))
    return np.concatenate(H), np.concatenate(r), block_diag(*R)


def pose_rows(
    state: VistState, layout: VistLayout, segment: int, lever: Array
) -> tuple[Array, Array, Array]:
    """H (6, 21 n), position (3,) m in G of a point at the nominal lever (3,), and R_GB (3, 3)."""
    one = np.array([segment])
    H = np.zeros((6, layout.size))
    H[:3] = in_joint_rows(jacobians(state, one, lever[None]), one, layout.size)[0]
    at = ERRORS * segment
    H[3:, at + TH : at + TH + 3] = state.R_IB[segment].T
    H[3:, at + PHI : at + PHI + 3] = np.eye(3)
    return H, positions(state, one, lever[None])[0], state.R_GB[segment]


SOFT = -1.0  # marks rows that are not in the paper


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


class VistFilter:
    """Updates a `VistState`; itself immutable.

    Lee et al. 2021, doi:10.1126/scirobotics.abe1315, "Correction with visual information" (eq. 10)
    and "Correction with anatomical constraints".
    """

    def __init__(self, layout: VistLayout, params: VistParams) -> None:
        self._layout, self._params = layout, params
        self._anatomy = Anatomy(layout, params.constraint)

    def constrain(self, state: VistState) -> None:
        """Applies anatomy alone, while no image arrives."""
        H, r, variance = self._anatomy.rows(state)
        self._update(state, H, r, np.diag(variance))

    def rest(self, state: VistState) -> None:
        """Applies the rows of a hand at rest."""
        self._update(state, *rest_rows(state, self._layout))

    def correct(
        self, state: VistState, expected: Expected, matched: Matched, often: float = 1.0
    ) -> None:
        """Eq. 10 and the constraints in one stacked update, linearised at one state.

        ``often`` multiplies all noise: errors of a marker's position or a joint's axis are the same
        in the next image, so more images per second contain no more information. The innovation
        uses the predicted markers themselves; the shift found by correspondence is used only for
        the assignment.
        """
        H, r, variance = self._anatomy.rows(state)
        R = np.diag(variance * often)
        if len(matched):
            H_m, r_m, R_m = self._seen_rows(state, expected, matched)
            R_m *= often
            H, r = np.concatenate([H_m, H]), np.concatenate([r_m, r])
            both = np.zeros((len(r), len(r)))
            both[: len(R_m), : len(R_m)] = R_m
            both[len(R_m) :, len(R_m) :] = R
            R = both
        self._update(state, H, r, R)

    def _seen_rows(
        self, state: VistState, expected: Expected, matched: Matched
    ) -> tuple[Array, Array, Array]:
        if self._params.coupling == "loose":
            return loose_rows(state, self._layout, matched, self._params.noise.huber)
        return self.marker_rows(expected, matched)

    def marker_rows(self, expected: Expected, matched: Matched) -> tuple[Array, Array, Array]:
        """H (3 k, 21 n), innovation (3 k,) m and noise (3 k, 3 k) m² of k matched markers."""
        lay, k = self._layout, len(matched)
        segment = lay.chain.marker_segment[matched.marker]
        H = in_joint_rows(expected.H[matched.marker], segment, lay.size).reshape(-1, lay.size)
        r = matched.p_G - expected.p_G[matched.marker]  # eq. 10
        S = expected.cov[matched.marker] + matched.cov
        distance = np.sqrt(np.einsum("ki,ki->k", r, np.linalg.solve(S, r[..., None])[..., 0]) / 3)
        weight = np.maximum(1.0, distance / self._params.noise.huber) ** 2
        R = np.zeros((k, 3, k, 3))
        R[np.arange(k), :, np.arange(k), :] = matched.cov * weight[:, None, None]
        return H, r.ravel(), R.reshape(3 * k, 3 * k)

    def _update(self, state: VistState, H: Array, r: Array, R: Array) -> None:
        HP = H @ state.P
        if state.held_back.any():  # a known error of the nominal state, which the update removes
            back = np.zeros((self._layout.n, ERRORS))
            back[:, P : P + 3], back[:, V : V + 3] = state.held_back
            dx, _ = update_with(state.P, HP, HP @ H.T, H @ back.ravel(), R)
            state.held_back = state.held_back - np.stack([dx[P : P + 3], dx[V : V + 3]])
        dx, state.P = update_with(state.P, HP, HP @ H.T, r, R)
        inject(state, dx)

    def tip_sd(self, state: VistState) -> Array:
        """(n,) m: root of the mean variance of each segment's far end."""
        segment = np.arange(self._layout.n)
        cov = own_covariance(state, jacobians(state, segment, self._layout.tip_lever), segment)
        return np.sqrt(np.maximum(np.trace(cov, axis1=1, axis2=2) / 3, 0.0))
