"""The command ``opensim-body``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json


def add_opensim_body(command: argparse.ArgumentParser) -> None:
    """Its arguments."""
    command.add_argument("session", type=Path, metavar="SESSION", help="a tracked session")
    command.add_argument(
        "--body", type=Path, required=True, metavar="BODY.osim", help="model of the body, OpenSim 4"
    )
    command.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="OUT.osim",
        help="the body with the hands; OUT.mot is written next to it",
    )
    command.add_argument(
        "--motion", type=Path, metavar="BODY.mot", help="coordinates of the body over time"
    )
    command.add_argument(
        "--offset",
        type=float,
        default=0.0,
        metavar="S",
        help="time in BODY.mot of the session's first estimate, s (default: 0)",
    )
    for side, usual in (("right", "hand_r"), ("left", "hand_l")):
        command.add_argument(
            f"--{side}",
            default=usual,
            metavar="SEGMENT",
            help=f"body segment of the {side} hand (default: {usual})",
        )
        command.add_argument(
            f"--place-{side}",
            type=float,
            nargs=6,
            metavar=("X", "Y", "Z", "RX", "RY", "RZ"),
            help=f"pose of the {side} dorsum in its segment, m and degrees (body-fixed x, y, z)",
        )
    add_json(command)


OPENSIM_BODY = Command(
    "opensim-body",
    "attach tracked hands to a whole-body OpenSim model",
    deferred("extensions.movement.body_command:opensim_body"),
    add=add_opensim_body,
)


def add_report(command: argparse.ArgumentParser) -> None:
    """Its arguments."""
    command.add_argument(
        "sessions", type=Path, nargs="+", metavar="SESSION", help="sessions or folders of sessions"
    )
    command.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="REPORT.html",
        help="the HTML page; the table is written next to it",
    )
    command.add_argument(
        "--anonymous", action="store_true", help="omit names of recordings and participants"
    )
    add_json(command)


REPORT = Command(
    "report",
    "summarise recordings in one HTML page and one table",
    deferred("extensions.movement.report.command:report"),
    add=add_report,
)
