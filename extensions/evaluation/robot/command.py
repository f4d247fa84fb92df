"""``glovetrack evaluate robot``."""

from __future__ import annotations

from typing import Any

import numpy as np

from extensions.evaluation.commands import EvaluateRobotArguments
from extensions.evaluation.robot.score import tip_score
from extensions.robot.hand import load_hand
from extensions.robot.library import need_mujoco
from extensions.robot.pick_and_place import pick_and_place
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop
from tracker.base.terminal import check_json, finish, progress_line

GOAL_MM = 5.0


def evaluate_robot(args: EvaluateRobotArguments) -> int:
    """Run the trials and print the figures."""
    check_json(args, [])
    need_mujoco()
    settings = RobotSettings(model=args.model, side=args.side)
    robot = load_hand(settings)
    watch = progress_line("evaluating")
    total = max(args.people + args.trials, 1)
    scores = []
    for i in range(args.people):
        scores.append(tip_score(robot, settings, args.seed + i, args.seconds))
        watch((i + 1) / total)
    teleop, times, trials = Teleop(settings, robot), [], []
    for i in range(args.trials):
        trial = pick_and_place(
            teleop, args.seed + i, lambda state, errors, took: times.append(1e3 * took)
        )
        trials.append(trial)
        watch((args.people + i + 1) / total)
    report = _report(scores, trials, times)
    finish(args, report, _lines(report), [])
    return 0


def _report(scores: list[Any], trials: list[Any], times: list[float]) -> dict[str, Any]:
    report: dict[str, Any] = {}
    if scores:
        errors = np.concatenate([s.errors_mm for s in scores])
        reachable = np.concatenate([s.reachable for s in scores])
        near = errors[reachable]
        report["tips"] = {
            "reachable_percent": 100 * float(reachable.mean()),
            "error_mm_median": float(np.median(near)),
            "error_mm_99": float(np.percentile(near, 99)),
            "within_5_mm_percent": 100 * float((near <= GOAL_MM).mean()),
            "all_error_mm_95": float(np.nanpercentile(errors, 95)),
        }
    if trials:
        report["pick_and_place"] = [trial._asdict() for trial in trials]
        report["placed"] = sum(trial.placed for trial in trials)
        report["step_ms_median"] = float(np.median(times))
        report["step_ms_99"] = float(np.percentile(times, 99))
    return report


def _lines(report: dict[str, Any]) -> list[str]:
    lines = []
    tips = report.get("tips")
    if tips:
        lines = [
            f"reachable targets: {tips['reachable_percent']:.1f} %",
            f"tips within {GOAL_MM:.0f} mm of reachable targets: "
            f"{tips['within_5_mm_percent']:.2f} % "
            f"(median {tips['error_mm_median']:.2f} mm, 99 %: {tips['error_mm_99']:.2f} mm)",
        ]
    for trial in report.get("pick_and_place", ()):
        word = "placed" if trial["placed"] else "NOT placed"
        lines.append(f"trial {trial['seed']:>3}: {word}, {trial['off_mm']:.0f} mm from its target")
    if "placed" in report:
        lines.append(
            f"{report['placed']} of {len(report['pick_and_place'])} cubes placed; "
            f"step time {report['step_ms_median']:.2f} ms (99 %: {report['step_ms_99']:.2f} ms)"
        )
    return lines
