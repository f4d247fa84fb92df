"""Velocities of an estimate against those of the simulated hand, for each engine."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, Estimate, ImuSample, Motion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

SETTLED, DURATION = 2.0, 4.5  # s; the wearer moves from the start
STEP = 1e-3  # s: true values are differentiated over twice this step


@pytest.fixture(scope="module")
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, 3, duration=DURATION), 3, fps=30)


def tracked(sim: Simulation, engine: str) -> list[Estimate]:
    pipeline, out = Pipeline(sim.hand, sim.glove, sim.rig, Settings(engine=engine)), []
    for message in sim.feed():
        if isinstance(message, ImuSample):
            out.append(pipeline.feed_imu(message))
        else:
            pipeline.feed_frame(message)
    return [e for e in out if e.t > SETTLED]


def true_motion(sim: Simulation, t: Array) -> tuple[Array, Array, Array]:
    """Linear (n, K, 3), angular (n, K, 3) and of the angles (n, J), by central differences."""
    ends = zip(sim.truths(t - STEP), sim.truths(t + STEP), strict=True)
    segments = sim.glove.keypoint_segments(sim.hand)
    rows = []
    for a, b in ends:
        turned = so3.log(b.R_GB @ a.R_GB.swapaxes(1, 2))[segments]
        rows.append((b.keypoints - a.keypoints, turned, b.angles - a.angles))
    linear, angular, rate = (np.array(x) / (2 * STEP) for x in zip(*rows, strict=True))
    return linear, angular, rate


def rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


@pytest.mark.long
@pytest.mark.parametrize(
    ("engine", "linear_most", "angular_most"),
    [("chain", 0.012, 0.06), ("vist", 0.02, 0.08), ("switching", 0.05, 0.3), ("inertial", 0, 0.1)],
)
def test_velocities_match_the_hand_within_their_standard_deviations(
    sim: Simulation, engine: str, linear_most: float, angular_most: float
) -> None:
    """The hand moves at 0.1 m/s and its fingers rotate at 1 rad/s (RMS)."""
    estimates = tracked(sim, engine)
    motions = [e.motion for e in estimates if e.motion is not None]
    assert len(motions) == len(estimates) > 100
    linear, angular, rate = true_motion(sim, np.array([e.t for e in estimates]))
    names, joints = sim.glove.keypoint_names(sim.hand), sim.hand.joint_names

    def column(field: str, row: int) -> Array:
        return np.array([getattr(m, field)[row] for m in motions])

    for name in ("wrist", "index_mcp", "middle_pip"):  # with IMUs
        k = names.index(name)
        error = rms(column("angular", k) - angular[:, k])
        assert error < min(angular_most, 0.3 * rms(angular[:, k]))
        assert error < 3 * rms(column("angular_sd", k))
    for name in ("wrist", "index_tip", "ring_tip"):
        k = names.index(name)
        if engine == "inertial":  # without a position, no velocity
            assert np.isnan(column("linear", k)).all() and np.isnan(column("linear_sd", k)).all()
        else:
            error = rms(column("linear", k) - linear[:, k])
            assert error < (3 if name == "ring_tip" else 1) * linear_most
            assert error < 2 * rms(column("linear_sd", k))
    for name in ("index_mcp_flexion", "middle_pip_flexion", "ring_pip_flexion"):
        j = joints.index(name)
        error = rms(column("angle_rate", j) - rate[:, j])
        assert error < (0.3 if name.startswith("ring") else 0.2 * rms(rate[:, j]) + 0.05)
        assert error < 3 * rms(column("angle_rate_sd", j))
        true = np.array([t.angles[j] for t in sim.truths(np.array([e.t for e in estimates]))])
        error = rms(np.array([e.angles[j] for e in estimates]) - true)
        assert error < 4 * rms(column("angle_sd", j))


@pytest.mark.long
def test_unsensed_parts_are_less_certain(sim: Simulation) -> None:
    motion = tracked(sim, "chain")[-1].motion
    assert isinstance(motion, Motion)
    names = sim.glove.keypoint_names(sim.hand)
    sd = dict(zip(names, motion.angular_sd, strict=True))
    assert sd["little_tip"] > sd["little_mcp"] > 0.7 > 0.2 > sd["index_pip"]
    linear = dict(zip(names, motion.linear_sd, strict=True))
    assert linear["little_tip"] > linear["little_mcp"] > 0


@pytest.mark.long
def test_a_finger_with_an_invalid_imu_moves_with_its_parent(sim: Simulation) -> None:
    """The middle finger's first IMU fails: it rotates with the dorsum, with a large sd."""
    pipeline, j = (
        Pipeline(sim.hand, sim.glove, sim.rig),
        sim.glove.imu_names.index("middle_proximal"),
    )
    k = sim.glove.keypoint_names(sim.hand).index("middle_mcp")
    sds = []
    for message in sim.feed():
        if isinstance(message, ImuSample):
            valid = np.array(message.valid)
            valid[j] &= message.t < SETTLED
            cut = ImuSample(
                message.t, message.t_arrival, message.t_device, message.seq,
                message.accel, message.gyro, valid,
            )  # fmt: skip
            motion = pipeline.feed_imu(cut).motion
            if message.t > SETTLED - 0.1 and motion is not None:
                sds.append(float(motion.angular_sd[k]))
        else:
            pipeline.feed_frame(message)
    assert sds[0] < 0.2 and min(sds[15:]) > 0.7


def test_a_searching_hand_and_a_prediction_have_no_motion(sim: Simulation) -> None:
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig)
    first = next(m for m in sim.feed() if isinstance(m, ImuSample))
    assert pipeline.feed_imu(first).motion is None
    assert pipeline.predict(first.t).motion is None
