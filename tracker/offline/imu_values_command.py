"""``glovetrack imu-axes`` and ``glovetrack imu-drift``."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.base.command import Command, UsageError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import add_json, check_json, finish

if TYPE_CHECKING:
    from tracker.glove.model import GloveModel


def _add_axes(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "session", type=Path, metavar="SESSION", help="recording of a glove at rest in 6 positions"
    )
    _add_files(parser)


def _add_drift(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "sessions",
        type=Path,
        nargs="+",
        metavar="SESSION",
        help="recordings with temperatures, each with rests of three seconds or more",
    )
    _add_files(parser)


def _add_files(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--glove", type=Path, metavar="FILE", help="glove file to start from (with --set)"
    )
    parser.add_argument(
        "--set", type=Path, metavar="OUT", dest="target", help="write a copy of it with the result"
    )
    add_json(parser)


def _check(args: argparse.Namespace, sessions: list[Path]) -> list[Path]:
    """Returns the files that are read."""
    if (args.glove is None) != (args.target is None):
        raise UsageError(notice("option.together", options=("--glove", "--set")))
    inputs = [*sessions, *([args.glove] if args.glove is not None else [])]
    check_json(args, inputs)
    if args.target is not None:
        check_target(args.target, args.force, inputs)
    return inputs


def _write(args: argparse.Namespace, change: Callable[[str], str], inputs: list[Path]) -> None:
    text = change(args.glove.read_text("utf-8"))
    write_whole(args.target, text, args.force, inputs)


def _axes(args: argparse.Namespace) -> int:
    from tracker.glove.imu_values import with_axes
    from tracker.offline.imu_values import axes_json, axes_lines, axes_of

    inputs = _check(args, [args.session])
    found, results = axes_of(args.session)
    lines = axes_lines(found, results)
    if args.target is not None:
        axes = {name: r.axes for name, r in results.items()}
        _write(args, lambda text: with_axes(text, axes), inputs)
        lines.append(f"{args.target}: axes of {len(axes)} IMUs")
    finish(args, {"imus": axes_json(results), "rests": len(found.rests)}, lines, inputs)
    return 0


def _drift(args: argparse.Namespace) -> int:
    from tracker.glove.imu_values import with_drift
    from tracker.offline.imu_values import drift_lines, drift_of

    inputs = _check(args, args.sessions)
    glove = _glove_of(args)
    drift, span_c = drift_of(args.sessions, {imu.name: imu.drift for imu in glove.imus})
    lines = drift_lines(drift, span_c)
    if args.target is not None:
        _write(args, lambda text: with_drift(text, drift), inputs)
        lines.append(f"{args.target}: drift of {len(drift)} IMUs")
    imus = {
        name: {key: getattr(d, key).tolist() for key in ("gyro", "gyro_sd", "accel", "accel_sd")}
        for name, d in drift.items()
    }
    finish(args, {"imus": imus, "temperature_span_c": span_c}, lines, inputs)
    return 0


def _glove_of(args: argparse.Namespace) -> GloveModel:
    """The glove to be completed, or that of the first session."""
    from tracker.glove import library
    from tracker.session.reader import SessionReader

    if args.glove is not None:
        return library.load(str(args.glove))[1]
    with SessionReader(args.sessions[0]) as reader:
        return reader.info.glove


IMU_AXES = Command[argparse.Namespace](
    "imu-axes",
    "estimate scale and cross-axis errors of a glove's IMUs from rests in several positions",
    _axes,
    add=_add_axes,
    description="Fasten the glove to a box, record, and lay the box on each of its six sides and "
    "on some edges, with two seconds of rest each. Gravity gives the accelerometers' errors, and "
    "the rotations between the rests those of the gyroscopes.",
)
IMU_DRIFT = Command[argparse.Namespace](
    "imu-drift",
    "learn how the biases of a glove's IMUs change with the temperature",
    _drift,
    add=_add_drift,
    description="Uses the rests in recordings of a glove that reports its temperatures (firmware "
    "1.3). Earlier results in the glove file are improved by further recordings.",
)
