"""``glovetrack doctor``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json


def _add(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "-o",
        "--out",
        metavar="REPORT",
        type=Path,
        help="also write the report to a text file",
    )
    parser.add_argument(
        "--folder",
        type=Path,
        default=Path(),
        help="folder whose disk is tested (default: the current one)",
    )
    parser.add_argument(
        "--only", metavar="CHECK", nargs="+", help="run these checks only, such as gloves cameras"
    )
    parser.add_argument(
        "--fps", type=float, default=30.0, help="images per second to request (default: 30)"
    )
    add_json(parser)


DOCTOR = Command[argparse.Namespace](
    "doctor",
    "check the computer and the devices, with a remedy for each problem",
    deferred("tracker.doctor.command_runs:run_doctor"),
    add=_add,
    description="Checks the system, permissions, ports, gloves, cameras, disk, processor and "
    "graphics card. Prints a line per finding: ok, warning or error, what was found, and what to "
    "do about it. The exit status is 1 if there is an error. Devices must not be in use.",
)
