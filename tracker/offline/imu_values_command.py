"""``glovetrack imu-axes`` and ``glovetrack imu-drift``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from tracker.base.command import UsageError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.glove import library
from tracker.glove.imu_values import with_axes, with_drift
from tracker.glove.model import GloveModel
from tracker.offline.commands import ImuAxesArguments, ImuDriftArguments
from tracker.offline.imu_values import axes_json, axes_lines, axes_of, drift_lines, drift_of
from tracker.session.reader import SessionReader


def _check(args: ImuAxesArguments | ImuDriftArguments, sessions: Sequence[Path]) -> list[Path]:
    """Returns the files that are read."""
    if (args.glove is None) != (args.target is None):
        raise UsageError(notice("option.together", options=("--glove", "--set")))
    inputs = [*sessions, *([args.glove] if args.glove is not None else [])]
    check_json(args, inputs)
    if args.target is not None:
        check_target(args.target, args.force, inputs)
    return inputs


def _write(
    args: ImuAxesArguments | ImuDriftArguments, change: Callable[[str], str], inputs: list[Path]
) -> bool:
    """Writes a changed copy of the glove file; returns False if none is wanted."""
    if args.glove is None or args.target is None:
        return False
    write_whole(args.target, change(args.glove.read_text("utf-8")), args.force, inputs)
    return True


def run_axes(args: ImuAxesArguments) -> int:
    inputs = _check(args, [args.session])
    found, results = axes_of(args.session)
    lines = axes_lines(found, results)
    axes = {name: r.axes for name, r in results.items()}
    if _write(args, lambda text: with_axes(text, axes), inputs):
        lines.append(f"{args.target}: axes of {len(axes)} IMUs")
    finish(args, {"imus": axes_json(results), "rests": len(found.rests)}, lines, inputs)
    return 0


def run_drift(args: ImuDriftArguments) -> int:
    inputs = _check(args, args.sessions)
    glove = _glove_of(args)
    drift, span_c = drift_of(args.sessions, {imu.name: imu.drift for imu in glove.imus})
    lines = drift_lines(drift, span_c)
    if _write(args, lambda text: with_drift(text, drift), inputs):
        lines.append(f"{args.target}: drift of {len(drift)} IMUs")
    imus = {
        name: {key: getattr(d, key).tolist() for key in ("gyro", "gyro_sd", "accel", "accel_sd")}
        for name, d in drift.items()
    }
    finish(args, {"imus": imus, "temperature_span_c": span_c}, lines, inputs)
    return 0


def _glove_of(args: ImuDriftArguments) -> GloveModel:
    """The glove to be completed, or that of the first session."""
    if args.glove is not None:
        return library.load(str(args.glove))[1]
    with SessionReader(args.sessions[0]) as reader:
        return reader.info.glove
