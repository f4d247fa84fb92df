"""A hand that was out of view for a while is found at its first images."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.params import MatchParams
from tracker.fusion.chain.tracking import SURE_AFTER, TrackingJudge
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Blobs, ImuSample, Tracking, Validity
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

BACK = 0.15  # s from the first image until the hand is found


@pytest.mark.parametrize("seed", [0, 2])
def test_a_hand_is_found_again_at_once(hand: HandModel, glove: GloveModel, seed: int) -> None:
    """Its position is known to several centimetres, so each marker alone may be several blobs."""
    gone, back, end = 2.5, 3.5, 4.0
    sim = Simulation(hand, glove, RandomPostures(hand, seed, 3.0, duration=end), seed, fps=30)
    pipeline, estimates = Pipeline(hand, glove, sim.rig), []
    for message in sim.feed():
        if isinstance(message, ImuSample):
            estimates.append(pipeline.feed_imu(message))
        else:
            pipeline.feed_frame(_unseen(message) if gone <= message.t < back else message)
    late = [e for e in estimates if e.t > back + BACK]
    assert all(e.tracking == Tracking.TRACKING for e in late)
    shown = [e for e in estimates if e.t > gone and e.tracking != Tracking.LOST]
    true = np.array([x.keypoints for x in sim.truths(np.array([e.t for e in shown]))])
    error = np.linalg.norm(np.array([e.keypoints for e in shown]) - true, axis=2)
    dorsum = pipeline.keypoint_names.index("dorsum")
    sd = np.array([e.keypoint_sd[dorsum] for e in shown])
    assert (error[:, dorsum] < 3 * sd).mean() > 0.97
    measured = np.array([e.keypoint_state for e in shown]) == int(Validity.MEASURED)
    assert measured[-1].any() and error[measured].max() < 0.05


def _unseen(frame: BlobFrame) -> BlobFrame:
    return replace(frame, left=Blobs.empty(), right=Blobs.empty())


def test_what_supported_another_pose_does_not_count() -> None:
    """Images are 0.2 s apart, as on a computer that is too slow: a search then moves the hand."""
    judge = TrackingJudge(MatchParams())
    assert [judge.support(t, there=True) for t in (0.0, 0.2, 0.4)] == [False, True, True]
    judge.found(0.6, np.zeros(3))
    assert not judge.support(0.6, there=True)
    assert judge.support(0.6 + 1.1 * SURE_AFTER, there=True)
