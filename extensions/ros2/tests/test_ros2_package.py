"""The converters of the ROS 2 package, against the definitions of rosbags and on DDS."""

from __future__ import annotations

import contextlib
import json
import os
import socket
import subprocess
import sys
import threading
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_typestore
from scipy.spatial.transform import Rotation

from extensions.ros2.glovetrack_ros.glovetrack_ros import convert, requests
from tests.streaming.moving_hand import turning
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.base.clock import ClockAnchor
from tracker.messages import Estimate
from tracker.streaming.payload import LATEST, to_json
from tracker.streaming.publisher import Names
from tracker.streaming.udp import UdpPublisher

PACKAGE = Path(__file__).parents[1] / "glovetrack_ros"
STORE = get_typestore(Stores.ROS2_JAZZY)
AT = 1_732_538_096_500_000_000
DOMAIN = 78


@pytest.fixture
def estimate(make_estimate, hand, glove) -> dict[str, Any]:
    names = Names.of(hand, glove, anchor=ClockAnchor(AT, 0))
    e = turning(make_estimate(lost=("index_tip",), angles={"index_pip_flexion": 0.7}), names)
    out: dict[str, Any] = json.loads(to_json(e, names, schema=LATEST))
    return out


def built(kind: Any, value: Any) -> Any:
    """A value of the type that rosbags has for a field."""
    node, detail = kind
    if node == Nodetype.BASE:
        return value[0] if isinstance(value, bytes) else value
    if node == Nodetype.NAME:
        return message(detail, value)
    inner = detail[0]
    if inner[0] == Nodetype.BASE and inner[1][0] != "string":
        return np.array(value, inner[1][0])
    return [built(inner, v) for v in value]


def message(name: str, fields: dict[str, Any]) -> Any:
    kinds = dict(STORE.fielddefs[name][1])
    assert fields.keys() == kinds.keys(), f"the fields of {name}"
    return STORE.types[name](**{f: built(kind, fields[f]) for f, kind in kinds.items()})


def test_every_message_has_the_fields_of_its_type(estimate: dict[str, Any]) -> None:
    """Serialized by rosbags, and read back."""
    topics = set()
    for made in convert.messages(estimate, "map"):
        data = STORE.serialize_cdr(message(made.type, made.fields), made.type)
        read = STORE.deserialize_cdr(data, made.type)
        topics.add(made.topic)
        if hasattr(read, "header"):
            stamp = read.header.stamp
            assert stamp.sec * 10**9 + stamp.nanosec == estimate["t_unix_ns"]
    root = "hand/right/"
    own = {root + name for name in ("joint_states", "keypoints", "wrist", "twist")}
    assert topics == own | {"tf", "diagnostics"}


def test_rosbags_reads_a_recording(recorded: RecordedHand) -> None:
    """Each message from the stream's datagram, serialized by rosbags and read back."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind(("127.0.0.1", 0))
        client.settimeout(60)
        out = UdpPublisher(recorded.names, port=client.getsockname()[1], schema=LATEST)
        with contextlib.closing(out):
            for e in recorded.estimates:
                out.send(e)
                read = {}
                for made in convert.messages(json.loads(client.recv(65536))):
                    data = STORE.serialize_cdr(message(made.type, made.fields), made.type)
                    read[made.topic] = STORE.deserialize_cdr(data, made.type)
                check(read, recorded, e)


def check(read: dict[str, Any], recorded: RecordedHand, e: Estimate) -> None:
    """Messages by topic, as ROS has them."""
    points, turns = recorded.points(e), recorded.turns(e)
    joints = read["hand/right/joint_states"]
    stamp = joints.header.stamp
    assert abs(stamp.sec * 10**9 + stamp.nanosec - recorded.unix_ns(e)) < 1000
    found = dict(zip(joints.name, joints.position, strict=True))
    assert found == pytest.approx(recorded.angles(e), abs=1e-5)
    check_pose(read["hand/right/wrist"].pose.pose, points["wrist"], turns["wrist"])
    for name, pose in zip(
        recorded.names.keypoints, read["hand/right/keypoints"].poses, strict=True
    ):
        check_pose(pose, points[name], turns[name])
    frames = {t.child_frame_id: t.transform for t in read["tf"].transforms}
    assert frames.keys() == {f"right_{name}" for name in points}
    for name in points:
        moved = frames[f"right_{name}"]
        assert_near([getattr(moved.translation, a) for a in "xyz"], points[name])
        q = [getattr(moved.rotation, a) for a in "xyzw"]
        assert_parallel(Rotation.from_quat(q), turns[name])


def check_pose(pose: Any, p: np.ndarray, turn: Rotation) -> None:
    assert_near([getattr(pose.position, a) for a in "xyz"], p)
    q = [getattr(pose.orientation, a) for a in "xyzw"]
    assert_parallel(Rotation.from_quat(q), turn)


def test_values_are_those_of_the_stream(estimate: dict[str, Any]) -> None:
    made = {m.topic: m.fields for m in convert.messages(estimate, "map")}
    joints = made["hand/right/joint_states"]
    angles = dict(zip(joints["name"], joints["position"], strict=True))
    assert angles["index_pip_flexion"] == 0.7
    assert len(joints["velocity"]) == len(joints["name"])
    wrist = made["hand/right/wrist"]
    assert wrist["header"]["frame_id"] == "map"
    covariance = np.reshape(wrist["pose"]["covariance"], (6, 6))
    sd = estimate["keypoints"]["wrist"]["sd"]
    np.testing.assert_allclose(np.diag(covariance), [sd**2] * 3 + [-1, 0, 0])
    twist = np.reshape(made["hand/right/twist"]["twist"]["covariance"], (6, 6))
    moving = estimate["velocity"]["wrist"]
    expected = [moving["sd"] ** 2] * 3 + [moving["angular_sd"] ** 2] * 3
    np.testing.assert_allclose(np.diag(twist), expected)
    frames = {t["child_frame_id"] for t in made["tf"]["transforms"]}
    assert "right_wrist" in frames and "right_index_tip" not in frames
    lost = list(estimate["keypoints"]).index("index_tip")
    assert np.isnan(made["hand/right/keypoints"]["poses"][lost]["position"]["x"])
    (status,) = made["diagnostics"]["status"]
    assert {v["key"]: v["value"] for v in status["values"]}["lost"] == "1"


TALKER = """
import json, sys, time
from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.topic import Topic
from extensions.ros2.glovetrack_ros.glovetrack_ros.convert import messages
from extensions.ros2.tests.dds_types import dds_message, dds_type
participant, writers = DomainParticipant(int(sys.argv[1])), {}
estimate = json.loads(sys.stdin.read())
end = time.monotonic() + 100
while time.monotonic() < end:
    for m in messages(estimate):
        if m.topic not in writers:
            topic = Topic(participant, f"rt/{m.topic}", dds_type(m.type))
            qos = Qos(Policy.Reliability.BestEffort)
            writers[m.topic] = DataWriter(participant, topic, qos=qos)
        writers[m.topic].write(dds_message(m.type, m.fields))
    time.sleep(0.02)
