"""``glovetrack imu-noise``."""

from __future__ import annotations

from tracker.base.command import UsageError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.glove.imu_values import with_noise
from tracker.offline.commands import ImuNoiseArguments
from tracker.offline.imu_noise import imu_noise
from tracker.session.raw_imu import read_raw_imu
from tracker.session.reader import SessionReader


def run(args: ImuNoiseArguments) -> int:
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
    if args.glove is not None and args.target is not None:
        text = args.glove.read_text("utf-8")
        noise = {imu.name: imu.noise for imu in report.imus}
        write_whole(args.target, with_noise(text, noise), args.force, inputs)
        lines.append(f"{args.target}: noise of {len(noise)} IMUs")
    finish(args, report.as_json(), lines, inputs)
    return 0
