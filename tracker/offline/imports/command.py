"""The command ``import``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.terminal import add_json, check_json, finish


def _add_import(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "sources", type=Path, nargs="+", metavar="IN", help="CSV or .mat files, or x-IMU3 folders"
    )
    parser.add_argument("-o", "--out", type=Path, required=True, help="the new session (.mcap)")
    parser.add_argument("--glove", default="", help="glove name or file")
    parser.add_argument(
        "--hand", default="", help="hand name or file (default: the hand of the glove file)"
    )
    parser.add_argument(
        "--imu",
        action="append",
        default=[],
        metavar="GLOVE=FILE",
        help="assign a file to an IMU of the glove, such as dorsum=hand_right; can be repeated",
    )
    add_json(parser)


def _import(args: argparse.Namespace) -> int:
    from tracker.offline.imports.run import ImportOptions, import_imus

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


IMPORT = Command(
    "import",
    "create a session from another program's raw IMU data",
    _import,
    add=_add_import,
)
