"""When a hand is called measured, and how fast one moves that a search has found twice."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.engine.pipeline import ABANDONED, Pipeline
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, MatchParams
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.recognition import Recognised, Recognition, SeenImage
from tracker.fusion.chain.state import initial_state
from tracker.fusion.chain.tracking import (
    DOUBT_AFTER,
    EAGER,
    PLACES_APART,
    SPARING,
    STRANGE_FOR,
    SURE_AFTER,
    TrackingJudge,
)
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Blobs, FrameResult, ImuSample, Tracking, Validity
from tracker.simulation.random_postures import RandomPostures, leaving
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import ideal_rig

APART = 1 / 30  # s between two images


@pytest.fixture
def judge() -> TrackingJudge:
    return TrackingJudge(MatchParams())


def test_support_makes_sure_and_not_the_time_that_passes(judge: TrackingJudge) -> None:
    """Two images that support the pose, then two that do not, do not make a tenth of a second."""
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


def test_a_hand_that_images_do_not_show_for_long_is_forgotten(judge: TrackingJudge) -> None:
    judge.judge(0.0, enough=True)
    images = [judge.is_another(t, followed=False) for t in np.arange(0.0, STRANGE_FOR, APART)]
    images += [judge.is_another(STRANGE_FOR, followed=True)]
    images += [judge.is_another(STRANGE_FOR + APART, followed=False)]
    assert not any(images) and judge.tracking == Tracking.TRACKING
    assert judge.is_another(2 * STRANGE_FOR + APART, followed=False)
    assert judge.tracking == Tracking.SEARCHING
    assert not judge.should_start(2 * STRANGE_FOR + 2 * APART)  # nor found again in that instant


def test_speed_is_computed_from_two_positions(judge: TrackingJudge) -> None:
    assert judge.found(5.0, np.array([0.1, 0.2, 0.3])) is None
    v = judge.found(5.0 + APART, np.array([0.1, 0.25, 0.3]))
    assert v is not None and v == pytest.approx([0.0, 1.5, 0.0])
    assert judge.found(5.0 + 2 * APART + PLACES_APART, np.zeros(3)) is None


def test_a_hand_that_comes_back_fast_is_not_measured_elsewhere(
    hand: HandModel, glove: GloveModel
) -> None:
    """Out of view for 1.5 s, it returns at 2 m/s: when it is found, its velocity is unknown."""
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


@pytest.mark.parametrize(
    ("off_px", "strangers", "followed"),
    [(0.0, 0, True), (0.0, 12, True), (9.0, 0, True), (9.0, 12, False)],
)
def test_a_hand_dragged_along_among_strange_patches_is_another(
    hand: HandModel, glove: GloveModel, off_px: float, strangers: int, followed: bool
) -> None:
    """Its blobs are not at the expected positions, and other blobs on it are not markers."""
    layout, rig, rng = ChainLayout(hand, glove), ideal_rig(), np.random.default_rng(2)
    state = initial_state(layout)
    state.P = 1e-5 * np.eye(len(state.P))
    state.p = rig.pose.p_GC + 0.4 * rig.pose.R_GC[:, 2]
    recognition = Recognition(layout, rig, ChainParams())
    nothing = BlobFrame(0.0, 0.0, (), Blobs.empty(), Blobs.empty())
    expected = recognition.look(state, recognition.image(nothing)).prediction
    shown = np.flatnonzero(expected.prior.min(axis=0) > 0.5)
    match = np.full_like(expected.uv[..., 0], -1, np.int64)
    match[:, shown] = np.arange(len(shown))
    sides = []
    for uv in expected.uv[:, shown]:
        more = rng.uniform(uv.min(axis=0), uv.max(axis=0), (strangers, 2))
        all_uv = np.concatenate([uv + (off_px, 0.0), more])
        number = np.arange(len(all_uv))
        sides.append(SeenBlobs(all_uv, np.zeros_like(number), number))
    image = SeenImage(nothing, tuple(sides), rig.pose, None, tuple(sides))
    assert len(shown) > 8
    assert recognition.is_followed(image, Recognised(expected, match)) is followed


def test_tracking_another_hand_is_reported(hand: HandModel, glove: GloveModel) -> None:
    pipeline = Pipeline(hand, glove, ideal_rig())
    nothing = BlobFrame(0.0, 0.0, (), Blobs.empty(), Blobs.empty())
    given_up = replace(FrameResult.nothing(0.0, Tracking.TRACKING, 37), another=True)
    pipeline.engine.take_results = lambda: [given_up]  # type: ignore[method-assign]
    pipeline.feed_frame(nothing)
    assert pipeline.drain_notices() == [ABANDONED]
    assert pipeline.drain_notices() == []
