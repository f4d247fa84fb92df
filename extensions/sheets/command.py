"""``glovetrack print``."""

from __future__ import annotations

import argparse
from pathlib import Path

from extensions.sheets.kinds import SHEETS
from tracker.base.command import Command
from tracker.base.files import check_target, whole_file
from tracker.base.registry import names_of
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


def print_sheets(args: argparse.Namespace) -> int:
    """Write the PDF file."""
    from extensions.sheets.page import save_pages
    from tracker.glove import library

    check_target(args.out, args.force)
    hand, glove = library.load(args.glove or library.DEFAULT_GLOVE)
    pages, title = SHEETS.get(args.what).pages(hand, glove, args.paper)
    with whole_file(args.out, args.force) as part:
        save_pages(pages, part, title)
    print(f"{args.out}: {len(pages)} page{'s' if len(pages) > 1 else ''}; print at 100 % scale")
    return 0


PRINT = Command(
    "print", "create PDF sheets at true scale for building a glove", print_sheets, add=add_print
)
