"""Interpolated hands compared with known motion."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.session.gaps.hands import Swing
from tracker.session.gaps.interpolate import RecordedMotion, SessionSkeleton, fill_motion
from tracker.session.gaps.methods import CUBIC, LINEAR

GAP = (40, 61)
HAND_ROWS = slice(GAP[0] + 1, GAP[1])


def filled(
    swing: Swing,
    method: str,
    columns: list[int],
    shape: RecordedMotion | None = None,
    gap: tuple[int, int] = GAP,
) -> RecordedMotion:
    motion, rows = swing.motion.copy(), slice(gap[0] + 1, gap[1])
    motion.keypoints[rows, columns] = np.nan
    motion.q[rows, columns] = np.nan
    free = np.zeros(motion.angles.shape, bool)
    free[rows] = True
    motion.angles[rows] = np.nan
    fill_motion(motion, swing.skeleton, {k: [gap] for k in columns}, free, method, shape)
    return motion


@pytest.mark.parametrize("method", [LINEAR, CUBIC])
def test_uniform_motion_is_filled_exactly(swing: Swing, method: str) -> None:
    """A hand with constant velocities and constant joint rates."""
    uniform = swing.uniform()
    motion = filled(uniform, method, uniform.all_points)
    np.testing.assert_allclose(motion.keypoints, uniform.motion.keypoints, atol=1e-9)
    np.testing.assert_allclose(motion.angles, uniform.motion.angles, atol=1e-9)
    turns = Rotation.from_quat(motion.q[HAND_ROWS].reshape(-1, 4))
    truth = Rotation.from_quat(uniform.motion.q[HAND_ROWS].reshape(-1, 4))
    assert (turns.inv() * truth).magnitude().max() < 1e-7


def test_bone_lengths_are_constant(swing: Swing) -> None:
    motion = filled(swing, LINEAR, swing.all_points)
    for a, b in (("index_mcp", "index_pip"), ("wrist", "middle_mcp"), ("thumb_ip", "thumb_tip")):
        i, j = swing.skeleton.names.index(a), swing.skeleton.names.index(b)
        lengths = np.linalg.norm(motion.keypoints[:, i] - motion.keypoints[:, j], axis=1)
        assert np.ptp(lengths) < 1e-9, (a, b)


def test_a_cubic_follows_a_swing_more_closely_than_a_line(swing: Swing) -> None:
    errors = {}
    for method in (LINEAR, CUBIC):
        motion = filled(swing, method, swing.all_points, gap=(15, 36))  # about its turning point
        away = motion.keypoints[16:36] - swing.motion.keypoints[16:36]
        errors[method] = np.linalg.norm(away, axis=2).mean()
    assert errors[CUBIC] < 0.4 * errors[LINEAR]


def test_a_finger_is_filled_on_a_known_hand(swing: Swing) -> None:
    """Its hand continues to move in the gap, and so does the finger."""
    names = swing.skeleton.names
    index = [k for k, n in enumerate(names) if n.startswith("index_")]
    motion = filled(swing, LINEAR, index)
    others = [k for k in swing.all_points if k not in index]
    assert np.array_equal(motion.keypoints[:, others], swing.motion.keypoints[:, others])
    away = motion.keypoints[HAND_ROWS][:, index] - swing.motion.keypoints[HAND_ROWS][:, index]
    moved = swing.motion.keypoints[GAP[1], index] - swing.motion.keypoints[GAP[0], index]
    assert np.linalg.norm(away, axis=2).max() < 0.2 * np.linalg.norm(moved, axis=1).max()


def test_measured_angles_are_preserved_in_a_gap_of_the_position(swing: Swing) -> None:
    """Where the hand is lost but its packets continue, fingers bend as measured."""
    motion, rows = swing.motion.copy(), HAND_ROWS
    motion.keypoints[rows] = np.nan
    motion.q[rows] = np.nan
    free = np.zeros(motion.angles.shape, bool)
    missing = {k: [GAP] for k in swing.all_points}
    points, angles = fill_motion(motion, swing.skeleton, missing, free, LINEAR)
    assert points[rows].all()
    assert not angles.any()
    assert np.array_equal(motion.angles, swing.motion.angles)
    middle = (GAP[0] + GAP[1]) // 2
    names = swing.skeleton.names
    wrist, tip = names.index("wrist"), names.index("index_tip")
    for m in (motion, swing.motion):
        m.keypoints[middle] -= m.keypoints[middle, wrist]
    local = [
        Rotation.from_quat(m.q[middle, wrist]).inv().apply(m.keypoints[middle, tip])
        for m in (motion, swing.motion)
    ]
    np.testing.assert_allclose(local[0], local[1], atol=1e-6)


def test_the_trajectory_of_another_tracking_is_followed(swing: Swing) -> None:
    """One that is 5 mm off: its shape is used, and both ends match."""
    shape = swing.motion.copy()
    shape.keypoints = shape.keypoints + [0.003, 0.004, 0.0]
    motion = filled(swing, LINEAR, swing.all_points, shape)
    np.testing.assert_allclose(motion.keypoints, swing.motion.keypoints, atol=1e-9)


def test_a_gap_without_an_end_is_unchanged(swing: Swing) -> None:
    motion = swing.motion.copy()
    motion.keypoints[50:] = motion.q[50:] = np.nan
    before = motion.copy()
    free = np.zeros(motion.angles.shape, bool)
    missing = {k: [(49, len(motion.t) - 1)] for k in swing.all_points}
    points, _ = fill_motion(motion, swing.skeleton, missing, free, LINEAR)
    assert not points.any()
    assert np.array_equal(motion.keypoints, before.keypoints, equal_nan=True)


def test_the_skeleton_has_an_origin_for_each_segment(swing: Swing) -> None:
    skeleton: SessionSkeleton = swing.skeleton
    names = [skeleton.names[k] for k in skeleton.origin]
    assert names[skeleton.hand.root] == "wrist"
    assert len(set(names)) == len(skeleton.hand.segments)