"""
LOOPBACK = (
    "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name='lo'/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><Peers><Peer Address='localhost'/></Peers>"
    "</Discovery></Domain></CycloneDDS>"
)


def test_a_second_process_receives_a_recorded_hand_on_dds(
    recorded: RecordedHand, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With the topics and types that ROS 2 has there: rt/…, …::msg::dds_::…_."""
    pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")
    monkeypatch.setenv("CYCLONEDDS_URI", LOOPBACK)
    from cyclonedds.core import Policy, Qos
    from cyclonedds.domain import DomainParticipant
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic
    from cyclonedds.util import duration

    from extensions.ros2.tests.dds_types import dds_type

    e = recorded.estimates[-1]
    estimate = json.loads(to_json(e, recorded.names, schema=LATEST))
    root = Path(__file__).parents[3]
    talker = subprocess.Popen(
        [sys.executable, "-c", TALKER, str(DOMAIN)],
        stdin=subprocess.PIPE, env={**os.environ, "PYTHONPATH": str(root)}, text=True, cwd=root,
    )  # fmt: skip
    assert talker.stdin is not None
    talker.stdin.write(json.dumps(estimate))
    talker.stdin.close()
    try:
        participant, read = DomainParticipant(DOMAIN), {}
        for made in convert.messages(estimate):
            topic = Topic(participant, f"rt/{made.topic}", dds_type(made.type))
            reader = DataReader(participant, topic, qos=Qos(Policy.Reliability.BestEffort))
            read[made.topic] = reader.take_one(timeout=duration(seconds=60))
    finally:
        talker.terminate()
        talker.wait(60)
    check(read, recorded, e)
    wrist = read["hand/right/wrist"]
    assert wrist.pose.covariance[0] == estimate["keypoints"]["wrist"]["sd"] ** 2


def test_requests_are_sent_and_answered() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as door:
        door.bind(("127.0.0.1", 0))
        door.settimeout(60)

        def answer() -> None:
            data, client = door.recvfrom(1000)
            reply = {"ok": True, "do": json.loads(data)["do"], "text": "Recording a.mcap."}
            door.sendto(json.dumps(reply).encode(), client)

        thread = threading.Thread(target=answer)
        thread.start()
        assert requests.ask(door.getsockname(), {"do": "start"}) == (True, "Recording a.mcap.")
        thread.join()
    assert requests.vibration("index", 2.0, 9.0)["amplitude"] == 255
    assert requests.vibration("index", 0.5)["duration_ms"] == 100


def test_the_package_is_complete() -> None:
    """Name and version are the same everywhere; each file that setup.py installs exists."""
    xml = ET.parse(PACKAGE / "package.xml").getroot()
    setup = (PACKAGE / "setup.py").read_text("utf-8")
    assert xml.findtext("name") == "glovetrack_ros" == PACKAGE.name
    assert f'version="{xml.findtext("version")}"' in setup
    assert xml.findtext("export/build_type") == "ament_python"
    for path in ("launch/glovetrack.launch.py", "config/glovetrack.yaml"):
        assert path in setup and (PACKAGE / path).is_file()
    assert (PACKAGE / "resource" / "glovetrack_ros").is_file()
    node = (PACKAGE / "glovetrack_ros" / "node.py").read_text("utf-8")
    compile(node, "node.py", "exec")
