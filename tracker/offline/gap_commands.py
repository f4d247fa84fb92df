"""The commands ``gaps`` and ``fill``."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.base.toml_reader import read_text
from tracker.offline.commands import FillArguments, GapsArguments
from tracker.offline.fill import Signature, fill, gap_json
from tracker.session.gaps.fill import FillOptions
from tracker.session.gaps.find import KINDS, Gap, session_gaps


def run_gaps(args: GapsArguments) -> int:
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


def run_fill(args: FillArguments) -> int:
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
