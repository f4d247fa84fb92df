"""Runs `glovetrack evaluate inertial`, prints and saves its results."""

from __future__ import annotations

import argparse
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from extensions.evaluation.inertial import broad as inertial_broad
from extensions.evaluation.inertial import cost as inertial_cost
from extensions.evaluation.inertial.estimators import ESTIMATORS
from extensions.evaluation.inertial.experiment import ErrorRow, Plan, crossover, run
from extensions.evaluation.inertial.goals import Goal, goals
from extensions.evaluation.inertial.peers import available
from tracker.base.files import check_folder_target
from tracker.base.terminal import check_json, write_json
from tracker.inertial.finger import Finger


@dataclass(frozen=True, eq=False)
class Report:
    """Results of one evaluation."""

    rows: list[ErrorRow]
    crossover_s: dict[str, float | None]
    cost_us: dict[str, float]
    cost_batch_us: dict[str, float]
    broad: list[inertial_broad.BroadRow]
    goals: list[Goal]


def evaluate_inertial(args: argparse.Namespace) -> int:
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
        from extensions.evaluation.inertial.figures import save_figures

        for path in save_figures(report.rows, Finger(), args.out, plan.rates_hz[0]):
            print(path, file=text)
    return 0


def _plan(args: argparse.Namespace) -> Plan:
    if args.quick:
        quick = Plan.quick(args.seeds or 2)
        return Plan(tuple(args.rates or quick.rates_hz), quick.seeds, 1, quick.durations)
    return Plan(tuple(args.rates or Plan.rates_hz), args.seeds or Plan.seeds)


def _measure(plan: Plan, paths: list[Path]) -> Report:
    rows = run(plan, Finger(), _show_progress)
    broad = inertial_broad.evaluate(paths, inertial_broad.filters())
    cost_us, batch_us = inertial_cost.streaming_us(), inertial_cost.batch_us()
    crossings = {s: crossover(rows, s, plan.rates_hz[0]) for s in plan.series}
    return Report(rows, crossings, cost_us, batch_us, broad, goals(rows, broad, cost_us))


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
