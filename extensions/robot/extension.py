"""What the robot hand adds to the program."""

from __future__ import annotations

from extensions.robot.teleop_command import add_teleop, teleoperate
from tracker.base.command import Command

TELEOP = Command(
    "teleop",
    "drive a robot hand from a session or a live stream",
    teleoperate,
    add=add_teleop,
    extra="robot",
)
