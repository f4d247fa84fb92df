"""The command ``report``."""

from __future__ import annotations

from extensions.movement.commands import ReportArguments
from extensions.movement.report.write import as_json, write_report
from tracker.base.terminal import check_json, finish
from tracker.session.overview import sessions_in


def report(args: ReportArguments) -> int:
    """Write the page and the table."""
    paths = [path for path, _ in sessions_in(args.sessions)]
    check_json(args, paths)
    rows = write_report(paths, args.output, args.anonymous, args.force)
    finish(args, as_json(rows), [f"{args.output}: {len(rows)} recordings"], [*paths, args.output])
    return 0
