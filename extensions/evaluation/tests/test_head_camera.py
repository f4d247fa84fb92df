"""Tracking with a camera that sways on a head, tilted by 15° since its calibration."""

from dataclasses import replace

import numpy as np
import pytest

from extensions.evaluation.vist.judge import Judge, TrialRecord
from extensions.evaluation.vist.trial import models
from tracker.engine.pipeline import Pipeline
from tracker.geometry import so3
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import CameraImuSample, CameraPose, ImuSample
from tracker.simulation.head import MOVING
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.rig import StereoRig, ideal_rig


def mean_error_mm(tells: str) -> float:
    """The error of the four keypoints in the camera's frame, after the first third of 5.4 s."""
    hand, glove = models()
    calibrated = ideal_rig()
    bent = calibrated.pose.R_GC @ so3.rx(np.deg2rad(15.0))
    rig = StereoRig(calibrated.left, calibrated.right, CameraPose(bent, calibrated.pose.p_GC))
    params = SimulationParams(head=replace(MOVING, tells=tells))
    motion = RandomPostures(hand, seed=2, duration=5.4)
    simulation = Simulation(hand, glove, motion, 2, params, fps=15, rig=rig)
    pipeline, record = Pipeline(hand, glove, calibrated), TrialRecord()
    for m in simulation.messages():
        if isinstance(m, ImuSample):
            record.estimates.append(pipeline.feed_imu(m))
            record.seen.append(0)
            reported = simulation.scene.reported_pose(m.t)
            record.poses.append(reported or pipeline.camera_pose(m.t))
        elif isinstance(m, CameraImuSample):
            pipeline.feed_camera_imu(m)
        else:
            pipeline.feed_frame(m)
    columns = [pipeline.keypoint_names.index(k) for k in MARKED_KEYPOINTS]
    trial = Judge(simulation, pipeline, columns, "camera").trial(record, 0, outage=0.0)
    return float(trial.error.mean() * 1000)


@pytest.fixture(scope="module")
def with_a_pose() -> float:
    return mean_error_mm("pose")


@pytest.mark.long
def test_the_cameras_own_imu_serves_nearly_as_well_as_a_pose(with_a_pose):
    assert with_a_pose < 8.0
    assert mean_error_mm("imu") < with_a_pose + 1.0


@pytest.mark.long
def test_without_either_it_is_worse(with_a_pose):
    assert not mean_error_mm("nothing") < with_a_pose + 1.0
