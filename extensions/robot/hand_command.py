"""``glovetrack robot-hand``: the fingers that are found in a robot hand's file."""

from __future__ import annotations

import math
from typing import Any

from extensions.robot.commands import RobotHandArguments
from extensions.robot.finger_map import map_given, write_map
from extensions.robot.settings import RobotSettings
from extensions.robot.survey import FingerRow, HandSurvey, survey_hand
from tracker.base.errors import ConfigError
from tracker.base.files import check_target
from tracker.base.terminal import check_json, finish


def show_robot_hand(args: RobotHandArguments) -> int:
    """Print the fingers; write their links."""
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
