"""What the robot hand adds to the program."""

from __future__ import annotations

from extensions.robot.hand_command import add_robot_hand, show_robot_hand
from extensions.robot.teleop_command import add_teleop, teleoperate
from tracker.base.command import Command

TELEOP = Command(
    "teleop",
    "drive a robot hand from a session or a live stream",
    teleoperate,
    add=add_teleop,
    extra="robot",
)

ROBOT_HAND = Command(
    "robot-hand",
    "show the fingers that are found in a robot hand's file",
    show_robot_hand,
    add=add_robot_hand,
    description="Reads an MJCF or URDF file, and prints which links are the fingertips and how "
    "they were found: by name, by position, or chosen with --fingers. With -o, the links are "
    "written to a TOML file that --fingers of this command and of teleop reads.",
    extra="robot",
)
