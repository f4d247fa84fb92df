"""Devices that receive an application's commands, including the glove's motors.

A glove with one motor per finger has them in the order thumb, index, middle, ring, little finger.
Fingertip devices with three axes (Lee et al. 2021, Fig. 8B) have three motors per finger, from
channel `THREE` on, which pull the pad along `PULLS`; a force is the sum of three pulls.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from extensions.applications.hand import TIPS
from extensions.applications.interface import Command, JointCommand, MotorCommand, PoseCommand
from extensions.applications.stage import CommandSink
from extensions.applications.swarm.vehicles import VehicleSink
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.live.listeners import Vibrate
from tracker.messages import Event
from tracker.streaming.datagram import DatagramSocket

KIND = "motor"
THREE = len(TIPS)
LEAN = np.deg2rad(50.0)  # angle of each pull from the pad's normal
PULLS = np.array(
    [
        [np.sin(LEAN) * np.cos(a), np.sin(LEAN) * np.sin(a), np.cos(LEAN)]
        for a in np.deg2rad([0.0, 120.0, 240.0])
    ]
)
"""(3, 3) rows: directions in the distal segment's frame B in which three motors push the pad."""
LASTS_MS = 60  # a motor stops if no further command arrives
AGAIN = 0.03  # s after which an unchanged command is repeated
STEP = 8  # of 255: larger changes are sent immediately


@dataclass
class _Motor:
    amplitude: int = 0
    sent: float = -np.inf  # time of the last command, s of the samples' clock


def pulls(command: MotorCommand) -> np.ndarray:
    """Amplitudes (3,) 0..1 of three motors whose pulls add up to the force; negative ones are 0."""
    push = command.strength * np.array(command.direction)
    return np.clip(np.linalg.solve(PULLS.T, push), 0.0, 1.0)


class MotorSink:
    """Sends commands to motors, no more often than needed, and reports each as an event.

    Events are stamped with ``clock`` (s); the difference to the sample (``of``) is the latency from
    packet to motor.
    """

    def __init__(
        self,
        vibrate: Vibrate,
        clock: Callable[[], float],
        tell: Callable[[Event], None] = lambda _: None,
    ) -> None:
        self._vibrate, self._clock, self._tell = vibrate, clock, tell
        self._motors: dict[int, _Motor] = {}

    def take(self, commands: Sequence[Command], t: float) -> None:
        wanted: dict[int, int] = {}
        for command in commands:
            if isinstance(command, MotorCommand) and command.tip in TIPS:
                wanted |= _amplitudes(command)
        for channel in [c for c, m in self._motors.items() if m.amplitude and c not in wanted]:
            wanted[channel] = 0
        for channel, amplitude in wanted.items():
            self._drive(channel, amplitude, t)

    def _drive(self, channel: int, amplitude: int, t: float) -> None:
        motor = self._motors.setdefault(channel, _Motor())
        changes = abs(amplitude - motor.amplitude) >= STEP or bool(amplitude) != bool(
            motor.amplitude
        )
        if not changes and not (amplitude and t - motor.sent >= AGAIN):
            return
        if not self._vibrate(channel, amplitude, LASTS_MS if amplitude else 1):
            return  # a later sample repeats it
        motor.amplitude, motor.sent = amplitude, t
        data: dict[str, object] = {"channel": channel, "amplitude": amplitude, "of": t}
        if changes:
            self._tell(Event(self._clock(), KIND, "", data))

    def close(self) -> None:
        """Stop all motors."""
        for channel, motor in self._motors.items():
            if motor.amplitude:
                self._vibrate(channel, 0, 1)
        self._motors.clear()


def _amplitudes(command: MotorCommand) -> dict[int, int]:
    """Amplitudes by channel."""
    finger = TIPS.index(command.tip)
    if command.axes == 1:
        return {finger: round(255 * min(max(command.strength, 0.0), 1.0))}
    return {THREE + 3 * finger + k: round(255 * u) for k, u in enumerate(pulls(command).tolist())}


def network_sinks() -> list[CommandSink]:
    """Sinks of vehicles and robots; connections are opened with the first command to an address."""
    return [VehicleSink(), ArmSink()]


def all_sinks(vibrate: Vibrate | None, tell: Callable[[Event], None]) -> list[CommandSink]:
    """All sinks of a hand: the network and, if present, the glove's motors; ``tell`` receives an
    event for each motor command."""
    motors: list[CommandSink] = [MotorSink(vibrate, monotonic, tell)] if vibrate is not None else []
    return [*motors, *network_sinks()]


# ---- sends commands of the arm to a robot, as JSON in UDP datagrams
#
#     {"schema": 1, "robot": "six-axis", "t": 12.34, "stop": false, "grip": 1.0,
#      "joints": {"yaw": 0.1, ...}}                                              or
#     {..., "position": [x, y, z], "orientation_xyzw": [x, y, z, w]}
#
# Angles in rad; position in m and orientation in the frame of the robot's base (x away from the
# wearer, z up); ``grip`` 0 open to 1 closed; ``stop``: hold the current pose.

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
