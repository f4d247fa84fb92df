"""A running motor shakes the IMU of its finger most, and only while it runs."""

from __future__ import annotations

import numpy as np

from tracker import GRAVITY
from tracker.sensors.protocol import Haptic
from tracker.simulation.glove_device import ELSEWHERE, MotorVibration

N = 7


def rms(motors: MotorVibration, start: float) -> np.ndarray:
    """(N,) m/s² over 0.5 s."""
    found = [motors.at(start + k / 100) for k in range(50)]
    accel = [np.zeros((N, 3)) if f is None else f[0] for f in found]
    return np.sqrt(np.mean(np.sum(np.square(accel), axis=2), axis=0))


def test_the_motors_own_imu_is_shaken_most() -> None:
    motors = MotorVibration(N, np.random.default_rng(2))
    assert not rms(motors, 0.0).any()
    motors.run(Haptic(1, 255, 500), 1.0)
    shaken = rms(motors, 1.0)
    assert np.argmax(shaken) == 4 and 0.05 * GRAVITY < shaken[4] < 0.4 * GRAVITY
    motors.run(Haptic(1, 128, 500), 2.0)
    np.testing.assert_allclose(rms(motors, 2.0), shaken * 128 / 255, rtol=0.2)
    assert np.delete(shaken, 4).max() < 5 * ELSEWHERE * shaken[4]


def test_it_ends_with_the_command_or_by_amplitude_zero() -> None:
    motors = MotorVibration(N, np.random.default_rng(2))
    motors.run(Haptic(0, 255, 500), 1.0)
    assert motors.at(1.49) is not None and motors.at(1.51) is None
    motors.run(Haptic(0, 255, 500), 2.0)
    motors.run(Haptic(0, 0, 0), 2.1)
    assert motors.at(2.2) is None
