"""The robot arm: a scripted hand picks up a block, stops the arm, and lets it continue."""

from __future__ import annotations

import socket
from dataclasses import replace

import numpy as np
import pytest

from extensions.applications.arm.arm import AXES, REST, ArmSettings, RobotArm, SixAxisArm, ToolPose
from extensions.applications.drawing import Mesh
from extensions.applications.interface import JointCommand, PoseCommand
from extensions.applications.sinks import ArmSink, from_json, to_json
from extensions.applications.tests.hands import datas, outcomes, words
from tests.notices import raises
from tracker.base.errors import GlovetrackError
from tracker.geometry import so3
from tracker.simulation.scripted import Key

FOOT = [0.3, 0.1, 0.0]
UP = (0.17, 0.0, 0.15)
TO_BLOCK = (0.32 - 0.2756, 0.0, 0.018 - 0.2133)  # m from where the gripper rests
SETTINGS = {"place": FOOT, "scale": 2.0, "turning": False}


def moved(share: float) -> tuple[float, float, float]:
    """The palm when the gripper has covered a share of its path to the block."""
    x, y, z = (u + share * d / 2.0 for u, d in zip(UP, TO_BLOCK, strict=True))
    return x, y, z


PICK = [
    Key(0.0, "grasp", UP),
    Key(0.2, "grasp", UP),
    Key(1.4, "grasp", moved(1.0)),
    Key(1.8, "grasp", moved(1.0)),
    Key(2.0, "pinch_index", moved(1.0)),
    Key(2.8, "pinch_index", moved(1.0)),
    Key(3.6, "pinch_index", moved(0.4)),
    Key(4.0, "pinch_index", moved(0.4)),
]


def block_of(outcome) -> np.ndarray:
    (block,) = [d for d in outcome.drawing if isinstance(d, Mesh) and d.name == "block"]
    return block.p - FOOT


@pytest.mark.long
@pytest.mark.parametrize("commands", ["joints", "pose"])
def test_a_hand_picks_up_the_block(commands: str) -> None:
    found = outcomes("arm", PICK, commands=commands, **SETTINGS)
    reported = words(found)
    assert reported.index("clutch") < reported.index("grab") < reported.index("lifted")
    assert "release" not in reported
    assert block_of(found[0]) == pytest.approx([0.32, 0.0, 0.016], abs=0.001)
    assert block_of(found[-1])[2] > 0.08


def test_open_hands_do_not_move_it_and_motion_is_scaled() -> None:
    away = (UP[0], UP[1] + 0.1, UP[2])
    keys = [
        Key(0.0, "grasp", UP),
        Key(0.3, "grasp", UP),
        Key(1.0, "grasp", (UP[0], UP[1] + 0.04, UP[2])),
        Key(1.3, "grasp", (UP[0], UP[1] + 0.04, UP[2])),
        Key(1.5, "relaxed", (UP[0], UP[1] + 0.04, UP[2])),
        Key(2.3, "relaxed", away),
        Key(3.0, "relaxed", away),
    ]
    found = outcomes("arm", keys, robot="127.0.0.1:9", **SETTINGS)
    assert words(found)[-1] == "unclutch"
    last = found[-1].commands[0]
    assert isinstance(last, JointCommand)
    tool = SixAxisArm().pose_of(np.array(last.angles))
    assert tool.p[1] == pytest.approx(2.0 * 0.04, abs=0.003)


