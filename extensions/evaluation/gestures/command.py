"""``glovetrack evaluate gestures``.

Recordings of human motion have no labels, so the gestures recognised in the recorded hand itself
serve as labels. The score states how many of them are recognised after tracking through simulated
sensors, with which delay, and how many additional gestures are recognised.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from extensions.evaluation.commands import EvaluateGesturesArguments
from extensions.evaluation.gestures.score import (
    GestureScore,
    Held,
    TrueValues,
    phases_of,
    score,
    tracked,
    true_hand,
)
from tracker.base.terminal import check_json, finish, progress_line
from tracker.gestures.recogniser import Phase
from tracker.offline.simulate import SimulateOptions, build


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


EARLY, LATE = 0.15, 0.6  # s before and after a true beginning in which a detection counts
LASTS = 0.15  # s: shorter gestures are transitions, not labels
SETTLING = 1.0  # s from the first image, while tracking starts


@dataclass
class RecordedScore:
    """Score of one or several recordings: gestures of the hand, detected ones with their delays
    (s), and false detections, in ``seconds`` of motion."""

    name: str
    seconds: float = 0.0
    shown: Counter[str] = field(default_factory=Counter)
    detected: Counter[str] = field(default_factory=Counter)
    false: Counter[str] = field(default_factory=Counter)
    delays: list[float] = field(default_factory=list)

    def to_json(self) -> dict[str, Any]:
        delays = 1e3 * np.array(self.delays)
        return {
            "name": self.name,
            "seconds": self.seconds,
            "shown": dict(self.shown),
            "reported": dict(self.detected),
            "false": dict(self.false),
            "false_per_minute": 60 * self.false.total() / max(self.seconds, 1e-9),
            "delay_ms_median": float(np.median(delays)) if len(delays) else None,
            "delay_ms_90": float(np.percentile(delays, 90)) if len(delays) else None,
        }

    def line(self) -> str:
        """One line of text."""
        data = self.to_json()
        delay = data["delay_ms_median"]
        late = "" if delay is None else f", {delay:.0f} ms late (90 %: {data['delay_ms_90']:.0f})"
        false = ", ".join(f"{n} {k}" for n, k in self.false.items()) or "none"
        shown = ", ".join(f"{n} {self.detected[n]}/{k}" for n, k in self.shown.items()) or "none"
        return (
            f"{self.name}: {self.seconds:.0f} s, detected {shown}{late}; false {false} "
            f"({data['false_per_minute']:.2f} a minute)"
        )


def score_recorded(path: Path, seed: int, most: float, glove: str = "") -> RecordedScore:
    """Score the first ``most`` s of a recording with a simulated wearer. Raises FileError."""
    options = SimulateOptions(glove=glove, motion=str(path), seed=seed, images=False)
    simulation, _ = build(options)
    end = min(most, simulation.duration - 0.05)
    hand, glove_model = simulation.hand, simulation.glove
    names = glove_model.keypoint_names(hand)
    true = [e for e in true_hand(simulation) if e.t < end]
    wanted = phases_of(true, hand, names)
    found = phases_of(tracked(simulation, end), hand, names)
    truth = TrueValues(true, hand, names)
    out = RecordedScore(path.stem, seconds=max(end - SETTLING, 0.0))
    for phase in _lasting(wanted, end):
        if phase.t < SETTLING:
            continue
        out.shown[phase.gesture] += 1
        delay = _delay(phase, found)
        if delay is not None:
            out.detected[phase.gesture] += 1
            out.delays.append(delay)
    for phase in found:
        if phase.begins and phase.t >= SETTLING and not truth.shows(phase.gesture, phase.t):
            out.false[phase.gesture] += 1
    return out


def together(scores: Sequence[RecordedScore]) -> RecordedScore:
    """The combined score."""
    out = RecordedScore("all")
    for one in scores:
        out.seconds += one.seconds
        out.shown += one.shown
        out.detected += one.detected
        out.false += one.false
        out.delays += one.delays
    return out


def _lasting(phases: Sequence[Phase], end: float) -> list[Phase]:
    """Beginnings of gestures that last at least `LASTS`."""
    out = []
    for i, phase in enumerate(phases):
        if phase.begins:
            ends = (p.t for p in phases[i + 1 :] if p.gesture == phase.gesture and not p.begins)
            if next(ends, end) - phase.t >= LASTS:
                out.append(phase)
    return out


def _delay(phase: Phase, found: Sequence[Phase]) -> float | None:
    """Delay in s from the true beginning to the detection; 0 if the gesture is already detected,
    None if it is not detected."""
    same = [p for p in found if p.gesture == phase.gesture]
    near = [p.t - phase.t for p in same if p.begins and -EARLY <= p.t - phase.t <= LATE]
    if near:
        return min(near, key=abs)
    before = [p for p in same if p.t < phase.t - EARLY]
    return 0.0 if before and before[-1].begins else None
