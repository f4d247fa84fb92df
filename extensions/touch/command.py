"""The command ``touch-test``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json


def add_touch_test(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "sessions",
        type=Path,
        nargs="+",
        metavar="SESSION",
        help="session of a touch test; several of one person, who puts the glove on again for "
        "each, give the repeatability",
    )
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="REPORT.html",
        help="the HTML page; for one session, a PDF file of the same name is written next to it",
    )
    parser.add_argument(
        "--ruler",
        type=float,
        metavar="MM",
        help="length of the printed line of 260 mm, measured with a ruler (default: the length "
        "entered in the window; without it, the camera's scale is assumed to be correct)",
    )
    parser.add_argument("--side", default="", help="left or right, of a session of both hands")
    add_json(parser)


TOUCH_TEST = Command(
    "touch-test",
    "report how accurate the fingertips of a recorded touch test are",
    deferred("extensions.touch.command_runs:touch_test"),
    add=add_touch_test,
)


def add_touch(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "--wearers", type=int, default=20, metavar="N", help="number of wearers (default: 20)"
    )
    parser.add_argument("--engine", default="chain", help="chain or vist")
    parser.add_argument("--seed", type=int, default=1, help="random seed of the first wearer")
    parser.add_argument(
        "--processes",
        type=int,
        default=1,
        metavar="N",
        help="number of worker processes (default: 1)",
    )
    add_json(parser)


EVALUATE = Command(
    "evaluate touch",
    "let simulated wearers take the touch test; compare its figures with the true error",
    deferred("extensions.touch.simulated.command:evaluate_touch"),
    add=add_touch,
)
