"""Joint angles from keypoints, by one model for the reference and for the estimate.

The hand's axes: z is normal to the plane of wrist, index and little MCP, out of the back of the
hand; x points from the wrist to the middle of the MCP joints of index and little finger. A finger's
proximal bone has the direction Rz(abduction) Ry(flexion) x. The flexion of PIP and DIP is the angle
between both bones about the finger's flexion axis Rz(abduction) y, and the flexion of the thumb's
MCP and IP the angle between its bones. The same is computed from the keypoints of both methods, so
that differences are those of the keypoints and not of two definitions of angles.
"""

from __future__ import annotations

import itertools

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.hand.names import CHAINS, FINGERS, KEYPOINTS
from tracker.messages import Array

MODEL = "hand axes from wrist, index and little MCP; z-y'-x''; angles between bones beyond the MCP"
_PLANE = ("wrist", "index_mcp", "little_mcp")


def angles_of(names: tuple[str, ...], points: Array, side: str) -> dict[str, Array]:
    """Angles (N,) rad by the session's names of them, from keypoints (N, K, 3) m in any frame.

    Only angles whose keypoints are all in ``names``; NaN where one is unknown.
    """
    at = {name: points[:, i] for i, name in enumerate(names)}
    out: dict[str, Array] = {}
    if set(_PLANE) <= at.keys():
        R_GH = _hand_axes(at, side)
        for finger in FINGERS:
            out |= _finger_angles(at, finger, R_GH)
    for joint, before, after in (("mcp", "cmc", "ip"), ("ip", "mcp", "tip")):
        bones = [f"thumb_{n}" for n in (before, joint, after)]
        if set(bones) <= at.keys():
            a, b, c = (at[n] for n in bones)
            out[f"thumb_{joint}_flexion"] = _between(b - a, c - b)
    return out


def segment_axes(names: tuple[str, ...], points: Array, side: str) -> Array:
    """(N, K, 4) xyzw: axes of the segment that starts at each keypoint, and of a tip's segment.

    x points along the bone; y is as near as possible to the finger's flexion axis, for the thumb to
    the hand's z cross x, since its turn about the bone does not show in keypoints. NaN where a
    keypoint is unknown, and if wrist, index or little MCP are not among ``names``.
    """
    at = {name: points[:, i] for i, name in enumerate(names)}
    R = np.full((*points.shape[:2], 3, 3), np.nan)
    if not set(_PLANE) <= at.keys():
        return _quaternions(R)
    R_GH = _hand_axes(at, side)
    for name in {"wrist", "dorsum"} & at.keys():
        R[:, names.index(name)] = R_GH
    for digit in CHAINS:
        chain = [n for n in KEYPOINTS if n.startswith(f"{digit}_") and n in at]
        first = at[chain[1]] - at[chain[0]] if len(chain) > 1 else points[:, 0]
        for a, b in itertools.pairwise(chain):
            x = _unit(at[b] - at[a])
            across = first if digit != "thumb" else x
            y = _unit(np.cross(R_GH[:, :, 2], across))
            z = _unit(np.cross(x, y))
            R[:, names.index(a)] = np.stack([x, np.cross(z, x), z], axis=2)
            R[:, names.index(b)] = R[:, names.index(a)]
    return _quaternions(R)


def _quaternions(R: Array) -> Array:
    """(N, K, 4) xyzw of (N, K, 3, 3); NaN where unknown."""
    q = np.full(R.shape[:3][:2] + (4,), np.nan)
    known = np.asarray(np.isfinite(R).all(axis=(2, 3)))
    if known.any():
        q[known] = Rotation.from_matrix(R[known]).as_quat()
    return q


def _unit(v: Array) -> Array:
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(v / np.linalg.norm(v, axis=-1, keepdims=True))


def _hand_axes(at: dict[str, Array], side: str) -> Array:
    """(N, 3, 3) with the hand's axes as columns."""
    wrist, index, little = (at[n] for n in _PLANE)
    x = _unit(0.5 * (index + little) - wrist)
    z = np.cross(little - wrist, index - wrist)
    z = _unit(z if side == "right" else -z)
    return np.stack([x, np.cross(z, x), z], axis=2)


def _finger_angles(at: dict[str, Array], finger: str, R_GH: Array) -> dict[str, Array]:
    chain = [f"{finger}_{n}" for n in ("mcp", "pip", "dip", "tip")]
    if not set(chain[:2]) <= at.keys():
        return {}
    d = np.einsum("nji,nj->ni", R_GH, _unit(at[chain[1]] - at[chain[0]]))
    abduction = np.arctan2(d[:, 1], d[:, 0])
    flexion = np.arctan2(-d[:, 2], np.hypot(d[:, 0], d[:, 1]))
    out = {f"{finger}_mcp_abduction": abduction, f"{finger}_mcp_flexion": flexion}
    none = np.zeros(len(d))
    axis = np.einsum("nij,nj->ni", R_GH, np.stack([-np.sin(abduction), np.cos(abduction), none], 1))
    for k, joint in ((1, "pip"), (2, "dip")):
        if set(chain[k - 1 : k + 2]) <= at.keys():
            a, b, c = (at[n] for n in chain[k - 1 : k + 2])
            out[f"{finger}_{joint}_flexion"] = _about(axis, b - a, c - b)
    return out


def _between(u: Array, v: Array) -> Array:
    """(N,) angles between vectors, 0 to π."""
    return np.asarray(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(axis=1)))


def _about(axis: Array, u: Array, v: Array) -> Array:
    """(N,) angles from u to v about ``axis``, within ±π."""
    return np.asarray(np.arctan2((np.cross(u, v) * axis).sum(axis=1), (u * v).sum(axis=1)))
