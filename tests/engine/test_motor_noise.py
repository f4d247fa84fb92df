"""Running motors raise the noise of the IMUs by what was measured of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.calibration.motor_vibration import Vibration, vibration_of
from tracker.engine.pipeline import Pipeline
from tracker.glove.model import GloveModel, ImuVibration
from tracker.hand.model import HandModel
from tracker.messages import ImuSample, Tracking
from tracker.sensors.motor_events import motor_event, motor_of
from tracker.sensors.protocol import Haptic
from tracker.simulation.glove_device import ACCEL, GYRO, MotorVibration
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

MOTORS, SEED = 3, 4
STRONG = 8.0
"""Times the size of the simulated motors, for one that is sewn to the IMU's board."""


def motors_of(glove: GloveModel) -> MotorVibration:
    return MotorVibration(len(glove.imus), np.random.default_rng([SEED, 1]))


def shaken(sample: ImuSample, motors: MotorVibration, size: float = 1.0) -> ImuSample:
    added = motors.at(sample.t)
    if added is None:
        return sample
    return replace(sample, accel=sample.accel + size * added[0], gyro=sample.gyro + size * added[1])


def measured(sim: Simulation, size: float = 1.0) -> list[Vibration]:
    """Of each motor at full amplitude, in a hand at rest."""
    rng = np.random.default_rng(SEED)
    packets = [
        replace(s, accel=rng.normal(0, 0.02, (7, 3)), gyro=rng.normal(0, 0.001, (7, 3)))
        for s in sim.imus.samples(0.0, 2.0)
    ]
    found = []
    for channel in range(MOTORS):
        motors = motors_of(sim.glove)
        motors.run(Haptic(channel, 255, 1000), 1.0)
        run = [shaken(s, motors, size) for s in packets if s.t > 1.0]
        one = vibration_of([s for s in packets if s.t <= 1.0], run)
        assert one is not None
        found.append(one)
    return found


def with_vibration(glove: GloveModel, found: list[Vibration]) -> GloveModel:
    gyro, accel = (np.array([v.densities[k] for v in found]) for k in (0, 1))
    imus = enumerate(glove.imus)
    return replace(
        glove,
        imus=tuple(replace(i, vibration=ImuVibration(gyro[:, j], accel[:, j])) for j, i in imus),
    )


@pytest.fixture(scope="module")
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, SEED, duration=4.0), SEED, fps=30.0)


def test_the_motor_test_finds_the_imu_of_the_motors_finger(sim: Simulation) -> None:
    """A sine of a random direction and size: its largest axis has 0.2 to 1.2 times the amplitude
    as a standard deviation."""
    for channel, found in enumerate(measured(sim)[:2]):
        assert int(np.argmax(found.accel)) == 2 + 2 * channel
        assert 0.2 * ACCEL < found.accel.max() < 1.2 * ACCEL
        assert 0.1 * GYRO < found.gyro.max() < 1.5 * GYRO


def deviation(sim: Simulation, glove: GloveModel) -> float:
    """Root mean square of the keypoints' errors in standard deviations while all motors run."""
    pipeline, motors, due, z = Pipeline(sim.hand, glove, sim.rig), motors_of(glove), 1.0, []
    for message in sim.feed():
        if message.t >= due:
            due += 1.0
            for channel in range(MOTORS):
                motors.run(Haptic(channel, 255, 1000), message.t)
                pipeline.feed_event(motor_event(channel, 255, 1000, message.t_arrival))
        if not isinstance(message, ImuSample):
            pipeline.feed_frame(message)
            pipeline.take_results()
            continue
        estimate = pipeline.feed_imu(shaken(message, motors, STRONG))
        if message.t > 1.5 and message.seq % 10 == 0 and estimate.tracking == Tracking.TRACKING:
            error = estimate.keypoints - sim.truth(message.t).keypoints
            z.append(np.linalg.norm(error, axis=1) / estimate.keypoint_sd)
    assert len(z) > 15
    return float(np.sqrt(np.mean(np.square(z))))


def test_the_standard_deviation_is_true_only_with_the_raised_noise(sim: Simulation) -> None:
    """A true deviation per axis has a root mean square of √3 in space."""
    plain = deviation(sim, sim.glove)
    raised = deviation(sim, with_vibration(sim.glove, measured(sim, STRONG)))
    assert raised < np.sqrt(3) < plain


def test_the_noise_follows_the_commands_and_is_part_of_the_state(sim: Simulation) -> None:
    glove = with_vibration(sim.glove, measured(sim))
    pipeline, other = (Pipeline(sim.hand, glove, sim.rig) for _ in range(2))
    run = motor_of(motor_event(1, 128, 500, 1.0))
    assert run is not None and (run.channel, run.duration) == (1, 0.5)
    pipeline.feed_event(motor_event(1, 128, 500, 1.0))
    full = max(i.vibration.gyro[1] for i in glove.imus if i.vibration is not None)
    assert pipeline._motors.at(1.2)[0] == pytest.approx(full * 128 / 255)
    other.set_state(pipeline.get_state())
    assert other._motors.at(1.2) == pipeline._motors.at(1.2)
    assert other._motors.at(2.0) == (0.0, 0.0)
    pipeline.feed_event(motor_event(1, 0, 0, 1.1))  # it is switched off
    assert pipeline._motors.at(1.3) == (0.0, 0.0)
