"""The motion of each segment relative to its parent, for skeletons made of joints."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from tracker.geometry import so3
from tracker.messages import Array
from tracker.session.export.series import EstimateSeries


class JointMotion(NamedTuple):
    """offset (N, S, 3) m of a segment's joint in its parent's B; turn (N, S, 3, 3) of the joint,
    after the segment's rest. NaN for the root and where the segment or its parent is lost."""

    offset: Array
    turn: Array

    def median_offset(self, otherwise: Array) -> Array:
        """Returns medians (S, 3) m of known values; ``otherwise`` (S, 3) where there are none."""
        known: NDArray[np.bool_] = np.asarray(np.isfinite(self.offset).all(axis=2))
        rows = [
            np.median(self.offset[known[:, s], s], axis=0) if known[:, s].any() else otherwise[s]
            for s in range(self.offset.shape[1])
        ]
        return np.array(rows)

    def flexed_last(self) -> Array:
        """(N, S, 3) abduction, twist, flexion of all joints, applied in this order: Rz Rx Ry.

        Abduction and flexion are those of the nearest rotation Rz Ry, as for joints without twist
        (`tracker.geometry.so3.joint_angles`): the remaining rotation is about the axis orthogonal
        to both. Unlike in Rz Ry Rx, no two axes coincide when a finger is flexed by 90°.
        """
        out = np.full(self.turn.shape[:3], np.nan)
        R = self.turn
        known = np.isfinite(R).all(axis=(2, 3))
        out[..., 0] = np.where(known, np.arctan2(-R[..., 0, 1], R[..., 1, 1]), np.nan)
        out[..., 1] = np.where(known, np.arcsin(np.clip(R[..., 2, 1], -1, 1)), np.nan)
        out[..., 2] = np.where(known, np.arctan2(-R[..., 2, 0], R[..., 2, 2]), np.nan)
        return out

    def angles(self) -> Array:
        """(N, S, 3) abduction, flexion, twist of all joints, as if each had all three axes."""
        out = np.full(self.turn.shape[:3], np.nan)
        known = np.isfinite(self.turn).all(axis=(2, 3))
        out[known] = so3.joint_angles(self.turn[known])
        return out


def joint_motion(m: EstimateSeries) -> JointMotion:
    """The motion of all joints, for a series in right-handed axes."""
    hand = m.info.hand
    R = matrices(m.segment_q)
    offset, turn = np.full_like(m.segment_p, np.nan), np.full_like(R, np.nan)
    for s, a in enumerate(hand.parent):
        if a >= 0:
            back = np.swapaxes(R[:, a], 1, 2)
            offset[:, s] = np.einsum("nij,nj->ni", back, m.segment_p[:, s] - m.segment_p[:, a])
            turn[:, s] = hand.segments[s].R_rest.T @ back @ R[:, s]
    return JointMotion(offset, turn)


def matrices(q: Array) -> Array:
    """(N, S, 3, 3) of quaternions (N, S, 4); NaN where lost."""
    R = np.full((*q.shape[:2], 3, 3), np.nan)
    known = np.isfinite(q).all(axis=2)
    if known.any():
        R[known] = Rotation.from_quat(q[known]).as_matrix()
    return R
