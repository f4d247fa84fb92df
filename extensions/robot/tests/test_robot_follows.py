"""The robot follows, holds where the hand is lost, and repeats exactly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from extensions.robot.command import RobotCommand
from extensions.robot.driver import RobotDriver
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop
from extensions.robot.tests.hands import shadow, wearer, wearer_model
from extensions.robot.wearer_hand import WearerHand
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.geometry import so3
from tracker.messages import Estimate, Event, RobotState, Tracking
from tracker.simulation.gestures import FIST
from tracker.simulation.postures import posture

SETTINGS = RobotSettings(objects="cube")


def robot(settings: RobotSettings = SETTINGS) -> Teleop:
    return Teleop(settings, shadow())


def closing(n: int, lost_from: int | None = None) -> list[WearerHand]:
    """A hand that makes a fist within a second and moves sideways; lost from some instant on."""
    hand = wearer_model()
    fist = posture(hand, FIST)
    shown = []
    for k in range(n):
        one = wearer(min(k / 100, 1.0) * fist, (0.001 * k, 0.0, 0.3), t=10.0 + k * 0.01)
        if lost_from is not None and k >= lost_from:
            one = replace(one, located=False, known=np.zeros(5, bool), tip=one.tip * np.nan)
        shown.append(one)
    return shown


def fed(teleop: Teleop, hands: list[WearerHand]) -> list[RobotState]:
    return [teleop.feed(one) for one in hands]


def test_a_fist_of_the_wearer_is_a_fist_of_the_robot() -> None:
    teleop = robot()
    state = fed(teleop, closing(150))[-1]
    bent = dict(zip(teleop.hand.joint_names, state.joints, strict=True))
    for finger in ("FF", "MF", "RF", "LF"):
        assert bent[f"{finger}J2"] + bent[f"{finger}J1"] + bent[f"{finger}J0"] > 2.5
    assert np.abs(state.joints - state.command).max() < 0.25  # motors are near their targets


def test_the_robot_holds_a_lost_hand_and_does_not_open() -> None:
    states = fed(robot(), closing(250, lost_from=120))
    held = [s for s in states if s.holding]
    assert len(held) == 130
    for state in held:
        assert (state.command == states[119].command).all()
    assert np.abs(held[-1].joints - states[119].command).max() < 0.3
    assert held[-1].palm[:3] == pytest.approx(states[119].palm[:3], abs=0.02)


def test_the_robot_does_not_jump_to_a_hand_found_elsewhere() -> None:
    teleop = robot()
    before = fed(teleop, closing(60, lost_from=50))[-1]
    far = [replace(one, p_G=one.p_G + [0.5, 0.2, 0.1], t=one.t + 1.0) for one in closing(2)]
    after = fed(teleop, far)[-1]
    assert not after.holding
    assert after.palm[:3] == pytest.approx(before.palm[:3], abs=0.01)


def test_a_released_clutch_uncouples_the_arm_and_scale_affects_motion_only() -> None:
    teleop = robot(replace(SETTINGS, motion_scale=2.0))
    start = teleop.feed(wearer(t=0.0)).palm[:3]
    for k in range(1, 100):
        moved = teleop.feed(wearer(p_GB=(0.0005 * k, 0.0, 0.3), t=0.01 * k))
    assert moved.palm[0] - start[0] == pytest.approx(2 * 0.0495, abs=0.01)
    teleop.command(RobotCommand("release"))
    for k in range(100, 150):
        still = teleop.feed(wearer(p_GB=(0.0, 0.0, 0.3), t=0.01 * k))
    assert still.holding and not still.engaged
    assert still.palm[:3] == pytest.approx(moved.palm[:3], abs=0.01)
    teleop.command(RobotCommand("engage"))
    again = teleop.feed(wearer(p_GB=(0.0, 0.0, 0.3), t=1.5))
    assert again.palm[:3] == pytest.approx(still.palm[:3], abs=0.005)


def test_the_palm_turns_as_the_wearers_and_no_faster_than_allowed() -> None:
    teleop = robot(replace(SETTINGS, turn_speed=2.0))
    R = so3.rz(0.5)
    teleop.feed(wearer(t=0.0))
    turned = [teleop.feed(wearer(R_GB=R, t=0.01 * k)) for k in range(1, 60)]
    yaw = np.array([2 * np.arctan2(s.palm[5], s.palm[6]) for s in turned])
    assert yaw[9] == pytest.approx(0.2, abs=0.06)
    assert yaw[-1] == pytest.approx(0.5, abs=0.02)


def test_the_same_hands_and_commands_give_the_same_states_bit_for_bit() -> None:
    hands = closing(120)
    one, other = robot(), robot()
    first = fed(one, hands[:60])
    one.command(RobotCommand("scale", 0.5))
    memory = one.memory
    first += fed(one, hands[60:])
    second = fed(other, hands[:60])
    other.command(RobotCommand("scale", 0.5))
    second += fed(other, hands[60:])
    assert all(_same(a, b) for a, b in zip(first, second, strict=True))
    third = robot()
    third.remember(memory)  # as a recording that begins in the middle does
    assert all(_same(a, b) for a, b in zip(first[60:], fed(third, hands[60:]), strict=True))


def _same(a: RobotState, b: RobotState) -> bool:
    names = ("command", "joints", "palm", "objects", "force")
    return all((getattr(a, n) == getattr(b, n)).all() for n in names)


def test_a_memory_of_another_robot_is_refused() -> None:
    other = Teleop(replace(SETTINGS, objects=""), shadow())
    with raises(ConfigError, "robot.recorded_other"):
        robot().remember(other.memory)


def test_unknown_commands_and_settings_are_errors() -> None:
    with raises(ConfigError, "robot.command"):
        robot().command(RobotCommand("dance"))
    with raises(ConfigError, "robot.scale"):
        robot().command(RobotCommand("scale", 1000.0))
    with raises(ConfigError, "robot.objects"):
        RobotSettings(objects="teapot")


def test_only_a_fingertip_on_the_table_has_contact_force() -> None:
    teleop = robot()
    hand = wearer_model()
    bent = posture(hand, {"index_mcp_flexion": 80.0})
    for k in range(150):
        state = teleop.feed(wearer(bent, (0.0, 0.0, 0.3 - 0.0008 * k), t=0.01 * k))
    assert state.force[1] > 0.5  # N, of the index finger
    assert state.force[0] == state.force[4] == 0.0


def test_a_gesture_opens_and_closes_the_clutch_once_each_time_it_is_shown() -> None:
    hand = wearer_model()
    names = hand.keypoint_names
    driver = RobotDriver(Teleop(replace(SETTINGS, clutch="fist"), shadow()), hand, names)
    fist = posture(hand, FIST)
    commands = []
    for k in range(120):
        angles = fist if (20 <= k < 40) or k >= 80 else 0.0 * fist
        R, p = hand.forward(angles, np.eye(3), np.array([0.0, 0.0, 0.3]))
        n = len(names)
        one = Estimate(
            0.01 * k, Tracking.TRACKING, hand.keypoints(R, p), np.tile([0.0, 0, 0, 1], (n, 1)),
            np.full(n, 2), np.full(n, 0.002), angles, np.full(len(angles), 2), R, p,
        )  # fmt: skip
        commands += [m.data["do"] for m in driver.feed(one) if isinstance(m, Event)]
    assert commands == ["release", "engage"]
