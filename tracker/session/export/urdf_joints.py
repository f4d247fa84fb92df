"""Values of the joints of a URDF that reproduce the estimates, at each instant.

An anatomical joint has the axes and the angles of the session. What these leave is represented by
further joints of one axis each: bones whose size was still being estimated shift the joint at their
end, and joints of kind lean represent rotations about an axis that the anatomical joint lacks. They
are zero for the hand of the last calibration, so setting only the angles gives that hand.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.hand.names import AXES
from tracker.messages import Array
from tracker.session.export.joints import JointMotion, joint_motion, matrices
from tracker.session.export.series import EstimateSeries

STILL_M, STILL = 2e-6, 2e-5
"""Less than this, m and rad, no joint is made for: over a finger that is less than 0.02 mm."""
REACH = 10.0
"""m that the hand may be from the origin."""
_LETTERS = "xyz"


class UrdfAxis(NamedTuple):
    """A joint of one degree of freedom: ``kind`` of URDF, ``letter`` of its axis, values (N,) m or
    rad, ``limits`` in addition to the tracked values."""

    name: str
    kind: str
    letter: str
    values: Array
    limits: tuple[float, float] = (0.0, 0.0)


class LinkAxes(NamedTuple):
    """From a parent to a link: shifts in the parent's axes, then rotations one after the other."""

    shifts: tuple[UrdfAxis, ...] = ()
    turns: tuple[UrdfAxis, ...] = ()


class HandAxes(NamedTuple):
    """The axes of all segments, and those of all keypoints relative to their segments."""

    segments: tuple[LinkAxes, ...]
    keypoints: tuple[LinkAxes, ...]

    def joints(self) -> list[UrdfAxis]:
        """All of them, from the root outward."""
        links = (*self.segments, *self.keypoints)
        return [axis for link in links for axis in (*link.shifts, *link.turns)]


def hand_axes(m: EstimateSeries, origins: Array, tips: Array) -> HandAxes:
    """For a series in right-handed axes; ``origins`` (S, 3) and ``tips`` (K, 3) m are the positions
    of joints and keypoints in the B before them, as last calibrated.
    """
    motion, hand = joint_motion(m), m.info.hand
    segments = [
        _root(m, i) if hand.parent[i] < 0 else _joint(m, motion, i, origins[i])
        for i in range(len(hand.segments))
    ]
    return HandAxes(tuple(segments), tuple(_keypoints(m, tips)))


def _root(m: EstimateSeries, i: int) -> LinkAxes:
    """All six degrees of freedom, from the origin of the session."""
    name = m.info.hand.segments[i].name
    p, turns = m.segment_p[:, i], np.full((len(m), 3), np.nan)
    known = np.isfinite(m.segment_q[:, i]).all(axis=1)
    if known.any():
        euler = Rotation.from_quat(m.segment_q[known, i]).as_euler("ZYX")
        turns[known] = np.unwrap(euler, axis=0)
    return LinkAxes(
        tuple(
            UrdfAxis(f"{name}_{c}", "prismatic", c, p[:, k], (-REACH, REACH))
            for k, c in enumerate(_LETTERS)
        ),
        tuple(
            UrdfAxis(f"{name}_turn_{c}", "continuous", c, turns[:, k]) for k, c in enumerate("zyx")
        ),
    )


def _joint(m: EstimateSeries, motion: JointMotion, i: int, origin: Array) -> LinkAxes:
    hand = m.info.hand
    name, joint = hand.segments[i].name, hand.joint_of.get(hand.segments[i].name)
    shifts = _shifts(f"{name}_shift", motion.offset[:, i] - origin)
    turn = motion.turn[:, i]
    angles = np.zeros((len(m), 3))
    turns = []
    for k, axis in enumerate(AXES):
        if joint is not None and axis in joint.axes:
            angles[:, k] = _angle(m, i, k, turn)
            name_of = f"{joint.name}_{axis}"
            limits = joint.limits[axis]
            turns.append(UrdfAxis(name_of, "revolute", "zyx"[k], angles[:, k], limits))
    return LinkAxes(shifts, (*turns, *_leans(name, turn, angles)))


def _angle(m: EstimateSeries, i: int, k: int, turn: Array) -> Array:
    """Returns (N,) the session's angle; 0 if it is missing but the segment is known."""
    column = m.info.hand.axis_columns[i][k]
    known = np.isfinite(turn).all(axis=(1, 2))
    angle = m.angles[:, column]
    return np.where(known & ~np.isfinite(angle), 0.0, np.where(known, angle, np.nan))


def _leans(name: str, turn: Array, angles: Array) -> tuple[UrdfAxis, ...]:
    """Joints for the remainder of the rotations (N, 3, 3) after the angles (N, 3)."""
    left = np.full((len(turn), 3), np.nan)
    known = np.isfinite(turn).all(axis=(1, 2)) & np.isfinite(angles).all(axis=1)
    if known.any():
        joint = Rotation.from_euler("ZYX", angles[known])
        left[known] = (joint.inv() * Rotation.from_matrix(turn[known])).as_euler("ZYX")
    used = _nonzero_columns(left, STILL)
    return tuple(
        UrdfAxis(f"{name}_lean_{c}", "revolute", c, left[:, k])
        for k, c in enumerate("zyx")
        if used[k]
    )


def _keypoints(m: EstimateSeries, tips: Array) -> list[LinkAxes]:
    hand, glove = m.info.hand, m.info.glove
    out, turns = [], matrices(m.segment_q)
    for k, (name, i) in enumerate(
        zip(m.keypoint_names, glove.keypoint_segments(hand), strict=True)
    ):
        away = m.keypoints[:, k] - m.segment_p[:, i]
        local = np.einsum("nji,nj->ni", turns[:, i], away)
        out.append(LinkAxes(_shifts(f"{name}_keypoint_shift", local - tips[k])))
    return out


def _shifts(name: str, away: Array) -> tuple[UrdfAxis, ...]:
    used = _nonzero_columns(away, STILL_M)
    return tuple(
        UrdfAxis(f"{name}_{c}", "prismatic", c, away[:, k])
        for k, c in enumerate(_LETTERS)
        if used[k]
    )


def _nonzero_columns(values: Array, least: float) -> list[bool]:
    """The columns of values (N, 3) that are not always zero."""
    return [bool(v) for v in np.abs(np.nan_to_num(values)).max(axis=0, initial=0.0) > least]
