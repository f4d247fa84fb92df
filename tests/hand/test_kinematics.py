"""Invariants of forward kinematics."""

import numpy as np
import pytest

from tracker.hand.model import HandModel


def random_angles(hand: HandModel, seed: int) -> np.ndarray:
    low, high = hand.angle_limits.T
    return low + np.random.default_rng(seed).random(len(low)) * (high - low)


def test_bone_lengths_are_constant(hand: HandModel) -> None:
    _, p = hand.forward(random_angles(hand, 9), np.eye(3), np.zeros(3))
    for name in ("index_intermediate", "middle_distal", "thumb_proximal"):
        i = hand.index[name]
        parent = hand.parent[i]
        length = hand.segments[parent].length
        assert np.linalg.norm(p[i] - p[parent]) == pytest.approx(length)


def test_flexion_bends_to_the_palm(hand: HandModel) -> None:
    angles = np.zeros(len(hand.joint_names))
    angles[hand.angle_index["index_mcp_flexion"]] = np.pi / 2
    points = hand.keypoints(*hand.forward(angles, np.eye(3), np.zeros(3)))
    mcp, tip = (points[hand.keypoint_names.index(f"index_{k}")] for k in ("mcp", "tip"))
    assert tip[2] - mcp[2] < -0.08 and abs(tip[0] - mcp[0]) < 1e-9


def test_synergies_are_chained_and_limited(hand: HandModel) -> None:
    angles = np.zeros(len(hand.joint_names))
    known = np.zeros(len(angles), bool)
    pip = hand.angle_index["middle_pip_flexion"]
    angles[pip], known[pip] = 1.2, True
    out, inferred = hand.apply_synergies(angles, known)
    little_dip = hand.angle_index["little_dip_flexion"]
    assert out[little_dip] == pytest.approx(1.2 * 1.0 * 0.95 * 0.67)
    assert inferred[little_dip] and not inferred[pip]
    assert not inferred[hand.angle_index["index_dip_flexion"]]
    assert np.all(out[inferred] <= hand.angle_limits[inferred, 1])
