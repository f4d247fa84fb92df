"""The hand as OpenXR's 26 joints (OpenXR 1.1, XR_EXT_hand_tracking, "Conventions of hand joints").

A joint's axes there: -z along the bone to the tip, +y out of the back of the hand, x = y × z. That
is B (x to the tip, z dorsal) with its axes renamed, x_X = -y_B, y_X = z_B, z_X = -x_B, on both
sides. OpenXR's world has y up and -z forward, which renames G's axes in the same way.

The skeleton has no metacarpals of the fingers and no palm joint: these are placed on the dorsum and
are at best inferred.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from tracker.geometry.kernels import quats
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS, KEYPOINTS
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

PALM_JOINT, WRIST = JOINTS.index("palm"), JOINTS.index("wrist")
KNUCKLES = [JOINTS.index(f"{f}_proximal") for f in FINGERS]
METACARPALS = [JOINTS.index(f"{f}_metacarpal") for f in FINGERS]

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

METACARPAL_BASE = 0.25  # of the distance from wrist to knuckle: distal end of the carpus
PALM = 0.625  # the middle metacarpal's centre on the same line
ON_DORSUM = (
    *zip(METACARPALS, KNUCKLES, [METACARPAL_BASE] * len(FINGERS), strict=True),
    (PALM_JOINT, JOINTS.index("middle_proximal"), PALM),
)
"""Joints without a keypoint, each with the knuckle and the fraction of the distance to it."""

# XrSpaceLocationFlags
ORIENTATION_VALID, POSITION_VALID, ORIENTATION_TRACKED, POSITION_TRACKED = 1, 2, 4, 8
FLAGS = {
    Validity.LOST: 0,
    Validity.INFERRED: ORIENTATION_VALID | POSITION_VALID,
    Validity.MEASURED: ORIENTATION_VALID | POSITION_VALID | ORIENTATION_TRACKED | POSITION_TRACKED,
}
_FLAGS = np.array([FLAGS[v] for v in sorted(Validity)], np.int64)


@dataclass(frozen=True, eq=False)
class OpenXrHand:
    """Rows in the order of `JOINTS`; NaN where lost. Leading axes (...) are instants, if any.

    position (..., 26, 3) m and orientation (..., 26, 4) xyzw in OpenXR's world; state (..., 26) of
    Validity; radius (..., 26) m, half the finger's thickness at the joint. ``t`` s of one instant,
    NaN for many.
    """

    t: float
    position: Array
    orientation: Array
    state: IntArray
    radius: Array

    @property
    def flags(self) -> IntArray:
        """(..., 26) XrSpaceLocationFlags."""
        return _FLAGS[self.state]


def to_openxr(estimate: Estimate, keypoint_names: Sequence[str], radii: Array) -> OpenXrHand:
    """The 26 joints of an estimate whose keypoints are named by ``keypoint_names``.

    ``radii`` (26,) m as `joint_radii` gives them.
    """
    e = estimate
    many = openxr_joints(e.keypoints, e.keypoint_q, e.keypoint_state, keypoint_names, radii)
    return replace(many, t=e.t)


@dataclass(frozen=True, eq=False)
class PointMotion:
    """The motion of n points of a hand; NaN where unknown. linear (n, 3) m/s and angular (n, 3)
    rad/s in the axes of their positions; linear_sd, angular_sd (n,) as in a `Motion`."""

    linear: Array
    angular: Array
    linear_sd: Array
    angular_sd: Array


def openxr_motion(
    estimate: Estimate, keypoint_names: Sequence[str], joints: OpenXrHand
) -> PointMotion:
    """The motion of an estimate's ``joints``, in the order of `JOINTS`, in OpenXR's world.

    Those on the dorsum are interpolated between wrist and knuckle and rotate with the wrist; their
    variances are the sum of both.
    """
    m, nothing = estimate.motion, np.full((len(JOINTS), 3), np.nan)
    if m is None:
        return PointMotion(nothing, nothing, nothing[:, 0], nothing[:, 0])
    rows = np.array(keypoint_rows(keypoint_names))
    there = rows >= 0
    linear, angular = nothing.copy(), nothing.copy()
    linear[there], angular[there] = m.linear[rows[there]] @ R_BX, m.angular[rows[there]] @ R_BX
    for joint, knuckle, share in ON_DORSUM:
        linear[joint] = (1 - share) * linear[WRIST] + share * linear[knuckle]
        angular[joint] = angular[WRIST]
    lost = joints.state == Validity.LOST
    linear[lost], angular[lost] = np.nan, np.nan
    sds = [_joint_sds(sd, rows) for sd in (m.linear_sd, m.angular_sd)]
    return PointMotion(linear, angular, *sds)


def _joint_sds(sd: Array, rows: IntArray) -> Array:
    """(26,) of keypoints' sd (K,); ``rows`` as `keypoint_rows`."""
    out = np.where(rows >= 0, sd[np.maximum(rows, 0)], np.nan)
    for joint, knuckle, _ in ON_DORSUM:
        out[joint] = np.hypot(out[WRIST], out[knuckle])
    return out


