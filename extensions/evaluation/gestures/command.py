"""``glovetrack evaluate gestures``."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np

from extensions.evaluation.commands import EvaluateGesturesArguments
from extensions.evaluation.gestures.recorded import score_recorded, together
from extensions.evaluation.gestures.score import GestureScore, Held, score
from tracker.base.terminal import check_json, finish, progress_line


def evaluate_gestures(args: EvaluateGesturesArguments) -> int:
    """Score gesture recognition and print the result."""
    check_json(args, args.motion)
    if args.motion:
        return _evaluate_recorded(args)
    watch = progress_line("evaluating")
    scores = []
    for i in range(args.people):
        scores.append(score(args.seed + i, args.seconds, args.on_truth, args.glove))
        watch((i + 1) / args.people)
    report = _report(scores)
    finish(args, report, _lines(report), [])
    return 0


def _evaluate_recorded(args: EvaluateGesturesArguments) -> int:
    watch = progress_line("evaluating")
    scores = []
    for i, path in enumerate(args.motion):
        scores.append(score_recorded(path, args.seed + i, args.seconds, args.glove))
        watch((i + 1) / len(args.motion))
    found = [*scores, together(scores)] if len(scores) > 1 else scores
    finish(args, {"recordings": [s.to_json() for s in found]}, [s.line() for s in found], [])
    return 0


def _report(scores: list[GestureScore]) -> dict[str, Any]:
    by_name: dict[str, list[Held]] = defaultdict(list)
    for one in scores:
        for pose in one.held:
            by_name[pose.gesture].append(pose)
    rows = {}
    for name, held in by_name.items():
        delays = [h.delay for h in held if np.isfinite(h.delay)]
        rows[name] = {
            "held": len(held),
            "right_percent": 100 * float(np.mean([h.right for h in held])),
            "reported_in_time": len(delays),
            "delay_ms": 1e3 * float(np.median(delays)) if delays else None,
        }
    minutes = sum(one.free_time for one in scores) / 60
    false = {n: sum(s.false_starts[n] for s in scores) for s in scores for n in s.false_starts}
    total = sum(false.values())
    return {"gestures": rows, "false_per_minute": total / max(minutes, 1e-9), "false": false}


def _lines(report: dict[str, Any]) -> list[str]:
    lines = [f"{'gesture':<14}{'held':>5}{'right %':>9}{'delay ms':>10}"]
    for name, row in report["gestures"].items():
        delay = "-" if row["delay_ms"] is None else f"{row['delay_ms']:.0f}"
        lines.append(f"{name:<14}{row['held']:>5}{row['right_percent']:>9.1f}{delay:>10}")
    false = ", ".join(f"{n} {k}" for n, k in report["false"].items()) or "none"
    lines.append(
        f"false detections per minute of free motion: {report['false_per_minute']:.2f} ({false})"
    )
    return lines
