"""``glovetrack print``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred, names_of
from tracker.base.terminal import add_force

PAPERS = ("a4", "letter")


def add_print(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "what",
        choices=names_of("sheets"),
        help="marker patches and their positions, the wiring, the camera's calibration board, or a "
        "sheet of another extension",
    )
    parser.add_argument("-o", "--out", type=Path, required=True, help="the PDF file")
    parser.add_argument(
        "--glove", default="", help="glove name or file (default: the first bundled glove)"
    )
    parser.add_argument("--paper", choices=PAPERS, default=PAPERS[0], help="paper size")
    add_force(parser)


PRINT = Command(
    "print",
    "create PDF sheets at true scale for building a glove",
    deferred("extensions.sheets.command_runs:print_sheets"),
    add=add_print,
)
