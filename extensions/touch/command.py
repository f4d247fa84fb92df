"""The command ``touch-test``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.errors import ConfigError
from tracker.base.terminal import add_json, check_json, finish, progress_line

RULER_MM = (240.0, 280.0)


def add_touch_test(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument("session", type=Path, metavar="SESSION", help="session of a touch test")
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="REPORT.html",
        help="the HTML page; a PDF file of the same name is written next to it",
    )
    parser.add_argument(
        "--ruler",
        type=float,
        metavar="MM",
        help="length of the printed line of 260 mm, measured with a ruler (default: what was "
        "entered in the window; else the camera's scale is taken to be right)",
    )
    parser.add_argument("--side", default="", help="left or right, of a session of both hands")
    add_json(parser)


def touch_test(args: argparse.Namespace) -> int:
    """Write the report."""
    from extensions.touch.analyse import analyse
    from extensions.touch.report import as_json, write_report

    if args.ruler is not None and not RULER_MM[0] <= args.ruler <= RULER_MM[1]:
        raise ConfigError("--ruler must be 240 to 280 mm: measure the printed line of 260 mm.")
    check_json(args, [args.session])
    ruler = None if args.ruler is None else args.ruler / 1000
    result = analyse(args.session, ruler, args.side, progress_line("reading"))
    written = write_report(result, args.output, args.force, [args.session])
    lines = [result.line, *(str(n) for n in result.notices)]
    lines.append(", ".join(str(path) for path in written))
    finish(args, as_json(result), lines, [args.session, *written])
    return 0
