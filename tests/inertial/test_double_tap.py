"""A double tap on the glove is distinguished from movements, one tap and three."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.inertial.double_tap import DoubleTap
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

DT = 0.01
UP = np.array([0.3, 0.2, 9.8])


def found(taps: Sequence[float], size: float = 20.0, width: int = 2, begin: float = 0.0) -> int:
    """Double taps detected in 4 s of a hand at rest that is tapped at these times (s)."""
    rng, tap, count = np.random.default_rng(2), DoubleTap(), 0
    for k in range(400):
        t = k * DT + begin
        accel = UP + rng.normal(0, 0.3, 3)
        if any(0 <= round((t - begin - at) / DT) < width for at in taps):
            accel = accel + [0.0, 0.0, -size]
        count += tap.feed(t, accel, rng.normal(0, 0.05, 3))
    return count


@pytest.mark.parametrize("apart", [0.12, 0.2, 0.3, 0.45])
@pytest.mark.parametrize(("size", "width"), [(9.0, 1), (20.0, 2), (80.0, 3)])
def test_two_taps_count_once(apart: float, size: float, width: int) -> None:
    assert found([2.0, 2.0 + apart], size, width) == 1


@pytest.mark.parametrize(
    "taps", [[], [2.0], [2.0, 2.2, 2.4], [2.0, 2.8], [1.0, 1.7, 2.4], [2.0, 2.2, 2.35]]
)
def test_other_taps_do_not_count(taps: list[float]) -> None:
    assert found(taps) == 0


def test_a_long_push_and_small_jolts_do_not_count() -> None:
    assert found([2.0, 2.3], size=20.0, width=20) == 0
    assert found([2.0, 2.3], size=3.0) == 0


def test_two_double_taps_count_twice() -> None:
    assert found([1.0, 1.2, 2.5, 2.7]) == 2


def test_repeated_samples_are_ignored_and_a_gap_restarts() -> None:
    tap = DoubleTap()
    for k in range(100):
        assert not tap.feed(k * DT, UP, np.zeros(3))
        assert not tap.feed(k * DT, UP - [0.0, 0.0, 30.0], np.zeros(3)), "an instant counts once"
    assert not tap.feed(5.0, UP - [0.0, 0.0, 30.0], np.zeros(3)), "the first after a gap is no tap"


@pytest.mark.long
def test_a_moving_hand_does_not_tap(hand: HandModel, glove: GloveModel) -> None:
    """Two minutes of free motion."""
    count = 0
    for seed in (1, 2):
        sim = Simulation(hand, glove, RandomPostures(hand, seed, duration=60.0), seed)
        tap, row = DoubleTap(), glove.imu_names.index("dorsum")
        count += sum(tap.feed(s.t, s.accel[row], s.gyro[row]) for s in sim.imu_samples())
    assert count == 0


def test_taps_in_a_movement_do_not_count() -> None:
    tap = DoubleTap()
    for k in range(300):
        t = k * DT
        accel = UP - [0.0, 0.0, 20.0] if k in (200, 220) else UP
        assert not tap.feed(t, accel, np.array([0.0, 4.0 * np.sin(6 * t), 4.0 * np.cos(6 * t)]))
