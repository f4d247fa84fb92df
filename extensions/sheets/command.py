"""``glovetrack print``."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred, names_of
from tracker.base.terminal import force_option

PAPERS = ("a4", "letter")


@options
class PrintArguments:
    """Arguments of ``glovetrack print``."""

    what: str = field(
        metadata=argument(
            "marker patches and their positions, the wiring, the camera's calibration board, or a "
            "sheet of another extension",
            choices=names_of("sheets"),
        )
    )
    out: Path = field(metadata=argument("the PDF file", "-o", "--out"))
    glove: str = field(
        default="", metadata=argument("glove name or file (default: the first bundled glove)")
    )
    paper: str = field(default=PAPERS[0], metadata=argument("paper size", choices=PAPERS))
    force: bool = force_option()


PRINT = Command(
    "print",
    "create PDF sheets at true scale for building a glove",
    deferred("extensions.sheets.command_runs:print_sheets"),
    options=PrintArguments,
)
