"""Runs `glovetrack evaluate inertial`, prints and saves its results."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from extensions.evaluation.commands import EvaluateInertialArguments
from extensions.evaluation.inertial import broad as inertial_broad
from extensions.evaluation.inertial.errors import draw
from extensions.evaluation.inertial.estimators import BETAS, ESTIMATORS
from extensions.evaluation.inertial.experiment import ErrorRow, Plan, crossover, run
from extensions.evaluation.inertial.goals import Goal, goals
from extensions.evaluation.inertial.motion import grasp
from extensions.evaluation.inertial.peers import available
from tracker import GRAVITY
from tracker.base.files import check_folder_target
from tracker.base.terminal import check_json, write_json
from tracker.inertial.finger import Finger
from tracker.inertial.planar import PlanarEstimator, PlanarReadings
from tracker.inertial.segments import SegmentFilters
from tracker.messages import Array


@dataclass(frozen=True, eq=False)
class Report:
    """Results of one evaluation."""

    rows: list[ErrorRow]
    crossover_s: dict[str, float | None]
    cost_us: dict[str, float]
    cost_batch_us: dict[str, float]
    broad: list[inertial_broad.BroadRow]
    goals: list[Goal]


def evaluate_inertial(args: EvaluateInertialArguments) -> int:
    """Run the evaluation, print and save the results selected by the arguments."""
    check_json(args)
    if args.out:
        check_folder_target(args.out, args.force)
    plan = _plan(args)
    paths = inertial_broad.trial_paths(args.broad) if args.broad else []
    report = _measure(plan, paths)
    text = sys.stderr if args.json == "-" else sys.stdout
    print(_text(report, plan), file=text)
    if args.json:
        write_json(to_json(report), args.json, args.force)
    if args.out:
        for path in save_figures(report.rows, Finger(), args.out, plan.rates_hz[0]):
            print(path, file=text)
    return 0


def _plan(args: EvaluateInertialArguments) -> Plan:
    if args.quick:
        quick = Plan.quick(args.seeds or 2)
        return Plan(tuple(args.rates or quick.rates_hz), quick.seeds, 1, quick.durations)
    return Plan(tuple(args.rates or Plan.rates_hz), args.seeds or Plan.seeds)


def _measure(plan: Plan, paths: list[Path]) -> Report:
    rows = run(plan, Finger(), _show_progress)
    broad = inertial_broad.evaluate(paths, inertial_broad.filters())
    cost_us, cost_batch_us = streaming_us(), batch_us()
    crossings = {s: crossover(rows, s, plan.rates_hz[0]) for s in plan.series}
    return Report(rows, crossings, cost_us, cost_batch_us, broad, goals(rows, broad, cost_us))


def _show_progress(share: float, what: str) -> None:
    if sys.stderr.isatty():
        print(f"\r{share:6.1%} {what:<40}", end="" if share < 1 else "\n", file=sys.stderr)


def to_json(report: Report) -> dict[str, Any]:
    """JSON values: ``rows`` are those of the vertical plane, ``conditions`` the others."""
    data = asdict(report)
    data["conditions"] = [r for r in data["rows"] if r["condition"] != "vertical"]
    data["rows"] = [r for r in data["rows"] if r["condition"] == "vertical"]
    data["peers"] = list(available())
    return data


def _text(report: Report, plan: Plan) -> str:
    lines: list[str] = []
    for condition, series, rate_hz in dict.fromkeys(
        (r.condition, r.series, r.rate_hz) for r in report.rows
    ):
        found = [
            r
            for r in report.rows
            if (r.condition, r.series, r.rate_hz) == (condition, series, rate_hz)
        ]
        lines += ["", f"RMS error, °: {condition} plane, errors {series}, {rate_hz:g} Hz"]
        lines += _table(found)
    lines += ["", "Integration and gravity cross at (s)"]
    lines += [
        f"  {s:8s} {t:.2f}" if t else f"  {s:8s} never" for s, t in report.crossover_s.items()
    ]
    return "\n".join([*lines, *_broad_lines(report), *_cost_lines(report), *_goal_lines(report)])


def _table(rows: list[ErrorRow], columns: int = 8) -> list[str]:
    """Table of estimators (rows) and some of the durations (columns)."""
    t_all = sorted({r.t_m for r in rows})
    step = max(1, -(-len(t_all) // columns))
    t_shown = t_all[::step]
    by = {(r.estimator, r.t_m): r.rms_deg for r in rows}
    names = [
        n for n in dict.fromkeys(r.estimator for r in rows) if n in (*ESTIMATORS, *available())
    ]
    head = f"  {'t_m, s':20s}" + "".join(f"{t:10.3g}" for t in t_shown)
    body = [f"  {n:20s}" + "".join(f"{by[n, t]:10.3f}" for t in t_shown) for n in names]
    return [head, *body]


def _broad_lines(report: Report) -> list[str]:
    if not report.broad:
        return []
    lines = ["", "BROAD: RMS of total, heading and inclination error, °"]
    return lines + [
        f"  {r.trial:40s} {r.estimator:15s}"
        f"{r.total_deg:8.2f}{r.heading_deg:8.2f}{r.inclination_deg:8.3f}"
        for r in report.broad
    ]


def _cost_lines(report: Report) -> list[str]:
    lines = ["", "Cost of an update, µs: called from Python, and in a compiled loop"]
    for name, us in report.cost_us.items():
        batch = report.cost_batch_us.get(name)
        lines.append(f"  {name:20s}{us:8.2f}" + (f"{batch:9.3f}" if batch else ""))
    return lines


def _goal_lines(report: Report) -> list[str]:
    lines = ["", "Goals"]
    for g in report.goals:
        mark = "reached" if g.reached else "MISSED "
        lines.append(f"  {mark} {g.what}: {g.measured} (wanted: {g.wanted})")
    return lines


FIGURE_9_T_M = 1.0  # s
_SIZE = (9.0, 6.5)
_TITLES = {"white": "white noise", "offset": "zero offset", "both": "both errors"}


def save_figures(rows: list[ErrorRow], finger: Finger, folder: Path, rate_hz: float) -> list[Path]:
    """Save all figures for which there are rows; returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    made = {f"trajectory_{rate_hz:g}Hz": trajectory(finger, rate_hz)}
    for rate in sorted({r.rate_hz for r in rows}):
        at_rate = [r for r in rows if r.rate_hz == rate and r.condition == "vertical"]
        made[f"rms_{rate:g}Hz"] = rms(at_rate, rate)
        made[f"beta_{rate:g}Hz"] = beta(at_rate, rate)
    return [_save(figure, folder / f"inertial_{name}.png") for name, figure in made.items()]


