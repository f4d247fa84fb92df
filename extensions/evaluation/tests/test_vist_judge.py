"""Errors with a camera on the head are measured in its frame."""

from types import SimpleNamespace

import numpy as np
import pytest

from extensions.evaluation.vist.cases import Case
from extensions.evaluation.vist.judge import Judge, TrialRecord
from extensions.evaluation.vist.scenes import motion_of, simulation_of
from extensions.evaluation.vist.trial import models
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Validity


@pytest.fixture(scope="module")
def simulation():
    hand, glove = models()
    case = Case("head", "chain", minutes=0.1)
    return simulation_of(case, hand, glove, motion_of(case, hand, 0, None), 0, None)


def seen_through(simulation, t):
    """The estimate of a perfect tracker that relies on the reported pose."""
    truth = simulation.truth(t)
    true, reported = simulation.scene.pose(t), simulation.scene.reported_pose(t)
    p_C = (truth.keypoints - true.p_GC) @ true.R_GC
    keypoints = p_C @ reported.R_GC.T + reported.p_GC
    sd = np.ones(len(keypoints))
    state = np.full(len(keypoints), int(Validity.MEASURED))
    return SimpleNamespace(
        t=t, keypoints=keypoints, keypoint_sd=sd, keypoint_state=state, angles=truth.angles
    )


def judged(simulation, place):
    names = simulation.glove.keypoint_names(simulation.hand)
    times = np.arange(2.5, 5.5, 0.25)
    record = TrialRecord(
        estimates=[seen_through(simulation, t) for t in times],
        poses=[simulation.scene.reported_pose(t) for t in times],
        seen=[9] * len(times),
    )
    columns = [names.index(k) for k in MARKED_KEYPOINTS]
    pipeline = SimpleNamespace(hand=simulation.hand, keypoint_names=names)
    return Judge(simulation, pipeline, columns, place).trial(record, 0, outage=0.0)


def test_a_wrong_camera_pose_is_not_an_error_in_the_cameras_frame(simulation):
    trial = judged(simulation, "camera")
    assert len(trial.t) == 12
    np.testing.assert_allclose(trial.error, 0, atol=1e-12)


def test_the_same_estimates_are_wrong_in_the_room_by_the_poses_error(simulation):
    """3 mm along each axis and 0.5° at about 0.4 m: some millimetres."""
    trial = judged(simulation, "world")
    assert 0.001 < trial.error.mean() < 0.02
    columns = [trial.whole.names.index(k) for k in MARKED_KEYPOINTS]
    np.testing.assert_array_equal(trial.whole.error[:, columns], trial.error)


def test_only_the_head_experiment_moves_the_camera(simulation):
    hand, glove = models()
    case = Case("free", "chain", minutes=0.1)
    still = simulation_of(case, hand, glove, motion_of(case, hand, 0, None), 0, None)
    assert still.scene.reported_pose(1.0) is None
    assert simulation.scene.reported_pose(1.0) is not None
