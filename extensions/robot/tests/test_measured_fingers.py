"""The robot's ring and little finger follow those that only the glove's cloth shows."""

from __future__ import annotations

import numpy as np

from extensions.robot.retarget import Retargeter
from extensions.robot.teleop import target_map
from extensions.robot.tests.hands import shadow
from extensions.robot.wearer_hand import (
    FINGERS,
    WearerHand,
    hand_from_estimate,
    hand_from_keypoints,
)
from tests.cloth_scene import Scene
from tracker.geometry import so3
from tracker.glove.library import load
from tracker.messages import Array

BENT = {"ring": (0.0, 0.0), "little": (30.0, 0.0)}


def robot_tips(hand: WearerHand) -> Array:
    """(5, 3) m of the robot after it has reached this hand's posture."""
    fingers = Retargeter(shadow(), 100.0)
    targets, known = target_map(shadow(), 1.0).targets(hand)
    for _ in range(40):
        angles = fingers.step(targets, known, 0.01)
    return fingers.tips(angles)


def test_the_robot_follows_a_finger_that_the_cloth_measures() -> None:
    hand, glove = load()
    scene, names = Scene(hand, glove, BENT), glove.keypoint_names(hand)
    q = so3.quat_from_matrix(scene.R[hand.root])
    points = hand.keypoints(scene.R, scene.p)
    true = robot_tips(hand_from_keypoints(0.0, True, points, np.full(len(points), 2), q))
    before, after = (
        robot_tips(hand_from_estimate(estimate, names))
        for estimate in (scene.estimate(), scene.look())
    )
    ring, little = FINGERS.index("ring"), FINGERS.index("little")
    off_before, off_after = (np.linalg.norm(tips - true, axis=1) for tips in (before, after))
    # Without the cloth it follows the extended middle finger.
    assert off_before[little] > 0.02
    # Within the accuracy of a finger in plain sight, scaled to the robot's longer fingers.
    assert off_after[little] < 0.5 * off_before[little]
    assert max(off_after[ring], off_after[little]) < 0.015
