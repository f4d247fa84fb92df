"""Values of a glove's IMUs from recordings: corrections of axes, and drift with temperature."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tracker.base.command import UsageError
from tracker.base.errors import FileError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.calibration.imu_axes import FEWEST, AxesResult, RestFinder, fit_axes
from tracker.calibration.imu_drift import Rests, fit_drift, rests_of
from tracker.glove import library
from tracker.glove.imu_values import with_axes, with_drift
from tracker.glove.model import GloveModel, ImuDrift
from tracker.messages import Array, ImuSample, Status
from tracker.offline.commands import ImuAxesArguments, ImuDriftArguments
from tracker.session.reader import SessionReader


def axes_of(path: Path) -> tuple[RestFinder, dict[str, AxesResult]]:
    """Results of the IMUs of a recording, by name; raises FileError if it has too few rests."""
    found = RestFinder()
    with SessionReader(path) as reader:
        names = reader.info.glove.imu_names
        for message in reader.messages([ImuSample]):
            if isinstance(message, ImuSample):
                found.add(message)
    results = {name: fit_axes(found, j) for j, name in enumerate(names)}
    known = {name: result for name, result in results.items() if result is not None}
    if not known:
        raise FileError(notice("imu_axes.few_rests", rests=len(found.rests), fewest=FEWEST))
    return found, known


class Warmth(NamedTuple):
    """What a recording has on the temperatures of its IMUs: t (N,) s, celsius (N, n), gyro and
    accel (N, n, 3)."""

    t: Array
    celsius: Array
    gyro: Array
    accel: Array


def warmth_of(path: Path) -> tuple[tuple[str, ...], Warmth]:
    """Names of the IMUs, and packets with the temperature that was known last.

    Raises FileError if the recording has no temperatures.
    """
    with SessionReader(path) as reader:
        names = reader.info.glove.imu_names
        found = [m for m in reader.messages([ImuSample]) if isinstance(m, ImuSample)]
        by_status = [m for m in reader.messages([Status]) if isinstance(m, Status)]
    found.sort(key=lambda m: m.t)
    measured = [(m.t, m.temperature) for m in found if m.temperature is not None]
    measured = measured or _of_status(by_status, len(names))
    if not measured:
        raise FileError(notice("imu_drift.no_temperatures", path=path))
    t = np.array([m.t for m in found])
    at, rows = np.array([a for a, _ in measured]), np.array([row for _, row in measured])
    celsius = np.stack([np.interp(t, at, column) for column in rows.T], axis=1)
    gyro, accel = (np.array([getattr(m, name) for m in found]) for name in ("gyro", "accel"))
    return names, Warmth(t, celsius, gyro, accel)


def _of_status(statuses: Sequence[Status], n: int) -> list[tuple[float, Array]]:
    """Temperatures in recordings that have them in the status only."""
    keys = [f"imu_{j}_temperature_c" for j in range(n)]
    return [
        (s.t, np.array([s.values.get(key, np.nan) for key in keys]))
        for s in statuses
        if any(key in s.values for key in keys)
    ]


def drift_of(
    paths: Sequence[Path], before: Mapping[str, ImuDrift | None]
) -> tuple[dict[str, ImuDrift], float]:
    """Drift of the IMUs by name, and the range of temperatures at rest, °C; ``before`` are earlier
    results. Raises FileError if no recording has a rest with known temperatures."""
    rests: dict[str, list[Rests]] = {name: [] for name in before}
    for path in paths:
        names, warmth = warmth_of(path)
        for j, name in enumerate(names):
            if name not in rests:
                raise FileError(notice("imu_drift.other_glove", path=path, imu=name))
            one = warmth.t, warmth.celsius[:, j], warmth.gyro[:, j], warmth.accel[:, j]
            rests[name].append(rests_of(*one))
    celsius = np.concatenate([r.celsius for some in rests.values() for r in some])
    if not len(celsius):
        raise FileError(notice("imu_drift.no_rest"))
    fits = {name: fit_drift(some, before[name]) for name, some in rests.items()}
    found = {name: fit for name, fit in fits.items() if fit is not None}
    return found, float(celsius.max() - celsius.min())


def axes_json(results: Mapping[str, AxesResult]) -> dict[str, Any]:
    """For ``--json``: matrices row by row."""
    return {
        name: {
            "gyro": r.axes.gyro.tolist(),
            "gyro_sd": r.gyro_sd.tolist(),
            "accel": r.axes.accel.tolist(),
            "accel_sd": r.accel_sd.tolist(),
            "misfit": r.misfit,
        }
        for name, r in results.items()
    }


def axes_lines(found: RestFinder, results: Mapping[str, AxesResult]) -> list[str]:
    """A table for people."""
    out = [
        f"{len(found.rests)} rests in {found.positions()} positions. Largest corrections, percent:",
        f"{'IMU':20}{'gyro scale':>12}{'axes':>8}{'±':>7}{'accel scale':>13}{'axes':>8}{'±':>7}",
    ]
    for name, r in results.items():
        cells = [*_largest(r.axes.gyro, r.gyro_sd), *_largest(r.axes.accel, r.accel_sd)]
        out.append(
            f"{name:20}" + "".join(f"{c:{w}.2f}" for c, w in zip(cells, _WIDTHS, strict=True))
        )
    return out


_WIDTHS = (12, 8, 7, 13, 8, 7)


def _largest(matrix: Array, sd: Array) -> tuple[float, float, float]:
    """Percent: scale and cross-axis correction, and standard deviation."""
    error = 100 * np.abs(matrix - np.eye(3))
    scale = float(np.diag(error).max())
    return scale, float((error - np.diag(np.diag(error))).max()), float(100 * sd.max())


def drift_lines(drift: Mapping[str, ImuDrift], span_c: float) -> list[str]:
    """A table for people."""
    out = [
        f"Temperatures at rest within {span_c:.1f} °C. Drift of x, y, z in °/s/°C and mg/°C:",
    ]
    for name, d in drift.items():
        gyro = ", ".join(
            f"{x:+.3f} ± {sd:.3f}"
            for x, sd in zip(np.rad2deg(d.gyro), np.rad2deg(d.gyro_sd), strict=True)
        )
        accel = ", ".join(f"{1e3 * x / 9.80665:+.2f}" for x in d.accel)
        out.append(f"{name:20} {gyro}   {accel}")
    return out


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