def test_an_open_palm_stops_it_until_a_thumb_is_raised() -> None:
    sideways = (UP[0], UP[1] + 0.08, UP[2])
    keys = [
        Key(0.0, "grasp", UP),
        Key(0.3, "grasp", UP),
        Key(0.6, "open_palm", UP),
        Key(1.0, "open_palm", UP),
        Key(1.3, "grasp", UP),
        Key(1.8, "grasp", sideways),
        Key(2.1, "thumb_up", sideways),
        Key(2.7, "thumb_up", sideways),
        Key(3.0, "relaxed", sideways),
        Key(3.3, "thumb_up", sideways),
        Key(3.9, "thumb_up", sideways),
    ]
    found = outcomes("arm", keys, robot="127.0.0.1:9", **SETTINGS)
    reported = [w for w in words(found) if w in ("stop", "go_on", "confirm")]
    assert reported == ["stop", "go_on", "confirm"]
    stops = [o.t for o in found if any(e.data["what"] == "stop" for e in o.events)]
    goes = [o.t for o in found if any(e.data["what"] == "go_on" for e in o.events)]
    for outcome in found:
        (command,) = outcome.commands
        assert command.stop == (stops[0] <= outcome.t < goes[0])  # type: ignore[union-attr]
    angles = [o.commands[0].angles for o in found if stops[0] <= o.t < goes[0]]  # type: ignore[union-attr]
    assert len(set(angles)) == 1
    (confirmed,) = datas(found, "confirm")
    assert abs(confirmed["at"][1]) < 0.01


def test_a_palm_that_is_only_likely_stops_it_too() -> None:
    """Ring and little finger inferred: the gesture takes a value of 0.95, the stop 0.6."""
    (first, *seen) = [
        o.hand for o in outcomes("arm", [Key(0.0, "grasp", UP), Key(0.3, "grasp", UP)])
    ]
    for value, stops in ((0.55, False), (0.7, True)):
        arm = RobotArm(ArmSettings(place=tuple(FOOT)))
        reported = [w.what for w in arm.step(first).events]
        for hand in seen:
            reported += [
                w.what for w in arm.step(replace(hand, values={"open_palm": value})).events
            ]
        assert ("stop" in reported) == stops


def test_inverse_kinematics_reaches_what_forward_kinematics_gives() -> None:
    arm, rng = SixAxisArm(), np.random.default_rng(2)
    for _ in range(20):
        wanted = REST + rng.uniform(-0.4, 0.4, 6)
        pose, q = arm.pose_of(wanted), REST
        for _ in range(30):
            q = arm.solve(pose, q)
        found = arm.pose_of(q)
        assert found.p == pytest.approx(pose.p, abs=1e-4)
        assert np.linalg.norm(so3.log(pose.R.T @ found.R)) < 1e-3
    far = arm.solve(ToolPose(pose.R, np.array([3.0, 0.0, 0.0])), REST)
    assert np.isfinite(far).all()


def test_no_joint_is_faster_than_it_may_be() -> None:
    arm = SixAxisArm()
    before, fastest = arm.angles, 0.0
    arm.take(JointCommand("six-axis", AXES, (2.5, 0.0, 1.0, 0.0, 1.0, 0.0)))
    for _ in range(150):
        arm.advance(0.01)
        fastest = max(fastest, float(np.abs(arm.angles - before).max()) / 0.01)
        before = arm.angles
    assert arm.angles[0] == pytest.approx(2.5, abs=0.02)
    assert fastest < 1.15 * 2.5
    arm.take(JointCommand("six-axis", (), (), stop=True))
    held = arm.angles
    arm.advance(0.5)
    assert arm.angles == pytest.approx(held, abs=0.01)


def test_a_robot_reads_what_is_sent_over_udp() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as robot:
        robot.bind(("127.0.0.1", 0))
        robot.settimeout(60.0)
        to = f"127.0.0.1:{robot.getsockname()[1]}"
        joints = JointCommand("six-axis", AXES, tuple(REST.tolist()), 1.0, False, to)
        pose = PoseCommand("six-axis", (0.3, 0.0, 0.2), (0.0, 1.0, 0.0, 0.0), 0.5, True, to)
        sink = ArmSink()
        sink.take([joints, pose], 1.5)
        received = [from_json(robot.recv(65536)) for _ in range(2)]
        sink.close()
    assert received == [joints._replace(to=""), pose._replace(to="")]
    with raises(GlovetrackError, "arm.not_command"):
        from_json('{"schema": 1, "robot": "r", "grip": 0, "stop": false}')
    with raises(GlovetrackError, "arm.address"):
        sink.take([joints._replace(to="nowhere")], 0.0)
    assert "joints" in to_json(joints, 0.0)
