"""Loose coupling in the paper's filter: poses of segments instead of markers correct it.

The markers' mean stands at  p_GI + R_GB (lambda∘d)  with the mean nominal lever d, so its
derivatives are those of `points`; the orientation's error is  beta = R_IB^T dth + dphi.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import block_diag

from tracker.fusion.ablations.segment_pose import by_segment, fit_pose, softened
from tracker.fusion.vist.layout import ERRORS, PHI, TH, VistLayout
from tracker.fusion.vist.markers import Matched
from tracker.fusion.vist.points import in_joint_rows, jacobians, positions
from tracker.fusion.vist.state import VistState
from tracker.geometry import so3
from tracker.messages import Array


def loose_rows(
    state: VistState, layout: VistLayout, matched: Matched, huber: float
) -> tuple[Array, Array, Array]:
    """H (6 s, 21 n), innovation (6 s,) m and rad, noise (6 s, 6 s) of the s segments whose pose the
    matched markers tell."""
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
