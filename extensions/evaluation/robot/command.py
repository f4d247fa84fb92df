"""``glovetrack evaluate robot``.

Whether a target is reachable is determined by the same search from many initial poses without a
speed limit: if none comes within `REACHED`, the robot's fingers are too short or bend differently.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.commands import EvaluateRobotArguments
from extensions.robot.hand import RobotHand, load_hand
from extensions.robot.library import need_mujoco
from extensions.robot.pick_and_place import hand_at, pick_and_place, wearer_model
from extensions.robot.retarget import Retargeter
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop, target_map
from tracker.base.clock import monotonic
from tracker.base.terminal import check_json, finish, progress_line
from tracker.messages import Array
from tracker.simulation.motion import Poses
from tracker.simulation.random_postures import RandomPostures

PACKET = 0.01  # s
REACHED = 0.002  # m
BEGINNINGS = 25  # initial poses per target
EVERY = 10  # hands between two that are checked for reachability


class TipScore(NamedTuple):
    """Score of one wearer: errors_mm (n, 5) of tips, reachable (n, 5), times_ms (n,) per step."""

    errors_mm: Array
    reachable: NDArray[np.bool_]
    times_ms: Array


def tip_score(robot: RobotHand, settings: RobotSettings, seed: int, seconds: float) -> TipScore:
    """Score of a wearer who moves at random for ``seconds``."""
    hand = wearer_model(settings.side)
    t = np.arange(0.0, seconds, PACKET)
    poses = RandomPostures(hand, seed, duration=seconds + 1.0).poses(t)
    fingers, mapped = Retargeter(robot, settings.joint_speed), target_map(robot, 1.0)
    errors, reachable, times = [], [], []
    for k in range(len(t)):
        wearer = hand_at(hand, Poses(*(part[k] for part in poses)), float(t[k]))
        targets, known = mapped.targets(wearer)
        began = monotonic()
        command = fingers.step(targets, known, PACKET)
        times.append(1e3 * (monotonic() - began))
        if k % EVERY == EVERY - 1:
            errors.append(1e3 * np.linalg.norm(fingers.tips(command) - targets, axis=1))
            reachable.append(_reachable(robot, targets, known, command))
    return TipScore(np.array(errors), np.array(reachable), np.array(times))


def _reachable(
    robot: RobotHand, targets: Array, known: NDArray[np.bool_], near: Array
) -> NDArray[np.bool_]:
    """(5,) whether a posture within the joint limits reaches each target."""
    free = Retargeter(robot, joint_speed=1e6)
    free.reset(near)
    best = np.full(len(targets), np.inf)
    for _ in range(BEGINNINGS):
        free.step(targets, known, PACKET)
        best = np.fmin(best, free.error)
        if (best < REACHED).all():
            break
    return np.asarray(best < REACHED)


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
