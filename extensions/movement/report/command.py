"""The command ``report``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.terminal import add_json, check_json, finish


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


def report(args: argparse.Namespace) -> int:
    """Write the page and the table."""
    from extensions.movement.report.write import as_json, write_report
    from tracker.session.overview import sessions_in

    paths = [path for path, _ in sessions_in(args.sessions)]
    check_json(args, paths)
    takes = write_report(paths, args.output, args.anonymous, args.force)
    finish(args, as_json(takes), [f"{args.output}: {len(takes)} recordings"], [*paths, args.output])
    return 0


REPORT = Command(
    "report", "summarise recordings in one HTML page and one table", report, add=add_report
)
