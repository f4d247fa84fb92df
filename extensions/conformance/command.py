"""The command ``conformance``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json


def add_conformance(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "file", type=Path, nargs="?", metavar="FILE", help="session or Isaac record"
    )
    parser.add_argument(
        "--simulate",
        "--simulated",
        action="store_true",
        help="check a simulated wearer who follows the script",
    )
    parser.add_argument(
        "--hands",
        choices=("left", "right", "both"),
        default="",
        help="hands to check (default: all)",
    )
    parser.add_argument(
        "--glove", default="", help="glove of the simulated wearer; --hands selects the side"
    )
    parser.add_argument("--seed", type=int, default=1, help="random seed of the simulated wearer")
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="PAGE.html|DIR",
        help="HTML page, or a folder for it (created if missing)",
    )
    add_json(parser)


CONFORMANCE = Command(
    "conformance",
    "check hand data against the requirements of robot labs and write an HTML page",
    deferred("extensions.conformance.command_runs:check_conformance"),
    add=add_conformance,
)
