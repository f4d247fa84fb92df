"""``glovetrack robot-hand``: the fingers that are found in a robot hand's file.

Functions import what they need, so that ``glovetrack --help`` is fast.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from extensions.robot.library import SHADOW
from extensions.robot.teleop_command import add_fingers
from tracker.base.command import Command
from tracker.base.errors import ConfigError
from tracker.base.files import check_target
from tracker.base.terminal import add_json, check_json, finish

if TYPE_CHECKING:
    from extensions.robot.survey import FingerRow, HandSurvey


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


def show_robot_hand(args: argparse.Namespace) -> int:
    """Print the fingers; write their links."""
    from extensions.robot.finger_map import map_given, write_map
    from extensions.robot.settings import RobotSettings
    from extensions.robot.survey import survey_hand

    check_json(args)
    if args.out:
        check_target(args.out, args.force)
    settings = RobotSettings(model=args.model, fingers=map_given(args.fingers).text)
    found = survey_hand(settings)
    if args.out and found.problem is None:
        write_map(args.out, found.map, args.force)
    finish(args, report(found), lines(found))
    if found.problem is not None:
        raise ConfigError(found.problem)
    return 0


def report(found: HandSurvey) -> dict[str, Any]:
    """The fingers as plain values."""
    rows = {
        row.finger: {
            "link": row.link, "found_by": row.how, "joints": list(row.joints),
            "length": row.length,
        }
        for row in found.fingers
    }  # fmt: skip
    return {"side": found.side, "palm": found.palm, "fingers": rows}


def lines(found: HandSurvey) -> list[str]:
    """The fingers as a table; where they were not found, the links to choose from."""
    if found.problem is not None:
        return ["Links that may be a fingertip:", *(f"  {name}" for name in found.tips)]
    wide = max([len(row.link) for row in found.fingers] + [len("link")]) + 2
    head = f"{'finger':<9}{'link':<{wide}}{'found by':<10}{'joints':>6}{'length':>9}"
    return [
        f"A {found.side} hand, palm {found.palm}",
        head,
        *(_line(r, wide) for r in found.fingers),
    ]


def _line(row: FingerRow, wide: int) -> str:
    length = "" if math.isnan(row.length) else f"{1e3 * row.length:.0f} mm"
    joints = len(row.joints) or ""
    return f"{row.finger:<9}{row.link or '–':<{wide}}{row.how:<10}{joints:>6}{length:>9}"


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
