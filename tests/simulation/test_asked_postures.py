"""A simulated wearer assumes requested postures as smoothly as the own motion."""

import numpy as np
import pytest

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Event
from tracker.simulation.posture_requests import (
    MOVE,
    SWAY_DEG,
    PostureRequest,
    RequestedMotion,
    request_event,
    request_in,
)
from tracker.simulation.postures import posture
from tracker.simulation.random_postures import RandomPostures

FIST = {f"{f}_{j}_flexion": 80.0 for f in ("index", "middle", "ring", "little") for j in ("mcp",)}
SEEDS = (1, 2, 3)


def motion(hand: HandModel, seed: int) -> RequestedMotion:
    return RequestedMotion(RandomPostures(hand, seed, duration=20.0), seed)


def asked(hand: HandModel, t: float) -> PostureRequest:
    return PostureRequest(t, tuple(posture(hand, FIST).tolist()))


def test_before_a_request_the_motion_is_unchanged_bit_for_bit(hand):
    t = np.linspace(0.0, 10.0, 300)
    own, led = RandomPostures(hand, 1, duration=20.0), motion(hand, 1)
    led.ask(asked(hand, 10.0))
    for a, b in zip(own.poses(t), led.poses(t), strict=True):
        np.testing.assert_array_equal(a, b)


def test_the_posture_is_reached_and_left_again(hand):
    led = motion(hand, 2)
    led.ask(asked(hand, 5.0))
    led.ask(PostureRequest(9.0))
    held = led.poses(np.linspace(5.0 + MOVE, 9.0, 50)).angles
    off = np.rad2deg(held - posture(hand, FIST))
    assert np.abs(off).max() < 5 * SWAY_DEG
    t = np.linspace(9.0 + MOVE, 12.0, 50)
    own = RandomPostures(hand, 2, duration=20.0)
    np.testing.assert_array_equal(led.poses(t).R_GB, own.poses(t).R_GB)


@pytest.mark.parametrize("seed", SEEDS)
def test_transitions_are_smooth(hand, seed):
    """No faster than the wearer's own motion, except for a rotation by 180° within `MOVE`: a
    minimum jerk has 1.9 times the mean rate, a blend of quaternions 1.6 times that; 20 rad/s in
    total."""
    led = motion(hand, seed)
    for k in range(5):
        led.ask(asked(hand, 2.0 + 3.0 * k))
        led.ask(PostureRequest(3.3 + 3.0 * k))
    step = 0.002
    t = np.arange(1.0, 17.0, step)
    poses = led.poses(t)
    turn = np.linalg.norm(poses.R_GB[1:] - poses.R_GB[:-1], axis=(1, 2)) / np.sqrt(2) / step
    assert turn.max() < 20.0
    assert np.abs(np.diff(poses.angles, axis=0)).max() / step < 20.0
    speed = np.diff(poses.p_GB, axis=0) / step
    assert np.linalg.norm(np.diff(speed, axis=0), axis=1).max() / step < 30.0  # m/s²


def test_the_motion_is_independent_of_the_order_of_evaluation(hand):
    """Packets are generated one second at a time, images one by one."""
    led = motion(hand, 3)
    led.ask(asked(hand, 4.0))
    led.ask(PostureRequest(6.0))
    t = np.linspace(3.9, 7.0, 40)
    together = led.poses(t)
    for k in range(len(t)):
        for a, b in zip(together, led.poses(t[k : k + 1]), strict=True):
            np.testing.assert_allclose(a[k], b[0], atol=1e-12)


def test_a_request_is_recorded_as_an_event(hand, glove: GloveModel):
    there = asked(hand, 4.25)
    assert request_in(request_event(there, "fist", 3.0)) == there
    assert request_in(Event(3.0, "device", "The camera is there.")) is None
