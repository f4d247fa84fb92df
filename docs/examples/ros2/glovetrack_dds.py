"""What Glovetrack streams by WebSocket, on DDS as ROS 2 has it there: without ROS.

    pip install cyclonedds websockets
    glovetrack devices --stream websocket --stream-joints openxr
    python glovetrack_dds.py ws://127.0.0.1:9751/

The same topics as those of glovetrack_node.py, under ROS 2's names on DDS
(``rt/hand/right/joint_states``, type ``sensor_msgs::msg::dds_::JointState_``), best effort. It
keeps to this computer unless CYCLONEDDS_URI states otherwise; the domain is ROS_DOMAIN_ID's. A
second process hears it in a test; ROS 2 itself was not at hand.
"""

import json
import os
import sys
from typing import Any

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import float64, int32, sequence, uint32
from cyclonedds.pub import DataWriter
from cyclonedds.topic import Topic
from glovetrack_node import joint_states, poses, rates, stamp

LOOPBACK = (
    "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name='lo'/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><Peers><Peer Address='localhost'/></Peers>"
    "</Discovery></Domain></CycloneDDS>"
)
QOS = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(10))


def struct(package: str, name: str, /, **fields: Any) -> Any:
    """A message of ROS 2 as DDS has it: ``package::msg::dds_::Name_`` with these fields."""
    return final(make_idl_struct(name, f"{package}::msg::dds_::{name}", fields))


XYZ = dict.fromkeys("xyz", float64)
Time_ = struct("builtin_interfaces", "Time_", sec=int32, nanosec=uint32)
Header_ = struct("std_msgs", "Header_", stamp=Time_, frame_id=str)
JointState_ = struct(
    "sensor_msgs",
    "JointState_",
    header=Header_,
    name=sequence[str],
    **dict.fromkeys(("position", "velocity", "effort"), sequence[float64]),
)
Point_, Vector3_ = (struct("geometry_msgs", name, **XYZ) for name in ("Point_", "Vector3_"))
Quaternion_ = struct("geometry_msgs", "Quaternion_", **XYZ, w=float64)
Pose_ = struct("geometry_msgs", "Pose_", position=Point_, orientation=Quaternion_)
PoseArray_ = struct("geometry_msgs", "PoseArray_", header=Header_, poses=sequence[Pose_])
Transform_ = struct("geometry_msgs", "Transform_", translation=Vector3_, rotation=Quaternion_)
TransformStamped_ = struct(
    "geometry_msgs",
    "TransformStamped_",
    header=Header_,
    child_frame_id=str,
    transform=Transform_,
)
TFMessage_ = struct("tf2_msgs", "TFMessage_", transforms=sequence[TransformStamped_])


class Publisher:
    """Writers for the topics of each side, made when the side first appears."""

    def __init__(self, domain: int) -> None:
        os.environ.setdefault("CYCLONEDDS_URI", LOOPBACK)
        self._participant = DomainParticipant(domain)
        self._writers: dict[str, DataWriter] = {}

    def publish(self, estimate: dict[str, Any]) -> None:
        side = estimate["side"]
        at = Time_(*stamp(estimate))
        names, angles = joint_states(estimate)
        state = JointState_(Header_(at, ""), names, angles, rates(estimate), [])
        self._write(f"hand/{side}/joint_states", state)
        found = poses(estimate)
        header = Header_(at, "openxr")
        array = [Pose_(Point_(*place), Quaternion_(*turn)) for _, place, turn in found]
        self._write(f"hand/{side}/openxr", PoseArray_(header, array))
        frames = [
            TransformStamped_(
                header, f"{side}_{name}", Transform_(Vector3_(*place), Quaternion_(*turn))
            )
            for name, place, turn in found
            if place[0] == place[0]  # not NaN: lost
        ]
        self._write("tf", TFMessage_(frames))

    def _write(self, name: str, message: Any) -> None:
        if name not in self._writers:
            topic = Topic(self._participant, f"rt/{name}", type(message), qos=QOS)
            self._writers[name] = DataWriter(self._participant, topic, qos=QOS)
        self._writers[name].write(message)


def run(url: str) -> None:
    """Publish until the stream ends."""
    from websockets.sync.client import connect

    publisher = Publisher(int(os.environ.get("ROS_DOMAIN_ID", "0")))
    with connect(url) as stream:
        for text in stream:
            publisher.publish(json.loads(text))


if __name__ == "__main__":
    run(sys.argv[1] if len(sys.argv) > 1 else "ws://127.0.0.1:9751/")
