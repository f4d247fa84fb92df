"""The pose of a tracker on the back of the hand as a measurement of the chain filter.

With l = p_BT - lever, where the state's position is that of the root's IMU at ``lever`` in B:
p_GT = p + R_GB l and R_GT = R_GB R_BT (docs/chain.md, "Without a camera").
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.layout import ChainLayout, V
from tracker.fusion.chain.params import PriorParams
from tracker.fusion.chain.pose_reset import turn
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.messages import Array, WristPose

PERIOD = 0.03  # s between two poses that are independent: errors of a tracking system persist
SHORTEST = 0.008  # s between two poses that are used
MOST_TILT = np.deg2rad(30.0)  # between a pose and gravity, beyond which the tracker is misaligned
GATE = 60.0  # squared Mahalanobis distance of six values beyond which a pose is an outlier
PLACE_AFTER = 0.4  # s of outliers without a break, after which the hand is where they say


def has_rotation(pose: WristPose) -> bool:
    """Whether the tracking system measures rotations too."""
    return bool(np.isfinite(pose.q_GT).all())


def root_rotation(pose: WristPose) -> Array:
    """R_GB (3, 3) of the hand's root segment by a pose with a rotation."""
    out: Array = so3.matrix_from_quat(pose.q_GT) @ so3.matrix_from_quat(pose.q_BT).T
    return out


def tilt_between(R_GB: Array, other: Array) -> float:
    """rad between the directions of the vertical in B by two rotations (3, 3)."""
    return float(np.arccos(np.clip(R_GB[2] @ other[2], -1.0, 1.0)))


def is_aligned(pose: WristPose, R_GB: Array) -> bool:
    """Whether the pose agrees with gravity as R_GB (3, 3) of the root segment does."""
    return not has_rotation(pose) or tilt_between(root_rotation(pose), R_GB) <= MOST_TILT


def wrist_rows(
    state: ChainState, layout: ChainLayout, pose: WristPose
) -> tuple[Array, Array, Array]:
    """H (m, N), innovation r (m,) and variance (m,), of six values or of a position's three."""
    R, lever = state.R_GB[0], pose.p_BT - layout.root_lever
    rows = 6 if has_rotation(pose) else 3
    H, at = np.zeros((rows, layout.blocks.size)), layout.blocks.theta
    H[:3, :3] = np.eye(3)
    H[:3, at : at + 3] = -R @ so3.skew(lever)
    r = pose.p_GT - state.p - R @ lever
    if rows == 3:
        return H, r, np.full(3, pose.position_variance)
    H[3:, at : at + 3] = np.eye(3)
    r = np.concatenate([r, so3.log(R.T @ root_rotation(pose))])
    return H, r, np.repeat([pose.position_variance, pose.rotation_variance], 3)


def is_credible(state: ChainState, H: Array, r: Array, variance: Array) -> bool:
    """Whether the innovation is within what the state and the measurement allow."""
    S = H @ state.P @ H.T + np.diag(variance)
    return float(r @ np.linalg.solve(S, r)) <= GATE


def place(state: ChainState, layout: ChainLayout, prior: PriorParams, pose: WristPose) -> None:
    """Move and turn the whole hand to the pose: it is not known where it was."""
    if has_rotation(pose):
        turn(state, _heading_between(root_rotation(pose), state.R_GB[0]))
    state.p = pose.p_GT - state.R_GB[0] @ (pose.p_BT - layout.root_lever)
    state.v = np.zeros(3)
    _forget(state, max(pose.position_variance, prior.position**2), prior.velocity**2)


def unplace(state: ChainState, prior: PriorParams) -> None:
    """The hand's position is not known any more."""
    state.p, state.v = np.zeros(3), np.zeros(3)
    _forget(state, prior.position**2, prior.first_velocity**2)


def _forget(state: ChainState, position: float, velocity: float) -> None:
    """Position and velocity are independent of all else, with these variances of an axis."""
    rows = np.arange(V + 3)
    state.P[rows, :] = 0.0
    state.P[:, rows] = 0.0
    state.P[rows, rows] = np.repeat([position, velocity], 3)


def _heading_between(R: Array, other: Array) -> float:
    """rad about the vertical that turns ``other`` (3, 3) nearest to R."""
    D = R @ other.T
    return float(np.arctan2(D[1, 0] - D[0, 1], D[0, 0] + D[1, 1]))
