"""``glovetrack fit-glove``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command, UsageError
from tracker.base.files import check_target, make_folder, name_part, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import add_json, check_json, finish, progress_line


def _add(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "session",
        type=Path,
        metavar="SESSION",
        help="recording of the glove alone in free motion, two minutes",
    )
    parser.add_argument(
        "--set", type=Path, metavar="OUT", dest="target", help="write the fitted glove file"
    )
    parser.add_argument(
        "--name", metavar="NAME", help="save it as your own glove NAME, for --glove NAME"
    )
    add_json(parser)


def _target(args: argparse.Namespace) -> Path | None:
    from tracker.glove.library import user_folder

    if args.target is not None and args.name is not None:
        raise UsageError(notice("fit_glove.both_targets"))
    if args.name is None:
        return args.target
    return user_folder("gloves") / f"{name_part(args.name)}.toml"


def _run(args: argparse.Namespace) -> int:
    from tracker.offline.fit_glove import fit_json, fit_lines, fit_session

    target, inputs = _target(args), [args.session]
    check_json(args, inputs)
    if target is not None:
        if args.name is not None:
            make_folder(target.parent)
        check_target(target, args.force, inputs)
    found = fit_session(args.session, progress_line("tracking the glove"))
    lines = fit_lines(found)
    if target is not None:
        write_whole(target, found.text, args.force, inputs)
        lines.append(f"{target}: the glove file, fitted")
    finish(args, dict(fit_json(found)), lines, inputs)
    return 0


FIT_GLOVE = Command[argparse.Namespace](
    "fit-glove",
    "fit a glove file to a glove: marker positions and IMU mountings",
    _run,
    add=_add,
    description="Measures from a recording of free motion where the markers and IMUs of this "
    "glove are, with standard deviations, and writes a copy of its glove file. Record one hand in "
    "front of a stereo camera for two minutes: bend and stretch all fingers and the thumb, and "
    "show the hand from all sides.",
)
