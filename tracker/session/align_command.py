"""The sub-command align."""

from __future__ import annotations

from dataclasses import asdict

from tracker.base.files import check_target
from tracker.base.terminal import check_json, finish
from tracker.session.align import align, draw, keep, read_courses
from tracker.session.commands import AlignArguments


def run_align(args: AlignArguments) -> int:
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
