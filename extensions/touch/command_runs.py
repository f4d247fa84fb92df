"""The command ``touch-test``."""

from __future__ import annotations

from extensions.touch.analyse import analyse
from extensions.touch.command import TouchTestArguments
from extensions.touch.repeated_report import repeated_json, write_repeated
from extensions.touch.report import as_json, write_report
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line

RULER_MM = (240.0, 280.0)


def touch_test(args: TouchTestArguments) -> int:
    """Write the report."""
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
