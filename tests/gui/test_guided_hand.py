"""The hand in the drawings of guided poses matches the poses, right and left."""

import numpy as np
import pytest

from app.viewmodels.guided_hand import AGAIN, MOVE, DrawnHand
from app.viewmodels.guided_words import POSE_NAMES, POSE_WORDS
from resources import folder
from tracker.hand.files import parse_hand
from tracker.hand.names import CHAINS
from tracker.hand.poses import POSES


def hand_of(name: str):
    return parse_hand((folder("hands") / f"{name}.toml").read_text("utf-8"))


RIGHT, LEFT = hand_of("reference-right"), hand_of("reference-left")


@pytest.mark.parametrize("hand", [RIGHT, LEFT], ids=["right", "left"])
@pytest.mark.parametrize("pose", POSES)
def test_drawn_joints_match_the_pose(hand, pose):
    """Within 2.5 standard deviations: accepted for a wearer who copies the drawing."""
    angles = DrawnHand(hand).angles(pose)
    for held in POSES[pose].flexions:
        off = angles[hand.angle_index[f"{held.joint}_flexion"]] - held.value
        assert abs(off) < 2.5 * held.sd, held.joint


@pytest.mark.parametrize("hand", [RIGHT, LEFT], ids=["right", "left"])
@pytest.mark.parametrize("pose", [p for p in POSES if POSES[p].touches])
def test_drawn_pads_meet(hand, pose):
    shown = DrawnHand(hand).shown("", pose, MOVE)
    pads = []
    for digit in ("thumb", POSES[pose].touches):
        row = hand.index[CHAINS[digit][-1]]
        segment = hand.segments[row]
        pad = [segment.length - 0.005, 0.0, -segment.radius]
        pads.append(shown.p[row] + shown.R[row] @ pad)
    assert np.linalg.norm(pads[0] - pads[1]) < 0.004


def test_a_left_hand_is_the_mirror_image_of_a_right_one():
    mirror = np.array([1.0, -1.0, 1.0])
    for pose in POSES:
        right, left = (DrawnHand(hand).shown("fist", pose, 0.4) for hand in (RIGHT, LEFT))
        np.testing.assert_allclose(left.p, right.p * mirror, atol=1e-6)
        np.testing.assert_allclose(left.eye, right.eye * mirror, atol=1e-12)


def test_the_transition_is_repeated_from_rest_but_not_while_a_pose_is_held():
    drawn = DrawnHand(RIGHT)
    there, held = (drawn.shown("flat", "fist", t).p for t in (MOVE, AGAIN + 0.1))
    np.testing.assert_allclose(held, there)
    again = drawn.shown("flat", "fist", AGAIN + 0.1, again=True).p
    assert np.abs(again - there).max() > 0.02


def test_every_pose_has_an_instruction():
    assert set(POSE_WORDS) == set(POSE_NAMES) == set(POSES)
