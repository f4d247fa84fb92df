"""When a hand is called measured, and how fast one moves that a search has found twice."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.fusion.chain.params import MatchParams
from tracker.fusion.chain.tracking import (
    DOUBT_AFTER,
    EAGER,
    PLACES_APART,
    SPARING,
    SURE_AFTER,
    TrackingJudge,
)
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import ImuSample, Validity
from tracker.pipeline import Pipeline
from tracker.simulation.random_postures import RandomPostures, leaving
from tracker.simulation.scenario import Simulation

APART = 1 / 30  # s between two images


@pytest.fixture
def judge() -> TrackingJudge:
    return TrackingJudge(MatchParams())


def test_support_makes_sure_and_not_the_time_that_passes(judge: TrackingJudge) -> None:
    """Two images that support the pose, then two that do not, are no tenth of a second of it."""
    images = [judge.support(k * APART, there=k < 2) for k in range(4)]
    assert 3 * APART > SURE_AFTER > APART and 2 * APART < DOUBT_AFTER
    assert images == [False] * 4
    other = TrackingJudge(MatchParams())
    assert [other.support(k * APART, there=True) for k in range(5)] == [False] * 3 + [True] * 2


def test_a_hand_searched_for_in_vain_is_searched_for_less_often(judge: TrackingJudge) -> None:
    """A search takes up to 0.1 s of a core; one whose image shows nothing takes no time."""
    due = [t for t in np.arange(0.0, 6.0, APART) if judge.should_start(t)]
    assert max(np.diff([t for t in due if t <= EAGER])) < 0.14
    assert min(np.diff([t for t in due if t > EAGER + SPARING])) >= SPARING
    judge.saw_nothing()
    again = [t for t in np.arange(6.3, 7.0, APART) if judge.should_start(t)]
    assert max(np.diff(again)) < 0.14


def test_two_places_tell_how_fast_the_hand_moves(judge: TrackingJudge) -> None:
    assert judge.found(5.0, np.array([0.1, 0.2, 0.3])) is None
    v = judge.found(5.0 + APART, np.array([0.1, 0.25, 0.3]))
    assert v is not None and v == pytest.approx([0.0, 1.5, 0.0])
    assert judge.found(5.0 + 2 * APART + PLACES_APART, np.zeros(3)) is None


def test_a_hand_that_comes_back_fast_is_not_measured_elsewhere(
    hand: HandModel, glove: GloveModel
) -> None:
    """Out of view for 1.5 s it comes in at 2 m/s: where it is found its velocity is unknown."""
    motion = leaving(RandomPostures(hand, 900, duration=4.2), ((1.7, 3.2),))
    sim = Simulation(hand, glove, motion, 900, fps=30)
    pipeline = Pipeline(hand, glove, sim.rig)
    estimates = []
    for message in sim.feed():
        if isinstance(message, ImuSample):
            estimates.append(pipeline.feed_imu(message))
        else:
            pipeline.feed_frame(message)
    back = [e for e in estimates if e.t > 3.2]
    true = np.array([x.keypoints for x in sim.truths(np.array([e.t for e in back]))])
    error = np.linalg.norm(np.array([e.keypoints for e in back]) - true, axis=2)
    measured = np.array([e.keypoint_state for e in back]) == int(Validity.MEASURED)
    assert measured[-1].sum() > 8
    assert error[measured].max() < 0.05
