"""Fingertips reach their targets, within limits of joints and speeds."""

from __future__ import annotations

import numpy as np
import pytest

from extensions.robot.retarget import Retargeter, bounded_step
from extensions.robot.teleop import TOUCH, TargetMap, target_map
from extensions.robot.tests.hands import shadow, wearer, wearer_model
from tracker.simulation.gestures import pinch

ALL = np.ones(5, bool)
DT = 0.01


def reachable_way(seconds: float) -> np.ndarray:
    """(n, 22) rad: joints that oscillate within limits and couplings."""
    hand = shadow()
    t = np.arange(0, seconds, DT)[:, None]
    phase = np.random.default_rng(0).uniform(0, 6.28, len(hand.joint_names))
    low, high = hand.limits.T
    q = (low + high) / 2 + 0.45 * (high - low) * np.sin(1.5 * t + phase)
    for row in hand.anatomy.couplings:
        i, j = np.flatnonzero(row)
        q[:, i] = np.minimum(-row[j] / row[i] * q[:, j], high[i])
        q[:, j] = -row[i] / row[j] * q[:, i]
    return q


def test_tips_are_within_5_mm_of_targets_that_can_be_reached() -> None:
    fingers = Retargeter(shadow(), joint_speed=20.0)
    errors = []
    for q in reachable_way(6.0):
        wanted = fingers.tips(q)
        got = fingers.tips(fingers.step(wanted, ALL, DT))
        errors.append(np.linalg.norm(got - wanted, axis=1).max())
    settled = np.array(errors[50:])  # it begins at rest, elsewhere
    assert np.median(settled) < 0.0005
    assert np.percentile(settled, 99) < 0.005


def test_joints_keep_their_limits_and_speed_for_any_target() -> None:
    hand, speed = shadow(), 4.0
    fingers = Retargeter(hand, speed)
    rng = np.random.default_rng(5)
    before = fingers.angles
    for _ in range(60):
        after = fingers.step(rng.normal(0, 0.2, (5, 3)), ALL, DT)
        assert np.abs(after - before).max() <= speed * DT + 1e-12
        assert (after >= hand.limits[:, 0] - 1e-12).all()
        assert (after <= hand.limits[:, 1] + 1e-12).all()
        before = after


def test_a_finger_without_a_target_stays_while_others_move() -> None:
    fingers = Retargeter(shadow(), 8.0)
    q = reachable_way(0.5)[-1]
    wanted = fingers.tips(q)
    for _ in range(40):
        before = fingers.step(wanted, ALL, DT)
    known = np.array([True, False, True, True, True])
    for _ in range(20):
        after = fingers.step(wanted + [0.0, 0.0, 0.01], known, DT)
    index = list(shadow().anatomy.fingers[1].joints)
    assert (after[index] == before[index]).all()
    assert np.abs(np.delete(after - before, index)).max() > 0.02


def test_a_bounded_step_is_no_worse_than_any_other_within_its_bounds() -> None:
    rng = np.random.default_rng(2)
    for _ in range(20):
        A = rng.normal(size=(6, 6))
        H, g = A @ A.T + np.eye(6), rng.normal(0, 3, 6)
        low, high = -rng.uniform(0, 1, 6), rng.uniform(0, 1, 6)
        x = bounded_step(H, g, low, high)
        assert (x >= low).all() and (x <= high).all()
        free = (x > low) & (x < high)
        assert (H @ x - g)[free] == pytest.approx(0.0, abs=1e-9)  # no better way inside


def test_the_wearers_straight_hand_is_the_robots_straight_hand() -> None:
    targets, known = target_map(shadow(), 1.0).targets(wearer())
    assert known.all()
    for finger, target in list(zip(shadow().anatomy.fingers, targets, strict=True))[1:]:
        reach = target - finger.knuckle
        assert np.linalg.norm(reach) == pytest.approx(finger.length, abs=1e-3)
        assert reach[0] > 0.95 * finger.length


def test_a_pinch_of_the_wearer_is_a_pinch_of_the_robot() -> None:
    """The gap between the robot's tips is that of two touching pads, not a scaled gap."""
    hand = wearer_model()
    for finger, row in (("index", 1), ("middle", 2)):
        shown = wearer(pinch(hand, finger))
        apart = np.linalg.norm(shown.tip[row] - shown.tip[0])
        assert apart < TOUCH + 0.002
        fingers = Retargeter(shadow(), 100.0)
        targets, known = target_map(shadow(), 1.0).targets(shown)
        for _ in range(40):
            q = fingers.step(targets, known, DT)
        tips = fingers.tips(q)
        touching = sum(shadow().anatomy.fingers[k].radius for k in (0, row))
        assert np.linalg.norm(tips[row] - tips[0]) < touching + 0.004


def test_a_longer_robot_finger_reaches_as_much_further() -> None:
    shown = wearer()
    knuckle, length, radius = np.zeros((5, 3)), np.full(5, 0.2), np.full(5, 0.01)
    tips, _ = TargetMap(knuckle, length, radius, scale=0.5).targets(shown)
    expected = 0.5 * 0.2 * (shown.tip - shown.knuckle)[4] / shown.length[4]
    assert tips[4] == pytest.approx(expected)  # far from the thumb: no pinch
