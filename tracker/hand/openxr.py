"""The hand as OpenXR's 26 joints (OpenXR 1.1, XR_EXT_hand_tracking, "Conventions of hand joints").

A joint's axes there: -z along the bone to the tip, +y out of the back of the hand, x = y × z. That
is B (x to the tip, z dorsal) with its axes renamed, x_X = -y_B, y_X = z_B, z_X = -x_B, on both
sides. OpenXR's world has y up and -z forward, which renames G's axes in the same way.

The skeleton has no metacarpals of the fingers and no palm joint: these are placed on the dorsum and
never better than inferred.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracker.geometry import so3
from tracker.hand.names import FINGERS
from tracker.messages import Array, Estimate, IntArray, Validity

R_BX = np.array([[0.0, 0, -1], [-1, 0, 0], [0, 1, 0]])
"""Columns: OpenXR's x, y, z of a joint in B; also of OpenXR's world in G."""

PARTS = ("metacarpal", "proximal", "intermediate", "distal", "tip")
JOINTS = (
    "palm",
    "wrist",
    *(f"thumb_{part}" for part in ("metacarpal", "proximal", "distal", "tip")),
    *(f"{f}_{part}" for f in FINGERS for part in PARTS),
)
"""In the order of XrHandJointEXT."""

KEYPOINT_OF = {
    "wrist": "wrist",
    "thumb_metacarpal": "thumb_cmc",
    "thumb_proximal": "thumb_mcp",
    "thumb_distal": "thumb_ip",
    "thumb_tip": "thumb_tip",
    **{f"{f}_proximal": f"{f}_mcp" for f in FINGERS},
    **{f"{f}_intermediate": f"{f}_pip" for f in FINGERS},
    **{f"{f}_distal": f"{f}_dip" for f in FINGERS},
    **{f"{f}_tip": f"{f}_tip" for f in FINGERS},
}

METACARPAL_BASE = 0.25  # of the way from wrist to knuckle: where the carpus ends
PALM = 0.625  # the middle metacarpal's centre on the same line

# XrSpaceLocationFlags
ORIENTATION_VALID, POSITION_VALID, ORIENTATION_TRACKED, POSITION_TRACKED = 1, 2, 4, 8
FLAGS = {
    Validity.LOST: 0,
    Validity.INFERRED: ORIENTATION_VALID | POSITION_VALID,
    Validity.MEASURED: ORIENTATION_VALID | POSITION_VALID | ORIENTATION_TRACKED | POSITION_TRACKED,
}


@dataclass(frozen=True, eq=False)
class OpenXrHand:
    """Rows in the order of `JOINTS`; NaN where lost.

    position (26, 3) m and orientation (26, 4) xyzw in OpenXR's world; state (26,) of Validity.
    """

    t: float
    position: Array
    orientation: Array
    state: IntArray

    @property
    def flags(self) -> IntArray:
        """(26,) XrSpaceLocationFlags."""
        return np.array([FLAGS[Validity(int(s))] for s in self.state], np.int64)


def to_openxr(estimate: Estimate, keypoint_names: Sequence[str]) -> OpenXrHand:
    """The 26 joints of an estimate whose keypoints are named by ``keypoint_names``."""
    row_of = {n: i for i, n in enumerate(keypoint_names)}
    n = len(JOINTS)
    p_G, R_GB = np.full((n, 3), np.nan), np.full((n, 3, 3), np.nan)
    state = np.full(n, int(Validity.LOST), np.int64)
    for j, joint in enumerate(JOINTS):
        i = row_of.get(KEYPOINT_OF.get(joint, ""))
        if i is not None and estimate.keypoint_state[i] != Validity.LOST:
            p_G[j], state[j] = estimate.keypoints[i], estimate.keypoint_state[i]
            R_GB[j] = so3.matrix_from_quat(estimate.keypoint_q[i])
    _add_palm(p_G, R_GB, state)
    return OpenXrHand(estimate.t, p_G @ R_BX, _quaternions(R_BX.T @ R_GB @ R_BX), state)


def _add_palm(p_G: Array, R_GB: Array, state: IntArray) -> None:
    """Palm and finger metacarpals, from the wrist and the knuckles where both are known."""
    wrist = JOINTS.index("wrist")
    for finger in FINGERS:
        knuckle = JOINTS.index(f"{finger}_proximal")
        if Validity.LOST in (state[wrist], state[knuckle]):
            continue
        j = JOINTS.index(f"{finger}_metacarpal")
        along = p_G[knuckle] - p_G[wrist]
        p_G[j] = p_G[wrist] + METACARPAL_BASE * along
        R_GB[j] = _along(along, R_GB[wrist, :, 2])
        state[j] = Validity.INFERRED
        if finger == "middle":
            p_G[0], R_GB[0] = p_G[wrist] + PALM * along, R_GB[wrist]
            state[0] = Validity.INFERRED


def _along(x: Array, z: Array) -> Array:
    """(3, 3) axes with x along the first and z as near to the second as can be."""
    x = x / np.linalg.norm(x)
    y = np.cross(z, x)
    y /= np.linalg.norm(y)
    return np.column_stack([x, y, np.cross(x, y)])


def _quaternions(R: Array) -> Array:
    """(n, 4) xyzw; NaN rows stay NaN."""
    out = np.full((len(R), 4), np.nan)
    known = np.isfinite(R).all(axis=(1, 2))
    out[known] = so3.quat_from_matrix(R[known])
    return out
