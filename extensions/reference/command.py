"""The commands ``import-reference`` and ``accuracy``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json
from tracker.hand.names import SIDES


def add_import(command: argparse.ArgumentParser) -> None:
    """Arguments of ``import-reference``."""
    command.add_argument(
        "reference", type=Path, metavar="REFERENCE", help="C3D, TRC, TSV, CSV or BVH file"
    )
    command.add_argument("session", type=Path, metavar="SESSION", help="the tracked session")
    command.add_argument(
        "-o", "--output", type=Path, required=True, metavar="OUT.mcap", help="the new session"
    )
    command.add_argument(
        "--mapping", type=Path, metavar="TOML", help="names of points, columns of a CSV, unit"
    )
    command.add_argument(
        "--by",
        choices=("movement", "clock", "pulse"),
        default="movement",
        help="how to align the times",
    )
    command.add_argument(
        "--pulse", default="", metavar="NAME", help="name of the reference's events or channel"
    )
    command.add_argument(
        "--start", default="", metavar="TIME", help="clock time of the reference's start (ISO 8601)"
    )
    command.add_argument(
        "--no-drift", action="store_true", help="assume that both clocks have the same rate"
    )
    command.add_argument(
        "--register",
        choices=("offsets", "rigid", "none"),
        default="offsets",
        help="estimate the laboratory's frame and marker offsets, the frame alone, or nothing",
    )
    command.add_argument("--hand", choices=SIDES, default="", help="hand in a session of both")
    add_json(command)


def add_accuracy(command: argparse.ArgumentParser) -> None:
    """Arguments of ``accuracy``."""
    command.add_argument(
        "sessions",
        type=Path,
        nargs="+",
        metavar="SESSION",
        help="sessions with a reference, or folders of them",
    )
    command.add_argument(
        "-o", "--output", type=Path, required=True, metavar="REPORT.html", help="the HTML page"
    )
    command.add_argument(
        "--without-offsets", action="store_true", help="do not correct the markers' positions"
    )
    command.add_argument(
        "--anonymous", action="store_true", help="omit the names of recordings and participants"
    )
    add_json(command)


IMPORT = Command(
    "import-reference",
    "add a motion-capture recording to a session as a reference",
    deferred("extensions.reference.command_runs:import_reference_command"),
    add=add_import,
)


ACCURACY = Command(
    "accuracy",
    "report the accuracy of sessions against their references",
    deferred("extensions.reference.command_runs:accuracy_command"),
    add=add_accuracy,
)