def _save(figure: Figure, path: Path) -> Path:
    figure.savefig(path, dpi=150)
    return path


def trajectory(finger: Finger, rate_hz: float, t_m: float = FIGURE_9_T_M) -> Figure:
    """Figure 9: angles and rates of the motion at the top, errors of the estimators below."""
    motion = grasp(finger, t_m, rate_hz)
    readings = draw(len(motion.t), "both", rate_hz, (0,)).planar(motion.ideal)
    figure = Figure(_SIZE, layout="constrained")
    axes = figure.subplots(2, 2, sharex=True)
    for k in range(3):
        axes[0, 0].plot(motion.t, np.rad2deg(motion.theta[:, k]), label=f"phalanx {k}")
        axes[0, 1].plot(motion.t, np.rad2deg(motion.omega[:, k]))
    for name, make in ESTIMATORS.items():
        theta = make(finger, 1 / rate_hz).run(readings)
        for k in range(2):
            error = np.rad2deg(theta[:, k] - motion.theta[:, k])
            axes[1, k].plot(motion.t, error, label=name, lw=1)
    labels = ("angle, °", "rate, °/s", "error of phalanx 0, °", "error of phalanx 1, °")
    for ax, label in zip(axes.flat, labels, strict=True):
        ax.set_ylabel(label)
        ax.grid(alpha=0.3)
    for ax in axes[1]:
        ax.set_ylim(-15, 15)
        ax.set_xlabel("time, s")
    axes[0, 0].legend()
    axes[1, 0].legend(fontsize=7, ncols=2)
    figure.suptitle(f"Test motion of {t_m:g} s at {rate_hz:g} Hz, both sensor errors")
    return figure


def rms(rows: list[ErrorRow], rate_hz: float) -> Figure:
    """Figure 10: RMS error as a function of the motion's duration, one panel per series."""
    series = [s for s in _TITLES if any(r.series == s for r in rows)]
    figure = Figure((2.0 + 4.5 * len(series), 5.0), layout="constrained")
    axes = np.atleast_1d(figure.subplots(1, len(series), sharey=True))
    named = [n for n in dict.fromkeys(r.estimator for r in rows) if not _is_variant(n)]
    for ax, s in zip(axes, series, strict=True):
        for i, name in enumerate(named):
            _curve(ax, [r for r in rows if r.series == s and r.estimator == name], name, i)
        _log_axes(ax, _TITLES[s])
    figure.legend(*axes[-1].get_legend_handles_labels(), loc="outside right upper", fontsize=8)
    figure.suptitle(f"RMS error at {rate_hz:g} Hz; bands reach over the seeds")
    return figure


def beta(rows: list[ErrorRow], rate_hz: float) -> Figure:
    """β and the kinematic compensation: noise only on the left, both errors on the right."""
    figure = Figure(_SIZE, layout="constrained")
    axes = figure.subplots(1, 2, sharey=True)
    styles = {"central": "-", "backward": "--", "plain": ":"}
    for ax, s in zip(axes, ("white", "both"), strict=True):
        for i, value in enumerate(BETAS):
            for kind, style in styles.items():
                name = f"madgwick_{kind}_{value:g}"
                found = [r for r in rows if r.series == s and r.estimator == name]
                _curve(ax, found, f"β {value:g}, {kind}", i, style)
        _log_axes(ax, _TITLES[s])
    axes[0].legend(fontsize=7)
    figure.suptitle(f"Madgwick filter at {rate_hz:g} Hz: β and compensation")
    return figure