def joint_radii(hand: HandModel) -> Array:
    """(26,) m: half the thickness of the bone that starts at a joint, or ends at a tip.

    Palm, wrist and the fingers' metacarpals have that of the dorsum; NaN where the hand has no such
    bone.
    """
    found = (hand.index.get(_segment_at(joint)) for joint in JOINTS)
    return np.array([np.nan if i is None else hand.segments[i].radius for i in found])


def _segment_at(joint: str) -> str:
    """Name of the segment that defines the thickness at a joint."""
    if joint in KEYPOINT_OF:
        return KEYPOINTS[KEYPOINT_OF[joint]][0]
    return KEYPOINTS["wrist"][0]


def openxr_joints(
    keypoints: Array, q: Array, state: IntArray, keypoint_names: Sequence[str], radii: Array
) -> OpenXrHand:
    """The joints at one or several times.

    keypoints (..., K, 3) m and q (..., K, 4) xyzw of each one's segment, both in G; state (..., K)
    of Validity; radii (26,) m.
    """
    rows = keypoint_rows(keypoint_names)
    there = [j for j, row in enumerate(rows) if row >= 0]
    columns = [row for row in rows if row >= 0]
    shape = (*keypoints.shape[:-2], len(JOINTS))
    p, out_q = np.full((*shape, 3), np.nan), np.full((*shape, 4), np.nan)
    out_state = np.full(shape, int(Validity.LOST), np.int64)
    out_state[..., there] = state[..., columns]
    # R_BX^T R R_BX rotates about the same axis as R, expressed in OpenXR's axes.
    p[..., there, :] = keypoints[..., columns, :] @ R_BX
    out_q[..., there, :3] = q[..., columns, :3] @ R_BX
    out_q[..., there, 3] = q[..., columns, 3]
    unknown = ~(np.isfinite(p).all(axis=-1) & np.isfinite(out_q).all(axis=-1))
    out_state[unknown] = Validity.LOST
    _add_palm(p, out_q, out_state)
    lost = out_state == Validity.LOST
    p[lost], out_q[lost] = np.nan, np.nan
    return OpenXrHand(np.nan, p, out_q, out_state, np.where(lost, np.nan, radii))


@lru_cache
def keypoint_rows(keypoint_names: Sequence[str]) -> tuple[int, ...]:
    """(26,) row of the keypoint at each joint, -1 where there is none."""
    row_of = {n: i for i, n in enumerate(keypoint_names)}
    return tuple(row_of.get(KEYPOINT_OF.get(joint, ""), -1) for joint in JOINTS)


def _add_palm(p: Array, q: Array, state: IntArray) -> None:
    """Palm and finger metacarpals, from the wrist and the knuckles where both are known."""
    known = (state[..., WRIST, None] != Validity.LOST) & (state[..., KNUCKLES] != Validity.LOST)
    wrist, q_wrist = p[..., WRIST, None, :], q[..., WRIST, None, :]
    along = p[..., KNUCKLES, :] - wrist
    p_found, q_found = wrist + METACARPAL_BASE * along, _along(along, q_wrist)
    for column, j in enumerate(METACARPALS):
        has = known[..., column]
        p[has, j], q[has, j] = p_found[has, column], q_found[has, column]
        state[has, j] = Validity.INFERRED
    middle = KNUCKLES.index(JOINTS.index("middle_proximal"))
    has = known[..., middle]
    p[has, PALM_JOINT] = (wrist + PALM * along)[has, middle]
    q[has, PALM_JOINT] = q_wrist[has, 0]
    state[has, PALM_JOINT] = Validity.INFERRED


def _along(bone: Array, q_wrist: Array) -> Array:
    """(..., 4) joints whose -z is along ``bone`` (..., 3), with y as close to that of the wrist's
    (..., 4) as possible."""
    z = _unit(-bone)
    x = _unit(_cross(_y_axis(q_wrist), z))
    R = np.stack([x, _cross(z, x), z], axis=-1)
    return quats(np.ascontiguousarray(R.reshape(-1, 3, 3))).reshape(*bone.shape[:-1], 4)


def _unit(v: Array) -> Array:
    return np.asarray(v / np.sqrt((v * v).sum(axis=-1, keepdims=True)))


def _cross(a: Array, b: Array) -> Array:
    """As np.cross, ten times as fast for a few rows."""
    ahead, behind = [1, 2, 0], [2, 0, 1]
    return np.asarray(a[..., ahead] * b[..., behind] - a[..., behind] * b[..., ahead])


def _y_axis(q: Array) -> Array:
    """(..., 3) second columns of the rotations q (..., 4)."""
    x, y, z, w = np.moveaxis(q, -1, 0)
    return np.stack([2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], axis=-1)
