"""The command ``teleop``: a robot hand that follows a session, a live stream or a script."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path
from typing import Any

from extensions.robot.library import SHADOW
from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option


def fingers_option() -> Any:
    """The field ``fingers: str``: the option for links of fingertips."""
    more = argument(
        "links of the robot's fingertips (default: found automatically)",
        metavar="FINGER=LINK,…|FILE.toml",
    )
    return field(default="", metadata=more)


@options
class TeleopArguments:
    """Arguments of ``glovetrack teleop``."""

    source: Path | None = field(default=None, metadata=argument("a session to follow", "IN"))
    out: Path | None = field(
        default=None, metadata=argument("copy of the session with the robot added", "-o", "--out")
    )
    check: bool = field(
        default=False, metadata=argument("drive the recorded robot again and compare")
    )
    listen: str | None = field(
        default=None,
        metadata=argument(
            "follow a live stream over UDP or WebSocket until interrupted",
            metavar="PORT|ws://HOST:PORT",
        ),
    )
    seconds: float = field(
        default=0.0, metadata=argument("maximum duration of a live stream (0: unlimited)")
    )
    simulate: int | None = field(
        default=None,
        metadata=argument("follow a simulated wearer who picks and places a cube", metavar="SEED"),
    )
    send: str = field(
        default="", metadata=argument("send robot states as JSON over UDP", metavar="HOST:PORT")
    )
    model: str = field(
        default=SHADOW,
        metadata=argument(
            "robot hand: a name, or the path of an MJCF or URDF file", "--model", "--hand-model"
        ),
    )
    fingers: str = fingers_option()
    side: str = field(
        default="",
        metadata=argument(
            "side of the robot hand (default: the session's hand)", choices=("right", "left")
        ),
    )
    objects: str = field(default="cube,cylinder,ball", metadata=argument("objects on the table"))
    motion_scale: float = field(default=1.0, metadata=argument("scale factor of the palm's motion"))
    reach_scale: float = field(default=1.0, metadata=argument("scale factor of the fingers' reach"))
    clutch: str = field(
        default="none",
        metadata=argument(
            "gesture that couples and uncouples the palm",
            choices=("none", "thumb_up", "point", "fist"),
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


TELEOP = Command(
    "teleop",
    "drive a robot hand from a session or a live stream",
    deferred("extensions.robot.teleop_command:teleoperate"),
    options=TeleopArguments,
    extra="robot",
)


@options
class RobotHandArguments:
    """Arguments of ``glovetrack robot-hand``."""

    model: str = field(
        default=SHADOW,
        metadata=argument(
            "a robot hand: the path of an MJCF or URDF file (default: shadow)", "MODEL"
        ),
    )
    fingers: str = fingers_option()
    out: Path | None = field(
        default=None, metadata=argument("write the links as a TOML file", "-o", "--out")
    )
    json: str | None = json_option()
    force: bool = force_option()


ROBOT_HAND = Command(
    "robot-hand",
    "show the fingers that are found in a robot hand's file",
    deferred("extensions.robot.hand_command:show_robot_hand"),
    options=RobotHandArguments,
    description="Reads an MJCF or URDF file, and prints which links are the fingertips and how "
    "they were found: by name, by position, or chosen with --fingers. With -o, the links are "
    "written to a TOML file that --fingers of this command and of teleop reads.",
    extra="robot",
)
