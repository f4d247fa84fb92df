"""``glovetrack line-time``."""

from __future__ import annotations

from tracker.base.files import check_target, write_whole
from tracker.base.terminal import check_json, finish, progress_line
from tracker.calibration.stereo.files import rig_text
from tracker.engine.pipeline import Pipeline
from tracker.messages import BlobFrame, CameraImuSample, ImuSample
from tracker.offline.commands import LineTimeArguments
from tracker.offline.line_time import LineTimeEstimator
from tracker.session.reader import SessionReader


def run(args: LineTimeArguments) -> int:
    check_json(args, [args.session])
    if args.target is not None:
        check_target(args.target, args.force, [args.session])
    with SessionReader(args.session) as reader:
        info, rig = reader.info, reader.rig()
        kinds = (ImuSample, CameraImuSample, BlobFrame)
        messages = [m for m in reader.messages(kinds) if isinstance(m, kinds)]
    estimator = LineTimeEstimator(lambda r: Pipeline(info.hand, info.glove, r), rig, messages)
    found = estimator.estimate(progress_line("estimating the line time"))
    us, sd_us = 1e6 * found.line_time, 1e6 * found.sd
    readout_ms = 1e3 * found.line_time * (rig.left.height - 1)
    lines = [
        f"line time      {us:.1f} ± {sd_us:.1f} µs ({readout_ms:.1f} ms per image)",
        f"time offset    {1e3 * found.offset.value:.1f} ± {1e3 * found.offset.sd:.1f} ms",
        f"residual       {found.rms_px:.2f} px; {found.rms_before_px:.2f} px for a global shutter",
    ]
    if args.target is not None:
        text = rig_text(rig, "with an estimated line time", found.line_time)
        write_whole(args.target, text, args.force, [args.session])
        lines.append(f"{args.target}: camera calibration with this line time")
    values = {
        "line_time_us": us,
        "line_time_sd_us": sd_us,
        "readout_ms": readout_ms,
        "time_offset_ms": 1e3 * found.offset.value,
        "time_offset_sd_ms": 1e3 * found.offset.sd,
        "residual_px": found.rms_px,
        "residual_global_px": found.rms_before_px,
    }
    finish(args, values, lines, [args.session])
    return 0
