"""Guided poses of simulated people have the properties stated in docs/sessions.md."""

import itertools

import numpy as np
import pytest

from tracker.geometry.solids import nearest_to_axis
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.hand.poses import EARLY, LATE, POSES
from tracker.simulation.guided import HELD_BADLY, GuidedPoses, HoldParams
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.wearer import Wearer

pytestmark = pytest.mark.long

PEOPLE = range(3)


def led(hand: HandModel, glove: GloveModel, seed: int, params: HoldParams) -> GuidedPoses:
    then = RandomPostures(hand, seed, duration=3.0)
    return GuidedPoses(Wearer.random(hand, glove, seed), then, seed, params)


@pytest.fixture(scope="module", params=PEOPLE)
def held(request, hand: HandModel, glove: GloveModel):
    """The wearer, and the poses."""
    seed = request.param
    return Wearer.random(hand, glove, seed), led(hand, glove, seed, HoldParams())


def middle_of(motion: GuidedPoses, pose: str) -> float:
    """A time (s) at which a pose is held."""
    begin, end = (e.t for e in motion.events if e.data["pose"] == pose)
    return (begin + LATE + end - EARLY) / 2


def gap(wearer: Wearer, motion: GuidedPoses, finger: str, t: float) -> tuple[float, float]:
    """Between the surfaces of thumb and fingertip, m, and its distance from the finger's tip."""
    truth, hand = wearer.truth(motion, np.array([t])), wearer.hand
    rows = [hand.index[CHAINS[d][-1]] for d in ("thumb", finger)]
    length = [hand.segments[r].length * wearer.scale[r, 0] for r in rows]
    radius = [hand.segments[r].radius * wearer.scale[r, 2] for r in rows]
    p, x = truth.p_GB[0, rows], truth.R_GB[0, rows, :, 0]
    d, w = length[0] * x[0], p[0] - p[1]
    t0, along = nearest_to_axis(d @ d, d @ x[1], d @ w, x[1] @ w, length[1])
    apart = np.linalg.norm(w + t0 * d - along * x[1])
    return float(apart - sum(radius)), length[1] - along


def test_pads_meet_near_the_fingertips(held):
    wearer, motion = held
    for finger in FINGERS:
        between, from_tip = gap(wearer, motion, finger, middle_of(motion, f"pinch_{finger}"))
        assert abs(between) < 6e-3  # two of the stated standard deviations
        assert from_tip < 15e-3


def test_flat_fingers_are_straight_and_a_fist_is_bent(held):
    wearer, motion = held
    for pose in ("flat", "spread", "fist"):
        angles = wearer.truth(motion, np.array([middle_of(motion, pose)])).angles[0]
        for f in POSES[pose].flexions:
            off = angles[wearer.hand.angle_index[f"{f.joint}_flexion"]] - f.value
            assert abs(off) < 4.5 * f.sd, (pose, f.joint)


def test_transitions_between_poses_are_smooth(held):
    _, motion = held
    t = np.arange(0.0, motion.duration, 0.005)
    poses = motion.poses(t)
    assert np.abs(np.diff(poses.angles, axis=0)).max() < 0.1  # rad: 20 rad/s
    assert np.linalg.norm(np.diff(poses.p_GB, axis=0), axis=1).max() < 0.01


def test_events_mark_the_begin_and_end_of_each_pose(held):
    _, motion = held
    events = motion.events
    assert [e.data["pose"] for e in events[::2]] == list(POSES)
    assert all(a.t < b.t for a, b in itertools.pairwise(events))
    assert 25.0 < events[-1].t < 35.0


def test_badly_held_pads_do_not_touch(hand, glove):
    motion = led(hand, glove, 1, HELD_BADLY)
    wearer = Wearer.random(hand, glove, 1)
    gaps = [gap(wearer, motion, f, middle_of(motion, f"pinch_{f}"))[0] for f in FINGERS]
    assert np.median(gaps) > 4e-3
