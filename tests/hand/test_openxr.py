"""OpenXR's joints against the text of its specification."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from tests.fixtures import RESOURCES
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.hand.openxr import JOINTS, OpenXrHand, joint_radii, openxr_joints, to_openxr
from tracker.messages import Estimate, Tracking, Validity

CHAINS = [
    [j for j in JOINTS if j.startswith(f)] for f in ("thumb", "index", "middle", "ring", "little")
]


def estimate(hand: HandModel, angles: np.ndarray, R_GB: np.ndarray, lost: str = "") -> Estimate:
    R, p = hand.forward(angles, R_GB, np.array([0.4, -0.1, 0.2]))
    points = hand.keypoints(R, p)
    q = Rotation.from_matrix(R).as_quat()[list(hand.keypoint_segment)]
    gone = np.array([n == lost for n in hand.keypoint_names])
    points[gone], q[gone] = np.nan, np.nan
    state = np.where(gone, int(Validity.LOST), int(Validity.MEASURED))
    known = np.full(len(angles), int(Validity.MEASURED))
    return Estimate(
        0.0, Tracking.TRACKING, points, q, state, np.zeros(len(state)), angles, known, R, p
    )


def converted(side: str = "right", R_GB: np.ndarray | None = None, lost: str = "") -> OpenXrHand:
    hand = load_hand(RESOURCES / "hands" / f"reference-{side}.toml")
    rng = np.random.default_rng(3)
    angles = rng.uniform(*hand.angle_limits.T)
    pose = np.eye(3) if R_GB is None else R_GB
    return to_openxr(estimate(hand, angles, pose, lost), hand.keypoint_names, joint_radii(hand))


def axes(xr: OpenXrHand, joint: str) -> np.ndarray:
    """Columns: the joint's axes in OpenXR's world, computed by an independent library."""
    return Rotation.from_quat(xr.orientation[JOINTS.index(joint)]).as_matrix()


def test_there_are_26_joints_in_the_order_of_the_header() -> None:
    assert len(JOINTS) == 26
    assert JOINTS[:7] == (
        "palm",
        "wrist",
        "thumb_metacarpal",
        "thumb_proximal",
        "thumb_distal",
        "thumb_tip",
        "index_metacarpal",
    )
    assert JOINTS[10] == "index_tip" and JOINTS[25] == "little_tip"


@pytest.mark.parametrize("side", ["right", "left"])
def test_minus_z_points_from_each_joint_to_the_next(side: str) -> None:
    xr = converted(side, Rotation.from_euler("xyz", [0.3, -0.8, 1.9]).as_matrix())
    for chain in CHAINS:
        for a, b in pairwise(chain):
            bone = xr.position[JOINTS.index(b)] - xr.position[JOINTS.index(a)]
            assert_allclose(-axes(xr, a)[:, 2], bone / np.linalg.norm(bone), atol=1e-6, err_msg=a)


@pytest.mark.parametrize("side", ["right", "left"])
def test_a_flat_hand_palm_down_pointing_forward_is_not_rotated(side: str) -> None:
    hand = load_hand(RESOURCES / "hands" / f"reference-{side}.toml")
    e = estimate(hand, np.zeros(len(hand.joint_names)), np.eye(3))
    xr = to_openxr(e, hand.keypoint_names, joint_radii(hand))
    for joint in ("palm", "wrist", "index_proximal", "little_tip"):
        assert_allclose(axes(xr, joint), np.eye(3), atol=1e-9, err_msg=joint)
    wrist, middle, thumb = (
        xr.position[JOINTS.index(j)] for j in ("wrist", "middle_tip", "thumb_tip")
    )
    assert_allclose(wrist, [0.1, 0.2, -0.4], atol=1e-12)  # G (0.4, -0.1, 0.2): x is G's -y
    assert middle[2] < wrist[2] - 0.1, "fingers point along -z"
    assert (thumb[0] < wrist[0]) == (side == "right"), "a right thumb is on the left"


def test_the_back_of_the_hand_faces_y() -> None:
    R_GB = Rotation.from_euler("x", 180, degrees=True).as_matrix()  # palm up
    xr = converted(R_GB=R_GB)
    assert_allclose(axes(xr, "wrist")[:, 1], [0, -1, 0], atol=1e-9)


def test_palm_and_metacarpals_are_inferred_and_between_wrist_and_knuckles() -> None:
    xr = converted()
    row = JOINTS.index
    assert xr.state[row("palm")] == xr.state[row("ring_metacarpal")] == Validity.INFERRED
    assert xr.state[row("index_proximal")] == Validity.MEASURED
    metacarpal, knuckle = row("middle_metacarpal"), row("middle_proximal")
    middle = (xr.position[metacarpal] + xr.position[knuckle]) / 2
    assert_allclose(xr.position[0], middle, atol=1e-12)


def test_lost_joints_are_nan_without_flags_and_so_are_dependent_ones() -> None:
    xr = converted(lost="middle_mcp")
    for joint in ("middle_proximal", "middle_metacarpal", "palm"):
        i = JOINTS.index(joint)
        assert np.isnan(xr.position[i]).all() and np.isnan(xr.orientation[i]).all()
        assert xr.flags[i] == 0 and np.isnan(xr.radius[i])
    assert xr.flags[JOINTS.index("middle_tip")] == 0b1111
    assert xr.flags[JOINTS.index("index_metacarpal")] == 0b0011
    assert np.isnan(converted(lost="wrist").position[0]).all()


def test_a_radius_is_half_the_fingers_thickness_at_the_joint() -> None:
    hand = load_hand(RESOURCES / "hands" / "reference-right.toml")
    xr = converted()
    thickness = {s.name: 2 * s.radius for s in hand.segments}
    wanted = {
        "wrist": "dorsum",
        "palm": "dorsum",
        "ring_metacarpal": "dorsum",
        "thumb_metacarpal": "thumb_metacarpal",
        "index_intermediate": "index_intermediate",
        "little_tip": "little_distal",
    }
    for joint, segment in wanted.items():
        assert xr.radius[JOINTS.index(joint)] == thickness[segment] / 2, joint


def test_many_times_at_once_equal_single_ones() -> None:
    hand = load_hand(RESOURCES / "hands" / "reference-left.toml")
    rng = np.random.default_rng(8)
    found = [
        estimate(hand, rng.uniform(*hand.angle_limits.T), Rotation.random(rng=rng).as_matrix(), n)
        for n in ("", "wrist", "index_mcp", "")
    ]
    many = openxr_joints(
        np.array([e.keypoints for e in found]),
        np.array([e.keypoint_q for e in found]),
        np.array([e.keypoint_state for e in found]),
        hand.keypoint_names,
        joint_radii(hand),
    )
    for k, e in enumerate(found):
        one = to_openxr(e, hand.keypoint_names, joint_radii(hand))
        for name in ("position", "orientation", "state", "radius"):
            assert_allclose(getattr(many, name)[k], getattr(one, name), atol=1e-14, err_msg=name)
