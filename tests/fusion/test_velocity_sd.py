"""Standard deviations of velocities, against the errors of simulated people's."""

from __future__ import annotations

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.ahead import acceleration_variance
from tracker.fusion.chain.layout import ChainLayout
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, ImuSample, Validity
from tracker.simulation.motion import SimulatedMotion, Swinging
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import default_pose

DURATION, SETTLED = 6.0, 2.5  # s
STEP = 2e-3  # s, half the interval over which true positions are differentiated


def squared_errors(sim: Simulation) -> Array:
    """(n, K) squared errors of the measured keypoints' velocities, mean of three axes, relative to
    their variances; NaN for others."""
    pipeline, rows = Pipeline(sim.hand, sim.glove, sim.rig), []
    for message in sim.feed():
        if not isinstance(message, ImuSample):
            pipeline.feed_frame(message)
            continue
        found = pipeline.feed_imu(message)
        if message.t < SETTLED or message.seq % 2:
            continue
        assert found.motion is not None
        before, after = sim.truths(np.array([found.t - STEP, found.t + STEP]))
        error = found.motion.linear - (after.keypoints - before.keypoints) / (2 * STEP)
        ratio = (error**2).mean(axis=1) / found.motion.linear_sd**2
        rows.append(np.where(found.keypoint_state == Validity.MEASURED, ratio, np.nan))
    return np.array(rows)


@pytest.mark.long
@pytest.mark.parametrize("speed", [0.0, 1.5])
def test_velocities_are_as_certain_as_they_are_accurate(
    hand: HandModel, glove: GloveModel, speed: float
) -> None:
    """A moving hand's velocity changes within seconds, so two people for 3.5 s determine
    the mean of a NEES of 1 to within a third, and the share within three standard deviations (97 %
    of normal errors) to a few percent: a move of 0.2 s is 5 %. The NEES by P alone is 0.09."""
    ratios = []
    for seed in (641, 642):
        motion: SimulatedMotion = RandomPostures(hand, seed, duration=DURATION)
        if speed:
            motion = Swinging(motion, speed, default_pose())
        ratios.append(squared_errors(Simulation(hand, glove, motion, seed, fps=30)))
    every = np.concatenate(ratios)
    measured = every[np.isfinite(every)]
    assert len(measured) > 5 * len(every)
    assert 0.5 < measured.mean() < 1.5
    assert np.mean(measured < 9.0 / 3.0) > 0.9


def test_errors_of_tilt_and_bias_that_cancel_do_not_accelerate_the_hand(
    hand: HandModel, glove: GloveModel
) -> None:
    """10,000 draws of correlated errors: their specific forces against the variance (to 3 %, three
    standard deviations of the mean over three axes)."""
    layout = ChainLayout(hand, glove)
    rng, at = np.random.default_rng(3), layout.blocks
    j = int(layout.imu_of[0])
    R_GB, R_IB = so3.exp(np.array([0.4, -0.7, 0.3])), so3.exp(np.array([0.1, 0.2, -0.3]))
    rows = [*range(at.theta, at.theta + 3)]
    rows += [*range(at.phi + 3 * j, at.phi + 3 * j + 3), *range(at.ba + 3 * j, at.ba + 3 * j + 3)]
    scale = np.repeat([0.01, 0.01, 0.1], 3)
    root = rng.normal(size=(9, 9)) * scale[:, None]
    P = np.zeros((at.size, at.size))
    P[np.ix_(rows, rows)] = root @ root.T
    draws = rng.normal(size=(10_000, 9)) @ root.T
    f = R_GB.T @ np.array([0.0, 0.0, GRAVITY])
    reading = R_IB @ f
    theta, phi, ba = draws[:, :3], draws[:, 3:6], draws[:, 6:]
    R_true, mounting = R_GB @ so3.exp(theta), R_IB @ so3.exp(phi)
    force = np.einsum("nij,nkj,nk->ni", R_true, mounting, reading - ba)
    spread = ((force - R_GB @ f) ** 2).mean()
    assert acceleration_variance(P, at, j, R_GB, R_IB) == pytest.approx(spread, rel=0.03)
    # a tilt that the bias explains: the reading, and so the acceleration, is right
    J = np.vstack([np.eye(3), np.zeros((3, 3)), -(R_IB @ so3.skew(f))])
    P[np.ix_(rows, rows)] = J @ J.T * 0.02**2
    cancelled = acceleration_variance(P, at, j, R_GB, R_IB)
    P[np.ix_(rows[:3], rows[6:])] = 0.0
    P[np.ix_(rows[6:], rows[:3])] = 0.0
    assert cancelled < 1e-6 * acceleration_variance(P, at, j, R_GB, R_IB)
