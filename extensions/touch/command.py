"""The command ``touch-test``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import add_json, check_json, finish, progress_line

RULER_MM = (240.0, 280.0)


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


def touch_test(args: argparse.Namespace) -> int:
    """Write the report."""
    from extensions.touch.analyse import analyse
    from extensions.touch.repeated_report import repeated_json, write_repeated
    from extensions.touch.report import as_json, write_report

    if args.ruler is not None and not RULER_MM[0] <= args.ruler <= RULER_MM[1]:
        raise ConfigError(notice("touch.ruler_range"))
    check_json(args, args.sessions)
    ruler = None if args.ruler is None else args.ruler / 1000
    results = [analyse(s, ruler, args.side, progress_line("reading")) for s in args.sessions]
    if len(results) > 1:
        page = write_repeated(results, args.output, args.force, args.sessions)
        found = repeated_json(results)
        finish(args, found, [found["line"], str(page)], [*args.sessions, page])
        return 0
    result = results[0]
    written = write_report(result, args.output, args.force, args.sessions)
    lines = [result.line, *(str(n) for n in result.notices)]
    lines.append(", ".join(str(path) for path in written))
    finish(args, as_json(result), lines, [*args.sessions, *written])
    return 0


TOUCH_TEST = Command(
    "touch-test",
    "report how accurate the fingertips of a recorded touch test are",
    touch_test,
    add=add_touch_test,
)
