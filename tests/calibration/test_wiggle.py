"""The glove set-up on simulated wearers with known mounting, biases and errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from app.wizards.glove.feed import InstructedWearer, Wiggle, wiggling_wearer
from tracker.base.notices import warning
from tracker.calibration.still import StillParams, still_pose
from tracker.calibration.wiggle import WiggleTest, imu_motion, moving, wiggle_steps
from tracker.geometry import so3
from tracker.simulation.imu import ROOM_C, ImuSimulator
from tracker.simulation.motion import SimulatedMotion

DEGREE = np.pi / 180
SECONDS = 4.0


def samples(hand, glove, part: str, seed: int = 3, seconds: float = SECONDS):
    motion: SimulatedMotion = Wiggle(hand, part)
    simulator = ImuSimulator(wiggling_wearer(hand, glove, part, seed), motion, seed)
    return list(simulator.samples(0.0, seconds)), simulator


def with_imus(packets, change):
    """Packets whose accel and gyro (n, 3) are ``change``d together with valid."""
    return [
        replace(s, accel=change(s.accel), gyro=change(s.gyro), valid=s.valid.copy())
        for s in packets
    ]


def run(hand, glove, change=lambda rows: rows.copy(), seed: int = 3):
    test = WiggleTest(hand, glove)
    for k, step in enumerate(test.steps):
        packets, _ = samples(hand, glove, step.part, seed)
        assert test.add(k, with_imus(packets, change)) is None
    return test.result()


def swapped(i: int, j: int):
    def change(rows: np.ndarray) -> np.ndarray:
        out = rows.copy()
        out[[i, j]] = rows[[j, i]]
        return out

    return change


def turned(i: int, R: np.ndarray):
    def change(rows: np.ndarray) -> np.ndarray:
        out = rows.copy()
        out[i] = R @ rows[i]
        return out

    return change


def silent(packets, i: int):
    out = []
    for s in packets:
        valid, accel, gyro = s.valid.copy(), s.accel.copy(), s.gyro.copy()
        valid[i], accel[i], gyro[i] = False, np.nan, np.nan
        out.append(replace(s, valid=valid, accel=accel, gyro=gyro))
    return out


# --- the wiggle test


def test_steps_are_the_fingers_with_imus_and_the_hand(hand, glove):
    steps = wiggle_steps(hand, glove)
    assert [s.part for s in steps] == ["thumb", "index", "middle", "hand"]
    names = [[glove.imu_names[i] for i in s.imus] for s in steps]
    assert names[1] == ["index_proximal", "index_intermediate"]
    assert names[3] == ["dorsum"]


@pytest.mark.parametrize("seed", [1, 2, 3, 4, 5, 6])
def test_a_glove_that_matches_its_file_is_right(hand, glove, seed):
    result = run(hand, glove, seed=seed)
    assert result.ok, result
    assert result.summary.code == "wiggle.all_right"


def test_a_moving_imu_is_reported_immediately(hand, glove):
    packets, _ = samples(hand, glove, "index", seconds=1.0)
    names = [glove.imu_names[i] for i in moving(imu_motion(packets))]
    assert names[0] == "index_intermediate" and "middle_proximal" not in names
    rest, _ = samples(hand, glove, "rest", seconds=1.0)
    assert moving(imu_motion(rest)) == []


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("index_proximal", "middle_proximal"),
        ("index_proximal", "index_intermediate"),
        ("thumb_proximal", "middle_intermediate"),
        ("dorsum", "index_intermediate"),
    ],
)
def test_two_exchanged_imus_are_named(hand, glove, first, second):
    i, j = glove.imu_names.index(first), glove.imu_names.index(second)
    result = run(hand, glove, swapped(i, j))
    assert {r.name for r in result.rows if r.state == "elsewhere"} == {first, second}
    assert {r.name: r.segment for r in result.rows}[first] == second
    assert result.summary.code == "wiggle.exchanged"


def test_an_imu_mounted_across_is_reported(hand, glove):
    i = glove.imu_names.index("middle_proximal")
    result = run(hand, glove, turned(i, so3.rz(np.pi / 2)))
    assert [r.state for r in result.rows].count("turned") == 1
    assert result.rows[i].state == "turned"
    assert result.rows[i].what.code == "wiggle.turned"


def test_a_disconnected_and_a_loose_imu_are_distinguished(hand, glove):
    i, j = glove.imu_names.index("index_proximal"), glove.imu_names.index("thumb_proximal")
    test = WiggleTest(hand, glove)
    rest, _ = samples(hand, glove, "rest")
    for k, step in enumerate(test.steps):
        packets, _ = samples(hand, glove, step.part)
        loose = []
        for s, r in zip(silent(packets, i), rest, strict=True):
            gyro = s.gyro.copy()
            gyro[j] = r.gyro[j]
            loose.append(replace(s, gyro=gyro))
        assert test.add(k, loose) is None
    states = {r.name: r.state for r in test.result().rows}
    assert states["index_proximal"] == "silent" and states["thumb_proximal"] == "still"
    assert states["dorsum"] == "right"


def test_a_step_without_motion_is_requested_again(hand, glove):
    test = WiggleTest(hand, glove)
    rest, _ = samples(hand, glove, "rest")
    again = test.add(1, rest)
    assert again is not None and again.code == "wiggle.nothing_moved"
    assert not test.result().ok


# --- the still pose


def _bias_at_rest(simulator, i):
    """rad/s (3,), with the effects of temperature and of gravity."""
    errors = simulator.errors
    force = np.array([s.accel[i] for s in simulator.samples(0.0, 0.1)]).mean(axis=0)
    warmer = simulator.temperature(np.zeros(1))[0, i] - ROOM_C
    return errors.gyro_bias[i] + warmer * errors.gyro_slope[i] + errors.g_sensitivity[i] @ force


@pytest.mark.parametrize("seed", [1, 5])
def test_biases_and_noise_at_rest_are_the_simulated_ones(hand, glove, seed):
    packets, simulator = samples(hand, glove, "rest", seed, StillParams().duration)
    pose = still_pose(packets, glove.imu_names)
    assert pose.ok, pose.problem
    noise = np.deg2rad(simulator.params.gyro_noise_deg)
    for i, imu in enumerate(pose.imus):
        # the random walk of the bias, 0.05 °/s, is included
        assert imu.gyro_bias == pytest.approx(_bias_at_rest(simulator, i), abs=0.2 * DEGREE)
        assert imu.gyro_bias_sd < 0.05 * DEGREE
        assert imu.gyro_noise == pytest.approx(noise, rel=0.5)
        assert np.linalg.norm(imu.accel) == pytest.approx(9.81, abs=0.6)


def test_a_moving_finger_is_rejected_and_named(hand, glove):
    rest, _ = samples(hand, glove, "rest", seconds=2.0)
    bending, _ = samples(hand, glove, "index", seconds=2.0)
    i = glove.imu_names.index("index_intermediate")
    packets = []
    for still, moved in zip(rest, bending, strict=True):
        gyro = still.gyro.copy()
        gyro[i] = moved.gyro[i]
        packets.append(replace(still, gyro=gyro))
    pose = still_pose(packets, glove.imu_names)
    assert pose.problem == warning("still.moved", moving=["index_intermediate"])


def test_too_short_a_rest_and_a_disconnected_imu_are_reported(hand, glove):
    packets, _ = samples(hand, glove, "rest", seconds=2.0)
    short = still_pose(packets[:100], glove.imu_names).problem
    assert short is not None and (short.code, short.values["needed_s"]) == ("still.too_short", 2.0)
    nothing = still_pose([], glove.imu_names).problem
    assert nothing is not None and nothing.code == "still.too_short"
    one = warning("still.imu", imu="thumb_metacarpal", what=warning("still.imu_silent"))
    assert still_pose(silent(packets, 1), glove.imu_names).problem == warning(
        "still.imus", imus=[one]
    )


def test_an_accelerometer_with_a_large_error_is_reported(hand, glove):
    packets, _ = samples(hand, glove, "rest", seconds=2.0)
    off = [replace(s, accel=1.15 * s.accel) for s in packets]
    found = {i.problem.code for i in still_pose(off, glove.imu_names).imus if i.problem}
    assert found == {"still.imu_gravity"}


def test_the_instructed_wearer_follows_the_instructions(hand, glove):
    wearer = InstructedWearer(hand, glove)
    stream = wearer.samples()
    first = [next(stream) for _ in range(200)]
    wearer.part = "middle"
    second = [next(stream) for _ in range(200)]
    assert moving(imu_motion(first)) == []
    assert glove.imu_names[moving(imu_motion(second))[0]] == "middle_intermediate"
    assert [s.seq for s in first + second] == list(range(400))
