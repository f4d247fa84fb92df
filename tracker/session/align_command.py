"""The sub-command align."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from tracker.base.command import Command
from tracker.base.files import check_target
from tracker.base.terminal import add_json, check_json, finish


def _add_align(command: argparse.ArgumentParser) -> None:
    command.add_argument("first", type=Path, metavar="A", help="reference session")
    command.add_argument("second", type=Path, metavar="B", help="session to align with A")
    command.add_argument(
        "--by",
        choices=("clock", "movement"),
        default="movement",
        help="align by recorded timestamps or by hand movement",
    )
    command.add_argument(
        "-o", "--output", type=Path, metavar="JSON", help="save the result for `compare --align`"
    )
    command.add_argument(
        "--figure", type=Path, metavar="PNG", help="plot both recordings on one time axis"
    )
    add_json(command)


def _align(args: argparse.Namespace) -> int:
    from tracker.session.align import align, draw, keep, read_courses

    files = [args.first, args.second]
    check_json(args, files)
    for path in filter(None, (args.output, args.figure)):
        check_target(path, args.force, files)
    found = align(args.first, args.second, args.by)
    if args.figure is not None:
        draw(args.figure, *read_courses(args.first, args.second), found, args.force)
    if args.output is not None:
        keep(found, args.output, args.force)
    line = f"{args.second.name} starts at {found.offset_s:+.3f} s in {args.first.name}"
    if found.correlation is not None:
        line += (
            f": by movement, correlation {found.correlation:.2f} "
            f"({found.elsewhere:.2f} at other offsets); "
            f"its clock is {-found.clocks_differ_s:+.3f} s ahead"
        )
    finish(args, asdict(found), [f"{line}."], files)
    return 0


ALIGN = Command("align", "find the time offset between two recordings", _align, add=_add_align)
