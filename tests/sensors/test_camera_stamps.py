"""Times of images by the driver's stamps, where arrivals are irregular."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.sensors.test_camera_controls import Driver, Input
from tracker.sensors.camera import CameraParams, StereoCamera
from tracker.sensors.camera_controls import ControlledInput
from tracker.sensors.camera_stamps import MEMORY, HasStamps, SteadyArrivals

PERIOD, DELAY = 1 / 30, 0.035


def jittered(seed: int, n: int = 600) -> tuple[np.ndarray, np.ndarray]:
    """True instants (n,) s and arrivals: a delay, waiting of 4 ms on average, and now and then of
    60 ms."""
    rng = np.random.default_rng(seed)
    true = 100.0 + PERIOD * np.arange(n)
    waiting = rng.exponential(0.004, n) + 0.06 * (rng.random(n) < 0.02)
    return true, np.maximum.accumulate(true + DELAY + waiting) + 1e-6 * np.arange(n)


@pytest.mark.parametrize("rate", [1.0, 1.0001])
def test_stamps_of_another_clock_remove_the_jitter(rate: float) -> None:
    """Against waiting of 4 ms: the smallest of 150 exponential delays is 0.03 ms, and 100 ppm drift
    by 0.5 ms in the memory."""
    true, arrivals = jittered(1)
    stamps = rate * (true - 60.0)
    clock = SteadyArrivals()
    found = np.array([clock.arrival(a, s) for a, s in zip(arrivals, stamps, strict=True)])
    assert np.all(np.diff(found) > 0) and np.all(found <= arrivals) and clock.is_stamped
    late = found[150:] - true[150:] - DELAY
    assert np.std(arrivals - true) > 0.004
    assert np.abs(late).max() < 0.001 + 1.1 * abs(rate - 1) * MEMORY and np.std(late) < 0.0005


@pytest.mark.parametrize("stamp", [0.0, -1.0, math.nan])
def test_without_stamps_arrivals_count(stamp: float) -> None:
    _, arrivals = jittered(2, 50)
    clock = SteadyArrivals()
    assert [clock.arrival(a, stamp) for a in arrivals] == arrivals.tolist()
    assert not clock.is_stamped


def test_stamps_that_jump_begin_again() -> None:
    """A driver whose clock is set, or that was restarted: never an image before its time."""
    true, arrivals = jittered(3, 200)
    stamps = true - 60.0
    stamps[100:] += 1000.0
    clock = SteadyArrivals()
    found = np.array([clock.arrival(a, s) for a, s in zip(arrivals, stamps, strict=True)])
    off = found - true - DELAY
    assert np.all(np.diff(found) > 0) and off.min() > -1e-4 and off.max() < 0.08
    assert abs(off[99]) < 0.001 and abs(off[-1]) < 0.001


@pytest.mark.parametrize("fps", [15.0, 24.5, 30.0])
def test_counted_stamps_are_not_used(fps: float) -> None:
    """FFmpeg stamps images without time stamps every 40 ms: of a camera of another rate, and of one
    whose images are lost."""
    rng = np.random.default_rng(5)
    true = 100.0 + np.cumsum(1 / fps * (1 + (rng.random(900) < 0.05)))
    arrivals = true + DELAY + rng.exponential(0.004, 900)
    clock = SteadyArrivals()
    found = [clock.arrival(a, 0.04 * (k + 1)) for k, a in enumerate(arrivals)]
    assert not clock.is_stamped and found == arrivals.tolist()


def test_equal_steps_of_a_true_clock_are_used() -> None:
    """A camera that stamps with its own clock at its own rate, behind a network that sometimes
    delays a second of images."""
    true, arrivals = jittered(6)
    waiting = 0.1 * ((np.arange(600) // 30) % 5 == 4)
    clock = SteadyArrivals()
    stamps = np.round(true - 60.0, 9)
    found = np.array([clock.arrival(a, s) for a, s in zip(arrivals + waiting, stamps, strict=True)])
    assert clock.is_stamped and np.abs(found[150:] - true[150:] - DELAY).max() < 0.002


def test_a_camera_uses_the_stamps_of_its_driver() -> None:
    true, arrivals = jittered(4, 200)

    class Stamped(Input):
        k = 0

        def read(self):
            self.k += 1
            rng = np.random.default_rng(self.k)  # not the image before again
            left, right = rng.integers(0, 255, (2, 8, 8, 3), np.uint8)
            return left, right

        def stamp(self) -> float:
            return true[self.k - 1] - 60.0

    inner = Stamped(Driver())
    source = ControlledInput(inner)
    assert isinstance(source, HasStamps)

    def now() -> float:
        return float(arrivals[max(inner.k - 1, 0)])

    camera = StereoCamera(source, None, CameraParams(delay=DELAY), now)
    frames = [camera.read(0.0) for _ in range(200)]
    t = np.array([f.t for f in frames if f is not None])
    assert len(t) == 200 and np.std(t[100:] - true[100:]) < 0.0005
    assert all(f.t_arrival == a for f, a in zip(frames, arrivals, strict=True))
