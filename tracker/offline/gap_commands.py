"""The commands ``gaps`` and ``fill``."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.base.command import Command
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.terminal import add_json, check_json, finish, progress_line

if TYPE_CHECKING:
    from tracker.session.gaps.find import Gap


def _add_gaps(gaps: argparse.ArgumentParser) -> None:
    gaps.add_argument("source", type=Path, metavar="SESSION", help="session file")
    _add_limit(gaps)
    add_json(gaps)


def _add_fill(fill: argparse.ArgumentParser) -> None:
    fill.add_argument("source", type=Path, metavar="SESSION", help="session file")
    fill.add_argument("-o", "--out", type=Path, required=True, help="the new session")
    fill.add_argument(
        "--max-gap", type=float, default=0.2, metavar="S", help="longest gap to fill (default: 0.2)"
    )
    fill.add_argument(
        "--method",
        default="linear",
        choices=("linear", "cubic", "smooth"),
        help="linear: straight lines and great arcs; cubic: also matches the speeds at both "
        "ends; smooth: tracks the session's sensor data again and smooths the result",
    )
    fill.add_argument(
        "--kinds",
        default="hole,lost",
        metavar="A,B",
        help="kinds of gaps to fill: hole (no estimates), lost, inferred (default: hole,lost)",
    )
    fill.add_argument(
        "--gaps",
        type=Path,
        metavar="FILE",
        help="fill only gaps listed in this output of `gaps --json`",
    )
    fill.add_argument(
        "--by", default="", metavar="NAME", help="name of the editor (default: the current user)"
    )
    _add_limit(fill)
    add_json(fill)


def _add_limit(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--inferred",
        type=float,
        default=0.5,
        metavar="S",
        help="treat points inferred for longer than this as gaps (default: 0.5)",
    )


def _gaps(args: argparse.Namespace) -> int:
    from tracker.offline.fill import gap_json
    from tracker.session.gaps.find import session_gaps

    check_json(args, [args.source])
    found = session_gaps(args.source, args.inferred, progress_line("reading"))
    lines = [_line(gap) for gap in found]
    lines.append(f"{len(found)} gaps, of which {sum(g.fillable for g in found)} can be filled")
    finish(args, {"gaps": [gap_json(gap) for gap in found]}, lines, [args.source])
    return 0


def _line(gap: Gap) -> str:
    where = f"{gap.side} {gap.part} ({len(gap.keypoints)} keypoints)"
    end = "" if gap.fillable else ", cannot be filled"
    return (
        f"{gap.number:4d}  {gap.start:9.3f} s  {gap.length:8.3f} s  {gap.kind:8s}  "
        f"{where}: {gap.cause}{end}"
    )


def _fill(args: argparse.Namespace) -> int:
    from tracker.offline.fill import Signature, fill
    from tracker.session.gaps.fill import FillOptions
    from tracker.session.gaps.find import KINDS

    check_json(args, [args.source, args.out])
    wanted = None if args.gaps is None else read_gaps(args.gaps)
    kinds = KINDS if wanted is not None else tuple(k for k in args.kinds.split(",") if k)
    options = FillOptions(args.method, args.max_gap, kinds)
    watch = progress_line("filling")
    signature = Signature.now(args.by)
    report = fill(
        args.source, args.out, options, signature, wanted, args.inferred, watch, args.force
    )
    lines = [f"{args.out}: {report.summary}."]
    lines += [f"  not filled, {left.why}: {_line(left.gap).strip()}" for left in report.left]
    finish(args, report.to_json(), lines, [args.source, args.out])
    return 0


def read_gaps(path: Path) -> Sequence[Gap]:
    """A list that `gaps --json` wrote. Raises FileError for another file."""
    from tracker.base.toml_reader import read_text
    from tracker.session.gaps.find import Gap

    names = Gap.__dataclass_fields__
    try:
        content = json.loads(read_text(path))
        rows = content["gaps"] if isinstance(content, dict) else content
        return [
            Gap(**{n: row[n] for n in names} | {"keypoints": tuple(row["keypoints"])})
            for row in rows
        ]
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise FileError(notice("gaps.not_list", path=path)) from error


GAPS = Command("gaps", "list where and why a hand is not measured", _gaps, add=_add_gaps)
FILL = Command(
    "fill",
    "interpolate gaps of a session and save the result as a new session",
    _fill,
    add=_add_fill,
)
