"""ISB joint angles of a take, and standard deviations of angles.

ISB (Wu et al. 2005, J. Biomech. 38:981) rotates first about the proximal bone's flexion axis, then
about the floating abduction axis, then about the distal bone's long axis. The session's angles
start with abduction: R = Rz(abduction) Ry(flexion) Rx(twist).
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.hand.model import HandModel
from tracker.hand.names import AXES, KEYPOINTS
from tracker.messages import Array
from tracker.session.motion import Take

SEQUENCE = "y-z'-x'': flexion; abduction; rotation"
RECORDED = "z-y'-x'': abduction; flexion; twist"
ISB = ("flexion", "abduction", "rotation")
_SHORTEST = 0.005  # m; the direction of a shorter bone is not used


def isb_angles(take: Take, hand: HandModel) -> tuple[list[str], Array, list[int]]:
    """Names ``<joint>_isb_<flexion|abduction|rotation>``, (N, n) rad and the column of the
    recorded angle whose state and sd apply to each. Joints with one axis are omitted: their ISB
    angle is the recorded one.

    Flexion is positive towards the palm, abduction of a right hand towards the thumb (of a left
    one towards the little finger: about the axis out of the back of the hand), rotation about the
    bone's axis to its tip.
    """
    names: list[str] = []
    columns: list[Array] = []
    of: list[int] = []
    for segment in hand.segments:
        joint = hand.joint_of.get(segment.name)
        if joint is None or len(joint.axes) < 2:
            continue
        place = [take.angle_names.index(f"{joint.name}_{axis}") for axis in joint.axes]
        turns = np.zeros((len(take.t), 3))
        turns[:, [AXES.index(axis) for axis in joint.axes]] = take.angles[:, place]
        for k, name in enumerate(ISB):
            names.append(f"{joint.name}_isb_{name}")
            columns.append(_isb(turns)[:, k])
            of.append(place[min(k, len(place) - 1)])
    return names, np.array(columns).T.reshape(len(take.t), -1), of


def _isb(turns: Array) -> Array:
    """(N, 3) flexion, abduction, rotation of (N, 3) abduction, flexion, twist; NaN stays."""
    out = np.full_like(turns, np.nan)
    known = np.isfinite(turns).all(axis=1)
    if known.any():
        R = Rotation.from_euler("ZYX", turns[known])
        out[known] = R.as_euler("YZX")
    return out


def angle_sd(take: Take, hand: HandModel) -> Array:
    """Standard deviations (N, J) rad of angles; NaN if they do not follow from known values.

    The difference in variance between a bone's end and its beginning is attributed to its
    direction: with the root of the mean variance per axis, σ_end² = σ_begin² + ²⁄₃ L² σ_direction².
    The uncertainty of the length is attributed to the direction as well, so the result is an upper
    bound. A joint's angle has the errors of both bones' directions, assumed to be independent.
    """
    out = np.full(take.angles.shape, np.nan)
    direction = {s.name: _direction_variance(take, hand, s.name) for s in hand.segments}
    for segment in hand.segments:
        joint = hand.joint_of.get(segment.name)
        if joint is None or segment.parent is None:
            continue
        variance = direction[segment.name] + np.nan_to_num(direction[segment.parent])
        for axis in joint.axes:
            out[:, take.angle_names.index(f"{joint.name}_{axis}")] = np.sqrt(variance)
    return out


def _direction_variance(take: Take, hand: HandModel, segment: str) -> Array:
    """Variance (N,) rad² of a finger bone's direction about either transverse axis."""
    ends = _ends(take, hand, segment)
    none = np.full(len(take.t), np.nan)
    if ends is None:
        return none
    a, b = ends
    length = np.linalg.norm(take.points[:, b] - take.points[:, a], axis=1)
    more = take.point_sd[:, b] ** 2 - take.point_sd[:, a] ** 2
    fine = (length > _SHORTEST) & (more > 0)
    return np.where(fine, 1.5 * more / np.where(fine, length, 1.0) ** 2, none)


def _ends(take: Take, hand: HandModel, segment: str) -> tuple[int, int] | None:
    """Columns of the points at a bone's beginning and end."""
    begin = [k for k, (s, tip) in KEYPOINTS.items() if s == segment and not tip]
    children = [s.name for s in hand.segments if s.parent == segment]
    end = [k for k, (s, tip) in KEYPOINTS.items() if (s == segment and tip)]
    if not end and len(children) == 1:
        end = [k for k, (s, tip) in KEYPOINTS.items() if s == children[0] and not tip]
    if not begin or not end or not {begin[0], end[0]} <= set(take.point_names):
        return None
    return take.point_names.index(begin[0]), take.point_names.index(end[0])
