"""The node: messages of Glovetrack's UDP stream as topics, its remote control as services.

Topics: see `convert.messages`, and ``robot_description``. Services ``~/start`` and ``~/stop``
(std_srvs/Trigger) record; a std_msgs/String on ``~/note`` adds a note, a std_msgs/Float32 from 0 to
1 on ``~/vibrate/FINGER`` runs a motor.
"""

from __future__ import annotations

import json
import socket
from functools import partial
from pathlib import Path
from typing import Any

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rosidl_runtime_py import set_message_fields
from rosidl_runtime_py.utilities import get_message
from std_msgs.msg import Float32, String
from std_srvs.srv import Trigger

from glovetrack_ros.convert import messages
from glovetrack_ros.requests import ask, vibration

FINGERS = ("thumb", "index", "middle", "ring", "little")
PERIOD = 0.002  # s between two looks at the socket
DEFAULTS: dict[str, Any] = {
    "stream_host": "127.0.0.1",
    "stream_port": 9750,
    "remote_host": "127.0.0.1",
    "remote_port": 9760,
    "frame_id": "world",
    "urdf": "",
}


class GlovetrackNode(Node):
    """Publishes what arrives, and passes on what is asked."""

    def __init__(self) -> None:
        super().__init__("glovetrack")
        self._values = {k: self.declare_parameter(k, v).value for k, v in DEFAULTS.items()}
        self._remote = (self._values["remote_host"], int(self._values["remote_port"]))
        self._out: dict[str, Any] = {}
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind((self._values["stream_host"], int(self._values["stream_port"])))
        self._socket.setblocking(False)
        self.create_timer(PERIOD, self._receive)
        for word in ("start", "stop"):
            self.create_service(Trigger, f"~/{word}", partial(self._do, word))
        self.create_subscription(String, "~/note", self._note, 10)
        for finger in FINGERS:
            topic, act = f"~/vibrate/{finger}", partial(self._vibrate, finger)
            self.create_subscription(Float32, topic, act, qos_profile_sensor_data)
        self._describe(self._values["urdf"])

    def _receive(self) -> None:
        while True:
            try:
                data = self._socket.recv(65536)
            except BlockingIOError:
                return
            for made in messages(json.loads(data), self._values["frame_id"]):
                message = get_message(made.type)()
                set_message_fields(message, made.fields)
                self._publisher(made.topic, type(message)).publish(message)

    def _publisher(self, topic: str, kind: type) -> Any:
        if topic not in self._out:
            reliable = topic in ("tf", "diagnostics")
            qos = QoSProfile(depth=100) if reliable else qos_profile_sensor_data
            self._out[topic] = self.create_publisher(kind, topic, qos)
        return self._out[topic]

    def _describe(self, urdf: str) -> None:
        if urdf:
            kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            text = Path(urdf).read_text(encoding="utf-8")
            self.create_publisher(String, "robot_description", kept).publish(String(data=text))

    def _do(self, word: str, _request: Any, response: Any) -> Any:
        response.success, response.message = ask(self._remote, {"do": word})
        return response

    def _note(self, message: Any) -> None:
        self._ask({"do": "note", "text": message.data})

    def _vibrate(self, finger: str, message: Any) -> None:
        self._ask(vibration(finger, message.data))

    def _ask(self, words: dict[str, Any]) -> None:
        done, text = ask(self._remote, words)
        if not done:
            self.get_logger().warning(text)


def main() -> None:
    """Runs the node until it is interrupted."""
    rclpy.init()
    node = GlovetrackNode()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
