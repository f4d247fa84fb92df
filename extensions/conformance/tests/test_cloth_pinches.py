"""Pinches of ring and little finger, which carry no sensor, by wearers who bend no other finger:
the conformance rules and the gestures, with what the glove's cloth shows and without it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from extensions.conformance.isaac.record import HandRecord, Stamps, joints_of
from extensions.conformance.shape import judge_steps
from extensions.conformance.take import PINCHES, ScriptStep, take_of
from tests.cloth_scene import Scene
from tracker.geometry import so3
from tracker.gestures.recogniser import GestureRecogniser
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.openxr import joint_radii, openxr_joints
from tracker.messages import Estimate
from tracker.simulation.gestures import OPEN, tip_distances
from tracker.simulation.postures import posture

PINCHED = {
    "ring": {
        "thumb_cmc_flexion": 38.0,
        "thumb_cmc_abduction": -6.0,
        "thumb_cmc_twist": -11.0,
        "thumb_mcp_flexion": 28.0,
        "thumb_mcp_abduction": 3.0,
        "thumb_ip_flexion": 27.0,
        "ring_mcp_flexion": 45.0,
        "ring_pip_flexion": 52.0,
        "ring_dip_flexion": 35.0,
    },
    "little": {
        "thumb_cmc_flexion": 40.0,
        "thumb_cmc_abduction": -10.0,
        "thumb_cmc_twist": -9.0,
        "thumb_mcp_flexion": 46.0,
        "thumb_mcp_abduction": -1.0,
        "thumb_ip_flexion": 41.0,
        "little_mcp_flexion": 51.0,
        "little_pip_flexion": 58.0,
        "little_dip_flexion": 39.0,
    },
}
"""Degrees; the other fingers are those of an open hand."""
ABOVE, BELOW, BESIDE, OUTER_SIDE = -30.0, 160.0, 120.0, -105.0
BEHIND_THUMB = -135.0
"""Degrees of roll: the camera sees the back of the hand, its palm, the side of the thumb, or that
of the little finger."""


class Pinching(Scene):
    """A hand in a posture and a roll (degrees), whose other segments are known."""

    def __init__(self, hand: HandModel, glove: GloveModel, finger: str, roll: float) -> None:
        super().__init__(hand, glove, {})
        angles = posture(hand, OPEN)
        for name, degrees in PINCHED[finger].items():  # no finger follows another
            angles[hand.angle_index[name]] = np.deg2rad(degrees)
        reach = tip_distances(hand, angles)  # a pinch of this finger, and clearly of no other
        assert reach[finger] < 0.012 and min(d for f, d in reach.items() if f != finger) > 0.09
        at = self._complete()[1][hand.root]
        self.R, self.p = hand.forward(angles, so3.exp(np.deg2rad([roll, 0.0, 0.0])), at)
        self.state.R_GB[:] = self.R[list(self.layout.active)]
        self.state.p = at + self.R[hand.root] @ self.layout.root_lever


def judged(hand: HandModel, names: tuple[str, ...], shown: dict[str, Estimate]) -> dict[str, str]:
    """The status of the pinch rules on a take that shows each estimate for 1 s."""
    records, steps, sample = [], [], 0
    for finger, e in shown.items():
        start = sample
        joints = openxr_joints(
            e.keypoints, e.keypoint_q, e.keypoint_state, names, joint_radii(hand)
        )
        for _ in range(30):
            records.append(HandRecord(Stamps(sample, sample, sample), joints_of(joints)))
            sample += 33_000_000
        steps.append(ScriptStep(f"pinch_{finger}", start, sample))
    found = judge_steps(take_of(hand.side, records), steps)
    return {f.rule: f.status for f in found if f.rule in PINCHES}


@pytest.mark.long
@pytest.mark.parametrize("roll", [ABOVE, BELOW])
def test_pinches_of_ring_and_little_finger_are_distinguished_by_the_cloth(
    hand: HandModel, glove: GloveModel, roll: float
) -> None:
    scenes = {finger: Pinching(hand, glove, finger, roll) for finger in PINCHED}
    names = glove.keypoint_names(hand)
    without = {finger: scene.estimate() for finger, scene in scenes.items()}
    with_cloth = {finger: scene.look() for finger, scene in scenes.items()}
    rules = [f"pinch_{finger}" for finger in PINCHED]
    assert judged(hand, names, without) == dict.fromkeys(rules, "fail")
    assert judged(hand, names, with_cloth) == dict.fromkeys(rules, "pass")
    for finger, scene in scenes.items():
        off, sd, _ = scene.point(with_cloth[finger], f"{finger}_tip")
        assert off < 0.012 and off < 3 * sd


def test_a_seen_pinch_of_ring_or_little_finger_is_a_gesture(
    hand: HandModel, glove: GloveModel
) -> None:
    """A finger in front of the palm has no outline, so its pinch is not: it may be elsewhere. From
    the side of the little finger, either of both has nearly the outline of the other."""
    names = glove.keypoint_names(hand)
    for finger, roll, expected in (
        ("ring", BESIDE, ["pinch_ring"]),
        ("ring", BELOW, []),
        ("ring", OUTER_SIDE, ["pinch_ring"]),
        ("little", OUTER_SIDE, ["pinch_little"]),
    ):
        scene = Pinching(hand, glove, finger, roll)
        seen, gestures = scene.look(), GestureRecogniser(hand, names)
        begun = [
            phase.gesture
            for k in range(5)
            for phase in gestures.feed(replace(seen, t=seen.t + 0.01 * k))
            if phase.begins
        ]
        assert begun == expected


def test_a_pinching_little_finger_that_is_hidden_is_where_nothing_refutes_it(
    hand: HandModel, glove: GloveModel
) -> None:
    """Behind the thumb, it has little cloth of its own; an extended one would be seen."""
    scene = Pinching(hand, glove, "little", BEHIND_THUMB)
    off, sd, _ = scene.point(scene.look(), "little_tip")
    assert off < 0.020 and off < 3 * sd
