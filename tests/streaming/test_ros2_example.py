"""The example node's messages, from one of our payloads; rclpy itself is not installed."""

from __future__ import annotations

import json
import math
import runpy
import sys
import threading
import time
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest
from numpy.testing import assert_allclose

from tests.streaming.moving_hand import turning
from tracker.base.clock import ClockAnchor
from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import OPENXR, Names
from tracker.streaming.websocket import WebSocketPublisher

ENOUGH = 3
NODE = Path(__file__).parents[2] / "docs" / "examples" / "ros2" / "glovetrack_node.py"


def test_the_node_has_every_pose_in_order_and_omits_lost_ones(make_estimate, hand, glove) -> None:
    node = runpy.run_path(str(NODE))
    e = make_estimate(lost=("index_tip", "thumb_ip_flexion"), angles={"index_pip_flexion": 0.7})
    names = Names.of(hand, glove, OPENXR)
    estimate = json.loads(to_json(e, names))
    wanted = to_openxr(e, names.keypoints, joint_radii(hand))
    found = node["poses"](estimate)
    assert tuple(name for name, _, _ in found) == JOINTS
    for i, (name, place, turn) in enumerate(found):
        if name == "index_tip":
            assert all(map(math.isnan, (*place, *turn)))
        else:
            assert_allclose(place, wanted.position[i], atol=1e-6)
            assert_allclose(turn, wanted.orientation[i], atol=1e-6)
    angles = dict(zip(*node["joint_states"](estimate), strict=True))
    assert "thumb_ip_flexion" not in angles and angles["index_pip_flexion"] == 0.7


def test_a_stream_of_schema_1_has_no_velocities(make_estimate, hand, glove) -> None:
    node = runpy.run_path(str(NODE))
    names = Names.of(hand, glove, OPENXR)
    estimate = json.loads(to_json(make_estimate(), names))
    assert node["rates"](estimate) == []
    assert abs(node["stamp"](estimate)[0] - time.time()) < 5


class Message:
    """A generic ROS message: fields are created on access."""

    def __init__(self) -> None:
        self.__dict__["poses"] = []

    def __getattr__(self, name: str) -> Message:
        made = self.__dict__[name] = Message()
        return made


class Node:
    """Stores published messages, and ends the stream when there are enough."""

    def __init__(self, name: str) -> None:
        self.name, self.received, self.ending = name, {}, threading.Event()

    def create_publisher(self, kind: type, topic: str, depth: int) -> SimpleNamespace:
        def publish(message: Message) -> None:
            self.received.setdefault(topic, []).append(message)
            if len(self.received.get("/hand/right/openxr", [])) >= ENOUGH:
                self.ending.set()

        return SimpleNamespace(publish=publish)


def test_the_node_publishes_the_stream(
    make_estimate, hand, glove, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With stand-ins for rclpy and its messages, on a live stream until that ends."""
    node, frames = Node("glovetrack"), []
    broadcaster = SimpleNamespace(sendTransform=frames.append)
    stand_ins = {
        "rclpy": {"init": lambda: None, "create_node": lambda name: node},
        "geometry_msgs.msg": dict.fromkeys(("Pose", "PoseArray", "TransformStamped"), Message),
        "sensor_msgs.msg": {"JointState": Message},
        "tf2_ros": {"TransformBroadcaster": lambda node: broadcaster},
        "geometry_msgs": {},
        "sensor_msgs": {},
    }
    for name, content in stand_ins.items():
        module = ModuleType(name)
        module.__dict__.update(content)
        monkeypatch.setitem(sys.modules, name, module)
    names = Names.of(hand, glove, OPENXR, ClockAnchor(1_732_538_096_500_000_000, 0))
    server = WebSocketPublisher(names, port=0)
    e = turning(make_estimate(lost=("index_tip",), angles={"index_pip_flexion": 0.7}), names)

    def send() -> None:
        while not node.ending.wait(0.02):
            server.send(e)
        server.close()

    thread = threading.Thread(target=send)
    thread.start()
    runpy.run_path(str(NODE))["run"](f"ws://127.0.0.1:{server.port}/")
    thread.join()
    state = node.received["/hand/right/joint_states"][0]
    positions = dict(zip(state.name, state.position, strict=True))
    assert positions["index_pip_flexion"] == pytest.approx(0.7) and len(positions) == len(
        hand.joint_names
    )
    assert e.motion is not None
    assert_allclose(state.velocity, e.motion.angle_rate, atol=1e-6)
    stamp = state.header.stamp  # time of the pose, not of its publication
    assert (stamp.sec, stamp.nanosec) == (1_732_538_097, 750_000_000)
    array = node.received["/hand/right/openxr"][0]
    assert array.header.stamp is stamp
    assert len(array.poses) == len(JOINTS) and array.header.frame_id == "openxr"
    wanted = to_openxr(e, glove.keypoint_names(hand), joint_radii(hand))
    tip = JOINTS.index("index_tip")
    assert math.isnan(array.poses[tip].position.x)
    assert array.poses[1].position.x == pytest.approx(wanted.position[1, 0], abs=1e-6)
    assert array.poses[1].orientation.w == pytest.approx(wanted.orientation[1, 3], abs=1e-6)
    shown = {frame.child_frame_id for frame in frames}
    assert "right_wrist" in shown and "right_index_tip" not in shown
