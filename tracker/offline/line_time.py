"""The line time of a camera, estimated from a recording of a moving hand.

The recording is tracked with several readout times. Markers of a fast hand are nearest to their
predictions with the true one, so that the mean squared residual of all blobs is a parabola about
it. The time offset between camera and glove is estimated in each run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.base.errors import GlovetrackError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.calibration.stereo.files import rig_text
from tracker.engine.pipeline import Pipeline
from tracker.messages import Array, BlobFrame, CameraImuSample, FrameResult, ImuSample
from tracker.offline.commands import LineTimeArguments
from tracker.online.time_offset import Offset
from tracker.session.reader import SessionReader
from tracker.vision.rig import StereoRig, with_readout

Measured = ImuSample | CameraImuSample | BlobFrame
FIRST = np.array([0.0, 0.010, 0.020, 0.030])  # s of readout
STEP = 0.005  # s from the first estimate to the values tried for the second
CAP_PX = 6.0  # of a residual: beyond it a blob is another marker's
SETTLED = 2.0  # s in which the hand is found and its size is learned
BLOCKS = 8  # of the recording, each left out once for the standard deviation
LEAST_RESIDUALS = 200  # in each block


class LineTimeEstimate(NamedTuple):
    """``line_time`` s a row with its standard deviation; the time ``offset`` with it; and the RMS
    residual in px with a global shutter and with this line time."""

    line_time: float
    sd: float
    offset: Offset
    rms_before_px: float
    rms_px: float


class _BlockSums(NamedTuple):
    """Sums of capped squared residuals (px²) and their numbers, by block; the time offset."""

    squares: Array
    number: Array
    offset: Offset

    @property
    def rms(self) -> float:
        return float(np.sqrt(self.squares.sum() / max(self.number.sum(), 1.0)))

    def without(self, block: int) -> float:
        """Mean squared residual of all blocks but one."""
        keep = np.arange(len(self.number)) != block
        return float(self.squares[keep].sum() / max(self.number[keep].sum(), 1.0))


@dataclass(frozen=True)
class LineTimeEstimator:
    """Tracks ``messages`` with the pipeline that ``make`` builds for a rig."""

    make: Callable[[StereoRig], Pipeline]
    rig: StereoRig
    messages: Sequence[Measured]

    def estimate(self, progress: Callable[[float], None] = lambda share: None) -> LineTimeEstimate:
        """Raises GlovetrackError if the recording does not show the line time."""
        runs: dict[float, _BlockSums] = {}

        def run(readout: float) -> _BlockSums:
            if readout not in runs:
                runs[readout] = self._run(readout)
                progress(len(runs) / (len(FIRST) + 3))
            return runs[readout]

        for readout in FIRST:
            run(float(readout))
        coarse = _vertex(FIRST, np.array([run(float(x)).rms ** 2 for x in FIRST]))
        middle = float(np.clip(coarse, STEP, FIRST[-1]))
        near = np.array([middle - STEP, middle, middle + STEP])
        scores = np.array([run(float(x)).rms ** 2 for x in near])
        found = max(_vertex(near, scores), 0.0)
        left_out = [
            _vertex(near, np.array([run(float(x)).without(block) for x in near]))
            for block in range(BLOCKS)
        ]
        spread = np.array(left_out) - np.mean(left_out)
        sd = float(np.sqrt((BLOCKS - 1) / BLOCKS * np.sum(spread**2)))
        if not np.isfinite(found + sd) or found > FIRST[-1] + 3 * STEP:
            raise GlovetrackError(notice("line_time.not_shown"))
        rows = self.rig.left.height - 1
        best = run(float(near[int(np.argmin(scores))]))
        return LineTimeEstimate(found / rows, sd / rows, best.offset, run(0.0).rms, best.rms)

    def _run(self, readout: float) -> _BlockSums:
        pipeline = self.make(with_readout(self.rig, readout))
        squares, count = np.zeros(BLOCKS), np.zeros(BLOCKS)
        begin, end = self.messages[0].t + SETTLED, self.messages[-1].t
        for message in self.messages:
            if isinstance(message, ImuSample):
                pipeline.feed_imu(message)
            elif isinstance(message, CameraImuSample):
                pipeline.feed_camera_imu(message)
            else:
                pipeline.feed_frame(message)
            for result in pipeline.take_results():
                block = int((result.t - begin) / max(end - begin, 1e-9) * BLOCKS)
                if result.t >= begin:
                    _add(result, squares, count, min(block, BLOCKS - 1))
        if count.min() < LEAST_RESIDUALS:
            raise GlovetrackError(notice("line_time.too_short"))
        return _BlockSums(squares, count, pipeline.timing.offset)


def _add(result: FrameResult, squares: Array, count: Array, block: int) -> None:
    """Adds the residuals of an image to the sums of its ``block``."""
    residual = result.residual[np.isfinite(result.residual)]
    squares[block] += float(np.sum(np.minimum(residual**2, CAP_PX**2)))
    count[block] += len(residual)


def _vertex(x: Array, y: Array) -> float:
    """The minimum of the parabola that fits points best; NaN where it has none."""
    a, b, _ = np.polyfit(x, y, 2)
    return float(-b / (2 * a)) if a > 0 else float("nan")


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
