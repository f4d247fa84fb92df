"""A hand with known motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.geometry import so3
from tracker.messages import Array
from tracker.session.description import SessionInfo
from tracker.session.gaps.interpolate import RecordedMotion, SessionSkeleton

RATE, ROWS = 100.0, 101  # Hz
SPEED, TURN, BEND = np.array([0.2, -0.1, 0.3]), np.array([0.4, 0.9, -0.6]), 0.8  # m/s, rad/s


@dataclass(frozen=True, eq=False)
class Swing:
    """``motion`` of a hand of ``info``."""

    info: SessionInfo
    skeleton: SessionSkeleton
    motion: RecordedMotion

    @property
    def all_points(self) -> list[int]:
        return list(range(len(self.skeleton.names)))

    def uniform(self) -> Swing:
        """The same hand with constant velocities."""
        return made(self.info, lambda t: t)


def made(info: SessionInfo, phase: object) -> Swing:
    """``phase``: the phase of the motion at a time (s), s."""
    t = np.arange(ROWS) / RATE
    hand, glove = info.hand, info.glove
    flexions = np.array([name.endswith("_flexion") for name in hand.joint_names])
    points, turns, angles = [], [], []
    for now in t:
        s = float(phase(now))  # type: ignore[operator]
        bent: Array = np.where(flexions, 0.1 + BEND * s, 0.0)
        R, p = hand.forward(bent, so3.exp(TURN * s), SPEED * s + [0.0, 0.0, 0.4])
        points.append(glove.keypoint_positions(hand, R, p))
        turns.append(so3.quat_from_matrix(R[glove.keypoint_segments(hand)]))
        angles.append(bent)
    motion = RecordedMotion(t, np.array(points), np.array(turns), np.array(angles))
    return Swing(info, SessionSkeleton(info), motion)
