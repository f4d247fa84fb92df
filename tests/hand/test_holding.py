"""Evaluation of a held guided pose from an estimate alone."""

import dataclasses

import numpy as np
import pytest

from tracker.hand.holding import NOTHING_ARRIVES, how_held
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.hand.poses import POSES
from tracker.messages import Estimate, Tracking, Validity


def shown(hand: HandModel, bent: dict[str, float], measured: bool = True) -> Estimate:
    """An estimate of a hand with these angles, rad, all measured or none."""
    angles = np.zeros(len(hand.joint_names))
    for name, value in bent.items():
        angles[hand.angle_index[name]] = value
    R, p = hand.forward(angles, np.eye(3), np.zeros(3))
    k = len(hand.keypoint_names)
    state = int(Validity.MEASURED if measured else Validity.INFERRED)
    return Estimate(
        0.0,
        Tracking.TRACKING,
        hand.keypoints(R, p),
        np.zeros((k, 4)),
        np.full(k, state),
        np.zeros(k),
        angles,
        np.full(len(angles), state),
        R,
        p,
    )


def fist() -> dict[str, float]:
    return {f"{f.joint}_flexion": f.value for f in POSES["fist"].flexions if f.joint[:5] != "thumb"}


@pytest.mark.parametrize("pose", ["flat", "spread"])
def test_a_straight_hand_is_flat(hand, pose):
    assert how_held(POSES[pose], shown(hand, {}), hand).is_held


def test_a_fist_is_a_fist_and_not_flat(hand):
    assert how_held(POSES["fist"], shown(hand, fist()), hand).is_held
    assert not how_held(POSES["flat"], shown(hand, fist()), hand).is_held


def test_the_joint_with_the_largest_deviation_is_named_with_an_instruction(hand):
    bent = {"index_pip_flexion": 0.9, "middle_pip_flexion": 0.5}
    held = how_held(POSES["flat"], shown(hand, bent), hand)
    assert (held.is_held, held.joint) == (False, "index_pip")
    assert held.off == pytest.approx(0.9)
    assert held.word == "Straighten the index finger more"
    open_fist = how_held(POSES["fist"], shown(hand, {}), hand)
    assert open_fist.off < 0 and open_fist.word.startswith("Bend")


def test_fingertips_apart_are_not_a_pinch(hand):
    held = how_held(POSES["pinch_index"], shown(hand, {}), hand)
    assert (held.is_held, held.joint) == (False, "index")
    assert held.off > 0.05
    assert "thumb" in held.word


def pinching(hand: HandModel, finger: str, apart: float, tracking: Tracking) -> Estimate:
    """A straight hand whose thumb's end segment was moved to ``apart`` m from a fingertip."""
    estimate = shown(hand, {})
    thumb, other = (hand.index[CHAINS[d][-1]] for d in ("thumb", finger))
    R, p = estimate.segment_R, estimate.segment_p.copy()
    ends = [p[r] + R[r] @ [hand.segments[r].length, 0.0, 0.0] for r in (thumb, other)]
    p[thumb] += ends[1] + R[hand.root] @ [0.0, 0.0, -apart] - ends[0]
    return dataclasses.replace(estimate, segment_p=p, tracking=tracking)


def test_touching_tips_are_distinguished_from_separate_ones(hand):
    """For 8 pinches of 4 simulated people the tracked axes' ends are 15 to 31 mm apart, for their
    other poses 46 and more; without a camera 17 to 45 mm."""
    for apart, tracking, is_held in (
        (0.031, Tracking.TRACKING, True),
        (0.046, Tracking.TRACKING, False),
        (0.045, Tracking.LOST, True),
    ):
        held = how_held(POSES["pinch_index"], pinching(hand, "index", apart, tracking), hand)
        assert held.is_held == is_held


def test_the_thumb_on_another_finger_is_not_accepted(hand):
    beside = pinching(hand, "middle", 0.015, Tracking.TRACKING)
    assert how_held(POSES["pinch_middle"], beside, hand).is_held
    held = how_held(POSES["pinch_index"], beside, hand)
    assert (held.is_held, held.joint) == (False, "index")


def test_unmeasured_joints_do_not_count_against_the_wearer(hand):
    guessed = shown(hand, fist(), measured=False)
    states = guessed.angle_state.copy()
    states[hand.angle_index["thumb_cmc_flexion"]] = int(Validity.MEASURED)
    guessed = dataclasses.replace(guessed, angle_state=states)
    for pose in ("flat", *(f"pinch_{f}" for f in FINGERS)):
        held = how_held(POSES[pose], guessed, hand)
        assert held.is_held and held.joint  # and reports that it was not evaluated


def test_a_guessed_hand_holds_no_pose(hand):
    """The glove was unplugged: the last pose is displayed, and its images may continue."""
    for pose in POSES:
        held = how_held(POSES[pose], shown(hand, {}, measured=False), hand)
        assert (held.is_held, held.joint) == (False, NOTHING_ARRIVES)


def test_a_missing_hand_holds_no_pose(hand):
    estimate = shown(hand, {})
    object.__setattr__(estimate, "tracking", Tracking.SEARCHING)
    assert not how_held(POSES["flat"], estimate, hand).is_held
