"""The command ``teleop``: a robot hand that follows a session, a live stream or a script."""

from __future__ import annotations

import argparse
from pathlib import Path

from extensions.robot.library import SHADOW
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json


def add_teleop(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument("source", type=Path, nargs="?", metavar="IN", help="a session to follow")
    parser.add_argument("-o", "--out", type=Path, help="copy of the session with the robot added")
    parser.add_argument(
        "--check", action="store_true", help="drive the recorded robot again and compare"
    )
    parser.add_argument(
        "--listen",
        metavar="PORT|ws://HOST:PORT",
        help="follow a live stream over UDP or WebSocket until interrupted",
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=0.0,
        help="maximum duration of a live stream (0: unlimited)",
    )
    parser.add_argument(
        "--simulate",
        type=int,
        metavar="SEED",
        help="follow a simulated wearer who picks and places a cube",
    )
    parser.add_argument(
        "--send", default="", metavar="HOST:PORT", help="send robot states as JSON over UDP"
    )
    parser.add_argument(
        "--model",
        "--hand-model",
        default=SHADOW,
        help="robot hand: a name, or the path of an MJCF or URDF file",
    )
    add_fingers(parser)
    parser.add_argument(
        "--side",
        choices=("right", "left"),
        default="",
        help="side of the robot hand (default: the session's hand)",
    )
    parser.add_argument("--objects", default="cube,cylinder,ball", help="objects on the table")
    parser.add_argument(
        "--motion-scale", type=float, default=1.0, help="scale factor of the palm's motion"
    )
    parser.add_argument(
        "--reach-scale", type=float, default=1.0, help="scale factor of the fingers' reach"
    )
    parser.add_argument(
        "--clutch",
        choices=("none", "thumb_up", "point", "fist"),
        default="none",
        help="gesture that couples and uncouples the palm",
    )
    add_json(parser)


def add_fingers(parser: argparse.ArgumentParser) -> None:
    """The option for links of fingertips."""
    parser.add_argument(
        "--fingers",
        default="",
        metavar="FINGER=LINK,…|FILE.toml",
        help="links of the robot's fingertips (default: found automatically)",
    )


TELEOP = Command(
    "teleop",
    "drive a robot hand from a session or a live stream",
    deferred("extensions.robot.teleop_command:teleoperate"),
    add=add_teleop,
    extra="robot",
)


def add_robot_hand(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "model",
        metavar="MODEL",
        nargs="?",
        default=SHADOW,
        help="a robot hand: the path of an MJCF or URDF file (default: shadow)",
    )
    add_fingers(parser)
    parser.add_argument("-o", "--out", type=Path, help="write the links as a TOML file")
    add_json(parser)


ROBOT_HAND = Command(
    "robot-hand",
    "show the fingers that are found in a robot hand's file",
    deferred("extensions.robot.hand_command:show_robot_hand"),
    add=add_robot_hand,
    description="Reads an MJCF or URDF file, and prints which links are the fingertips and how "
    "they were found: by name, by position, or chosen with --fingers. With -o, the links are "
    "written to a TOML file that --fingers of this command and of teleop reads.",
    extra="robot",
)
