"""The hand on DDS, received by a second process through Eclipse Cyclone DDS."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")
pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")

from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.streaming.publisher import OPENXR, Names
from tracker.streaming.websocket import WebSocketPublisher

EXAMPLE = Path(__file__).parents[2] / "docs" / "examples" / "ros2"
DOMAIN = 77

LISTENER = """
import json, sys
sys.path.insert(0, sys.argv[1])
import os
import glovetrack_dds as dds
os.environ.setdefault("CYCLONEDDS_URI", dds.LOOPBACK)
from cyclonedds.domain import DomainParticipant
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration
participant = DomainParticipant(int(sys.argv[2]))
kinds = {"hand/right/joint_states": dds.JointState_, "hand/right/openxr": dds.PoseArray_,
         "tf": dds.TFMessage_}
readers = {name: DataReader(participant, Topic(participant, f"rt/{name}", kind, qos=dds.QOS),
                            qos=dds.QOS) for name, kind in kinds.items()}
state, array, tf = (reader.take_one(timeout=duration(seconds=60)) for reader in readers.values())
print(json.dumps({
    "angles": dict(zip(state.name, state.position)),
    "poses": [[p.position.x, p.position.y, p.position.z, p.orientation.x, p.orientation.y,
               p.orientation.z, p.orientation.w] for p in array.poses],
    "frame": array.header.frame_id,
    "frames": [t.child_frame_id for t in tf.transforms],
}))
"""


@pytest.fixture
def stream(hand, glove, make_estimate) -> Iterator[int]:
    """The port of a stream that runs until the test ends."""
    server = WebSocketPublisher(Names.of(hand, glove, OPENXR), port=0)
    estimate = make_estimate(lost=("index_tip",), angles={"index_pip_flexion": 0.7})
    ending = threading.Event()

    def send() -> None:
        while not ending.wait(0.02):
            server.send(estimate)

    thread = threading.Thread(target=send)
    thread.start()
    yield server.port
    ending.set()
    thread.join()
    server.close()


def test_a_second_process_receives_angles_poses_and_frames(
    stream, hand, glove, make_estimate
) -> None:
    environment = {**os.environ, "ROS_DOMAIN_ID": str(DOMAIN)}
    talker = subprocess.Popen(
        [sys.executable, str(EXAMPLE / "glovetrack_dds.py"), f"ws://127.0.0.1:{stream}/"],
        env=environment,
    )
    try:
        listener = subprocess.run(
            [sys.executable, "-c", LISTENER, str(EXAMPLE), str(DOMAIN)],
            env=environment, capture_output=True, text=True, timeout=120,
        )  # fmt: skip
        assert listener.returncode == 0, listener.stderr
    finally:
        talker.terminate()
        talker.wait(60)
    output = json.loads(listener.stdout)
    assert output["angles"]["index_pip_flexion"] == pytest.approx(0.7)
    assert len(output["angles"]) == len(hand.joint_names)
    e = make_estimate(lost=("index_tip",), angles={"index_pip_flexion": 0.7})
    xr = to_openxr(e, glove.keypoint_names(hand), joint_radii(hand))
    assert len(output["poses"]) == len(JOINTS) and output["frame"] == "openxr"
    for i, name in enumerate(JOINTS):
        wanted = [*xr.position[i], *xr.orientation[i]]
        assert output["poses"][i] == pytest.approx(wanted, abs=1e-6, nan_ok=True), name
    lost = {f"right_{name}" for name, state in zip(JOINTS, xr.state, strict=True) if state == 0}
    assert set(output["frames"]) == {f"right_{name}" for name in JOINTS} - lost
    assert "right_index_tip" in lost
