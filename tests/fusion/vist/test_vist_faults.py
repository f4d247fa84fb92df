"""Degraded input: the engine continues, reports it, and recovers."""

from dataclasses import replace

import numpy as np
import pytest

from tracker.fusion.vist.engine import VistEngine
from tracker.fusion.vist.params import VistParams
from tracker.messages import ImuSample, Tracking
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

FROM, TO = 3.0, 4.5  # s of the fault


@pytest.fixture(scope="module")
def session(hand, glove):
    motion = RandomPostures(hand, seed=5, duration=7.0)
    simulation = Simulation(hand, glove, motion, seed=5, fps=30)
    return simulation, list(simulation.feed())


def silent_finger(m):
    if not isinstance(m, ImuSample):
        return m
    accel, gyro, valid = m.accel.copy(), m.gyro.copy(), m.valid.copy()
    accel[4], gyro[4], valid[4] = np.nan, np.nan, False
    return replace(m, accel=accel, gyro=gyro, valid=valid)


def stuck_finger(m):
    if not isinstance(m, ImuSample):
        return m
    accel, gyro = m.accel.copy(), m.gyro.copy()
    accel[4], gyro[4] = [0.0, 0.0, 9.0], [0.5, 0.0, 0.0]
    return replace(m, accel=accel, gyro=gyro)


def no_right_image(m):
    return m if isinstance(m, ImuSample) else replace(m, right=None)


def no_glove(m):
    return None if isinstance(m, ImuSample) else m


@pytest.mark.long
@pytest.mark.parametrize("fault", [silent_finger, stuck_finger, no_right_image, no_glove])
def test_faults_pass(session, hand, glove, fault):
    simulation, messages = session
    engine = VistEngine(hand, glove, simulation.rig, VistParams())
    during, after = [], []
    for m in messages:
        m = fault(m) if FROM < m.t < TO else m
        if m is None:
            continue
        if not isinstance(m, ImuSample):
            engine.feed_frame(m)
            continue
        e = engine.feed_imu(m)
        assert np.isfinite(e.segment_p).all() or e.tracking == Tracking.SEARCHING
        if FROM + 0.6 < m.t < TO:
            during.append(e)
        elif m.t > TO + 0.8:
            after.append(e)
    if fault is no_right_image:  # a stereo method measures nothing with one camera, and reports it
        assert all(e.tracking in (Tracking.COASTING, Tracking.LOST) for e in during)
    truth = np.array([x.keypoints for x in simulation.truths(np.array([e.t for e in after]))])
    error = np.linalg.norm(np.array([e.keypoints for e in after]) - truth, axis=2)[:, :21]
    assert all(e.tracking == Tracking.TRACKING for e in after)
    names = glove.keypoint_names(hand)
    tips = [names.index(k) for k in ("thumb_tip", "index_tip", "middle_tip")]
    assert error[:, tips].mean() < 0.020
