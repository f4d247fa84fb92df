"""Sends commands of the arm to a robot, as JSON in UDP datagrams.

    {"schema": 1, "robot": "six-axis", "t": 12.34, "stop": false, "grip": 1.0,
     "joints": {"yaw": 0.1, ...}}                                              or
    {..., "position": [x, y, z], "orientation_xyzw": [x, y, z, w]}

Angles in rad; position in m and orientation in the frame of the robot's base (x away from the
wearer, z up); ``grip`` 0 open to 1 closed; ``stop``: hold the current pose.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from extensions.applications.interface import Command, JointCommand, PoseCommand
from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.streaming.datagram import DatagramSocket

SCHEMA = 1


def to_json(command: JointCommand | PoseCommand, t: float) -> str:
    """The datagram's text."""
    data: dict[str, Any] = {"schema": SCHEMA, "robot": command.robot, "t": t}
    data |= {"stop": command.stop, "grip": command.grip}
    if isinstance(command, JointCommand):
        data["joints"] = dict(zip(command.names, command.angles, strict=True))
    else:
        data |= {"position": command.p, "orientation_xyzw": command.q}
    return json.dumps(data, separators=(",", ":"), allow_nan=False)


def from_json(text: str | bytes) -> JointCommand | PoseCommand:
    """Parse a datagram. Raises GlovetrackError for invalid content."""
    try:
        data = json.loads(text)
        robot, grip, stop = str(data["robot"]), float(data["grip"]), bool(data["stop"])
        if data["schema"] != SCHEMA:
            raise ValueError(f"schema {data['schema']}")
        if "joints" in data:
            names = tuple(map(str, data["joints"]))
            angles = tuple(float(a) for a in data["joints"].values())
            return JointCommand(robot, names, angles, grip, stop)
        x, y, z = map(float, data["position"])
        a, b, c, d = map(float, data["orientation_xyzw"])
        return PoseCommand(robot, (x, y, z), (a, b, c, d), grip, stop)
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise GlovetrackError(notice("arm.not_command", why=error)) from error


class ArmSink:
    """Sends each command to the robot at its address."""

    def __init__(self) -> None:
        self._to = ""
        self._socket: DatagramSocket | None = None

    def take(self, commands: Sequence[Command], t: float) -> None:
        for command in commands:
            if isinstance(command, JointCommand | PoseCommand) and command.to:
                self._open(command.to)
                assert self._socket is not None
                self._socket.send(to_json(command, t).encode())

    def _open(self, to: str) -> None:
        if to != self._to:
            self.close()
            host, _, port = to.rpartition(":")
            if not host or not port.isdecimal():
                raise GlovetrackError(notice("arm.address", address=to))
            self._socket, self._to = DatagramSocket("Robot arm", host, int(port)), to

    def close(self) -> None:
        if self._socket is not None:
            self._socket.close()
            self._socket, self._to = None, ""
