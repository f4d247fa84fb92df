"""Scores gestures of recorded human motion through simulated sensors and tracking.

The recordings have no labels, so the gestures recognised in the recorded hand itself serve as
labels. The score states how many of them are recognised after tracking, with which delay, and how
many additional gestures are recognised.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from extensions.evaluation.gestures.score import TrueValues, phases_of, tracked, true_hand
from tracker.gestures.recogniser import Phase
from tracker.offline.simulate import SimulateOptions, build

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
