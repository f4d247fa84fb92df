"""The command ``import``."""

from __future__ import annotations

from tracker.base.terminal import check_json, finish
from tracker.offline.commands import ImportArguments
from tracker.offline.imports.run import ImportOptions, import_imus


def run_import(args: ImportArguments) -> int:
    check_json(args, args.sources)
    pairs = [word.partition("=") for word in args.imu]
    options = ImportOptions(args.glove, args.hand, {imu: name for imu, _, name in pairs})
    report = import_imus(args.sources, args.out, options, args.force)
    lines = [
        f"{args.out}: {report['packets']} packets at {report['rate_hz']:.0f} Hz, "
        f"{report['duration_s']:.1f} s, of {', '.join(report['imus'].values())}.",
        *report["doubts"],
    ]
    finish(args, report, lines, [*args.sources, args.out])
    return 0
