"""Forces on the robot's fingertips, felt by the wearer's."""

from __future__ import annotations

import numpy as np

from extensions.robot.window.job import AGAIN, LASTS_MS, LEAST, MOST, TouchMotors, amplitude


def commands_for(forces: list[np.ndarray], dt: float = 0.01) -> list[tuple[int, int, int]]:
    out: list[tuple[int, int, int]] = []
    motors = TouchMotors(lambda *command: out.append(command))
    for k, force in enumerate(forces):
        motors.feel(k * dt, force)
    return out


def on(finger: int, newton: float) -> np.ndarray:
    return np.where(np.arange(5) == finger, newton, 0.0)


def test_the_motor_of_the_finger_that_touches_runs_at_once_and_no_other() -> None:
    commands = commands_for([np.zeros(5), on(2, 1.0)])
    assert commands == [(2, amplitude(1.0), LASTS_MS)]


def test_a_pressing_finger_is_sent_about_twenty_times_a_second_without_a_pause() -> None:
    commands = commands_for([on(1, 2.0)] * 101)  # a second
    assert 0.85 / AGAIN < len(commands) <= 1 / AGAIN + 1  # hands come every 10 ms
    assert LASTS_MS / 1e3 > AGAIN


def test_a_growing_force_is_sent_at_once() -> None:
    commands = commands_for([on(0, 0.5), on(0, 4.0)])
    assert len(commands) == 2
    assert commands[1][1] > commands[0][1]


def test_amplitudes_grow_with_the_force_and_stay_in_the_motors_range() -> None:
    values = [amplitude(f) for f in np.linspace(0, 50, 100)]
    assert values == sorted(values)
    assert values[0] == LEAST and values[-1] == MOST == 255
