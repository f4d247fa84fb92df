"""``glovetrack fit-glove``."""

from __future__ import annotations

from pathlib import Path

from tracker.base.command import UsageError
from tracker.base.files import check_target, make_folder, name_part, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.glove.library import user_folder
from tracker.offline.commands import FitGloveArguments
from tracker.offline.fit_glove import fit_json, fit_lines, fit_session


def _target(args: FitGloveArguments) -> Path | None:
    if args.target is not None and args.name is not None:
        raise UsageError(notice("fit_glove.both_targets"))
    if args.name is None:
        return args.target
    return user_folder("gloves") / f"{name_part(args.name)}.toml"


def run(args: FitGloveArguments) -> int:
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