def _is_variant(name: str) -> bool:
    return name.split("_")[-1] in {f"{b:g}" for b in BETAS}


def _curve(ax: Axes, rows: list[ErrorRow], label: str, colour: int, style: str = "-") -> None:
    found = sorted(rows, key=lambda r: r.t_m)
    if not found:
        return
    t_m = [r.t_m for r in found]
    shade = mpl.color_sequences["tab20"][2 * colour % 20 + (2 * colour) // 20]
    ax.plot(t_m, [r.rms_deg for r in found], style, color=shade, label=label, lw=1.2)
    low, high = [r.low_deg for r in found], [r.high_deg for r in found]
    ax.fill_between(t_m, low, high, color=shade, alpha=0.12, lw=0)


def _log_axes(ax: Axes, title: str) -> None:
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_title(title)
    ax.set_xlabel("duration of the motion, s")
    ax.set_ylabel("RMS error, °")
    ax.grid(alpha=0.3, which="both")


def evaluate_inertial_command(args: EvaluateInertialArguments) -> int:
    """Run the evaluation; imports numba and matplotlib only now."""
    return evaluate_inertial(args)


# ---- measures the cost of one update in interleaved rounds
#
# Streaming is the cost in a live glove: one call from Python per sample. Batch is the arithmetic
# alone: the time of `run` divided by the number of samples. Both are medians over the rounds.

GLOVE = 7  # IMUs
DT = 0.01
ROUNDS, UPDATES = 9, 1000

Job = Callable[[], object]


def streaming_us() -> dict[str, float]:
    """µs per update: two sensors of a finger for the planar estimators, otherwise seven IMUs."""
    finger = Finger()
    readings = _readings(finger, 1.0)
    jobs = {name: _update(make(finger, DT), readings) for name, make in ESTIMATORS.items()}
    gyro, accel = _glove_sample()
    jobs["segments_7"] = _segments(gyro, accel)
    if "vqf" in available():
        jobs["vqf_7"] = _vqf(gyro, accel)
    return _medians(jobs, UPDATES)


def batch_us() -> dict[str, float]:
    """µs per sample of two sensors of a finger, without the calls from Python."""
    finger = Finger()
    readings = _readings(finger, 100.0)
    jobs = {name: _batch(make(finger, DT), readings) for name, make in ESTIMATORS.items()}
    n = len(readings.root)
    return {name: us / n for name, us in _medians(jobs, 1).items()}


def _medians(jobs: dict[str, Job], updates: int) -> dict[str, float]:
    for job in jobs.values():
        job()  # compiles
    times: dict[str, list[float]] = {name: [] for name in jobs}
    for _ in range(ROUNDS):
        for name, job in jobs.items():
            start = time.perf_counter()
            for _ in range(updates):
                job()
            times[name].append((time.perf_counter() - start) / updates * 1e6)
    return {name: float(np.median(values)) for name, values in times.items()}


def _readings(finger: Finger, t_m: float) -> PlanarReadings:
    motion = grasp(finger, t_m, 1 / DT)
    return draw(len(motion.t), "both", 1 / DT, (0,)).planar(motion.ideal)


def _update(estimator: PlanarEstimator, readings: PlanarReadings) -> Job:
    gyro, accel = readings.gyro[0].copy(), readings.accel[0].copy()
    root = complex(readings.root[0])
    return lambda: estimator.update(gyro, accel, root)


def _batch(estimator: PlanarEstimator, readings: PlanarReadings) -> Job:
    return lambda: estimator.run(readings)


def _glove_sample() -> tuple[Array, Array]:
    rng = np.random.default_rng(0)
    accel = np.tile([0.0, 0.0, GRAVITY], (GLOVE, 1)) + 0.1 * rng.standard_normal((GLOVE, 3))
    return 0.1 * rng.standard_normal((GLOVE, 3)), accel


def _segments(gyro: Array, accel: Array) -> Job:
    filters = SegmentFilters(GLOVE, DT)
    return lambda: filters.update(gyro, accel)


def _vqf(gyro: Array, accel: Array) -> Job:
    """Seven VQF filters; rows are extracted beforehand, in the peer's favour."""
    from vqf import VQF  # deferred: an extra

    filters = [VQF(DT) for _ in range(GLOVE)]
    rows = [(f, g.copy(), a.copy()) for f, g, a in zip(filters, gyro, accel, strict=True)]

    def job() -> None:
        for f, g, a in rows:
            f.update(g, a)

    return job
