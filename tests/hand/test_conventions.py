"""Orders and axes of other hand software, on hands with known poses."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from glovetrack.conventions import MANO, MEDIAPIPE, to_mano, to_mediapipe, to_operator
from tests.fixtures import RESOURCES
from tracker.geometry import so3
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel

OPERATOR2MANO = {
    "right": np.array([[0, 0, -1], [-1, 0, 0], [0, 1, 0]]),
    "left": np.array([[0, 0, -1], [1, 0, 0], [0, -1, 0]]),
}
"""dex-retargeting, src/dex_retargeting/constants.py."""


def posed(hand: HandModel, flexion: float, R: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Keypoints and their quaternions with every joint bent by ``flexion`` rad."""
    angles = np.array([flexion if n.endswith("flexion") else 0.0 for n in hand.joint_names])
    R_GB, p_GB = hand.forward(angles, R, np.array([0.3, 0.2, -0.1]))
    return hand.keypoints(R_GB, p_GB), so3.quat_from_matrix(R_GB)[list(hand.keypoint_segment)]


def side(name: str) -> HandModel:
    return load_hand(RESOURCES / "hands" / f"reference-{name}.toml")


def test_mediapipe_has_four_landmarks_per_finger_after_the_wrist() -> None:
    hand = side("right")
    points, _ = posed(hand, 0.0, np.eye(3))
    found = to_mediapipe(points, hand.keypoint_names)
    by_number = {0: "wrist", 1: "thumb_cmc", 4: "thumb_tip", 5: "index_mcp", 8: "index_tip"}
    by_number |= {
        9: "middle_mcp",
        12: "middle_tip",
        16: "ring_tip",
        17: "little_mcp",
        20: "little_tip",
    }
    assert len(MEDIAPIPE) == 21
    for number, name in by_number.items():
        assert_allclose(found[number], points[hand.keypoint_names.index(name)], err_msg=name)
    reach = np.linalg.norm(found - found[0], axis=1)
    assert all((np.diff(reach[k : k + 4]) > 0).all() for k in (1, 5, 9, 13, 17)), "root to tip"


def test_mano_orders_index_middle_little_ring_thumb_then_tips() -> None:
    hand = side("right")
    points, _ = posed(hand, 0.0, np.eye(3))
    found = to_mano(points, hand.keypoint_names)
    assert found.shape == (21, 3) and len(set(MANO)) == 21
    y = found[[4, 1, 10, 7], 1]  # knuckles of middle, index, ring, little on a flat right hand
    assert y[1] > y[0] > y[2] > y[3], "index is to the thumb's side, which is y"
    assert_allclose(found[7], points[hand.keypoint_names.index("little_mcp")])
    assert_allclose(found[13], points[hand.keypoint_names.index("thumb_cmc")])
    tips = [f"{f}_tip" for f in ("thumb", "index", "middle", "ring", "little")]
    assert_allclose(found[16:], points[[hand.keypoint_names.index(t) for t in tips]])


def test_a_keypoint_that_a_glove_lacks_is_nan() -> None:
    hand = side("right")
    points, _ = posed(hand, 0.0, np.eye(3))
    names = hand.keypoint_names
    present = [i for i, n in enumerate(names) if n != "ring_tip"]
    found = to_mediapipe(points[present], [names[i] for i in present])
    assert np.isnan(found[16]).all() and np.isfinite(np.delete(found, 16, axis=0)).all()


@pytest.mark.parametrize("name", ["right", "left"])
def test_in_the_operator_frame_a_fist_bends_to_x_and_a_flat_hand_points_along_z(name: str) -> None:
    hand = side(name)
    R = Rotation.from_euler("xyz", [0.4, -1.1, 2.0]).as_matrix()
    flat = to_operator(*posed(hand, 0.0, R), hand.keypoint_names)
    bent = to_operator(*posed(hand, 0.8, R), hand.keypoint_names)
    assert_allclose(flat[0], 0.0, atol=1e-12)
    assert flat[12, 2] > 0.17 and abs(flat[12, 0]) < 0.01, "the middle finger points along z"
    assert (flat[5, 1] > flat[17, 1]) == (name == "right"), "y is to the left of a hand palm down"
    assert bent[12, 0] > 0.05, "fingers bend to the palm, which x leaves"


@pytest.mark.parametrize("name", ["right", "left"])
def test_the_operator_frame_is_that_fitted_by_dex_retargeting(name: str) -> None:
    """An independent implementation of its recipe; our knuckles are within 1 mm of the dorsum's
    plane: 3°."""
    hand = side(name)
    R = Rotation.from_euler("xyz", [-0.9, 0.3, 1.2]).as_matrix()
    points, q = posed(hand, 0.5, R)
    p = to_mediapipe(points, hand.keypoint_names) - points[0]
    wrist, index, middle = p[0], p[5], p[9]
    normal = np.cross(index - wrist, middle - wrist)
    normal /= np.linalg.norm(normal)
    x = (wrist - middle) - ((wrist - middle) @ normal) * normal
    x /= np.linalg.norm(x)
    z = np.cross(x, normal)
    if z @ (index - middle) < 0:
        z, normal = -z, -normal
    theirs = p @ np.column_stack([x, normal, z]) @ OPERATOR2MANO[name]
    ours = to_operator(points, q, hand.keypoint_names)
    reach = np.linalg.norm(p, axis=1)
    assert_allclose(ours, theirs, atol=np.sin(np.deg2rad(3.0)) * reach.max())


def test_many_times_at_once() -> None:
    hand = side("left")
    poses = [posed(hand, a, Rotation.random(rng=k).as_matrix()) for k, a in enumerate((0.1, 0.6))]
    points, q = (np.array(x) for x in zip(*poses, strict=True))
    both = to_operator(points, q, hand.keypoint_names)
    for k in (0, 1):
        assert_allclose(both[k], to_operator(points[k], q[k], hand.keypoint_names), atol=1e-14)
