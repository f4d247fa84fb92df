"""``glovetrack imu-noise``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command, UsageError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import add_json, check_json, finish


def _add(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "session",
        type=Path,
        metavar="SESSION",
        help="recording of a glove at rest, 1 minute or more",
    )
    parser.add_argument(
        "-o", "--out", type=Path, metavar="CSV", help="write the Allan deviations as a table"
    )
    parser.add_argument(
        "--glove", type=Path, metavar="FILE", help="glove file to start from (with --set)"
    )
    parser.add_argument(
        "--set", type=Path, metavar="OUT", dest="target", help="write a copy of it with the noise"
    )
    add_json(parser)


def _run(args: argparse.Namespace) -> int:
    from tracker.glove.imu_values import with_noise
    from tracker.offline.imu_noise import imu_noise
    from tracker.session.raw_imu import read_raw_imu
    from tracker.session.reader import SessionReader

    if (args.glove is None) != (args.target is None):
        raise UsageError(notice("option.together", options=("--glove", "--set")))
    inputs = [path for path in (args.session, args.glove) if path is not None]
    check_json(args, inputs)
    for path in (args.out, args.target):
        if path is not None:
            check_target(path, args.force, inputs)
    with SessionReader(args.session) as reader:
        report = imu_noise(read_raw_imu(reader))
    lines = report.lines()
    if args.out is not None:
        names, rows = report.table()
        table = [",".join(names), *(",".join(f"{x:.6g}" for x in row) for row in rows)]
        write_whole(args.out, "\n".join(table) + "\n", args.force, inputs)
    if args.target is not None:
        text = args.glove.read_text("utf-8")
        noise = {imu.name: imu.noise for imu in report.imus}
        write_whole(args.target, with_noise(text, noise), args.force, inputs)
        lines.append(f"{args.target}: noise of {len(noise)} IMUs")
    finish(args, report.as_json(), lines, inputs)
    return 0


IMU_NOISE = Command[argparse.Namespace](
    "imu-noise",
    "measure the noise of a glove's IMUs from a recording at rest",
    _run,
    add=_add,
    description="Computes the Allan deviation of the longest rest in a recording, fits white "
    "noise, bias instability and random walk, and can write them into a glove file. A recording of "
    "ten minutes on a table gives the bias instability to about 20 percent.",
)
