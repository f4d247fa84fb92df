"""Rules on the scripted steps: each gesture is shown in the settled part of its window."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from extensions.conformance.finding import LayerJudge, RuleFinding
from extensions.conformance.placement import angles_deg, hand_axes
from extensions.conformance.take import (
    GRASPS,
    OPENS,
    PINCHES,
    SCRIPT,
    SETTLED,
    RecordTake,
    ScriptStep,
)
from tracker.hand.names import FINGERS
from tracker.messages import IntArray

COVERED = 0.98  # share of a window that the records span
OPEN, CLOSED = 0.80, 0.60  # straightness
SHOWN_OPEN, SHOWN_FIST, FIST_DROP = 0.60, 0.75, 0.15
CONTACT = 0.04  # m
NEAREST = 0.6  # share of frames
LEAST = 5  # frames in contact
TURNED_DEG = 60.0


def judge_steps(take: RecordTake, steps: Sequence[ScriptStep]) -> list[RuleFinding]:
    judge = LayerJudge("steps", take)
    if not steps:
        judge.say("scripted steps", None, "no labels", "TAKE.labels.json")
        return judge.found
    _windows(take, judge, steps)
    rows = {s.label: settled_rows(take, s) for s in steps}
    straight = {label: _middle(take.straightness[r]) for label, r in rows.items()}
    _opens_and_fists(take, judge, straight)
    for label, finger in PINCHES.items():
        if label in rows:
            _pinch(take, judge, label, finger, rows[label])
    _turn(take, judge, rows)
    return judge.found


def settled_rows(take: RecordTake, step: ScriptStep) -> IntArray:
    """Records of a window after the transition into it."""
    start = step.start_ns + int(SETTLED * (step.end_ns - step.start_ns))
    return np.flatnonzero((take.sample >= start) & (take.sample < step.end_ns))


def _middle(values: np.ndarray) -> float:
    known = values[np.isfinite(values)]
    return float(np.median(known)) if len(known) else np.nan


def _windows(take: RecordTake, judge: LayerJudge, steps: Sequence[ScriptStep]) -> None:
    wrong = [b.label for a, b in pairwise(steps) if b.start_ns < a.end_ns]
    wrong += [s.label for s in steps if s.end_ns <= s.start_ns]
    wrong += [s.label for s in set(steps) if sum(o.label == s.label for o in steps) > 1]
    missing = [label for label in SCRIPT if label not in {s.label for s in steps}]
    figure = f"{len(steps)} steps" + "".join(f", {w} overlaps or repeats" for w in wrong)
    figure += f", without {', '.join(missing)}" if missing else ""
    judge.say("windows in order", not wrong and not missing, figure, f"{len(SCRIPT)} steps")
    short = []
    for s in steps:
        span = min(s.end_ns, int(take.sample[-1])) - max(s.start_ns, int(take.sample[0]))
        inside = (take.sample >= s.start_ns) & (take.sample < s.end_ns)
        if not inside.any() or span < COVERED * (s.end_ns - s.start_ns):
            short.append(s.label)
    figure = ", ".join(short) or "all"
    judge.say("windows have records", not short, figure, f"≥ {COVERED:.0%} of each")


def _opens_and_fists(take: RecordTake, judge: LayerJudge, straight: dict[str, float]) -> None:
    plot = (take.straightness, "straightness", (CLOSED, OPEN))
    for label in OPENS:
        if label in straight:
            value = straight[label]
            ok = None if np.isnan(value) else value >= OPEN
            judge.say(label, ok, f"straightness {value:.2f}", f"≥ {OPEN:.2f}", plot)
    fists = ["fist", *(label for label, side in GRASPS.items() if side == take.side)]
    reference = straight.get(OPENS[0], np.nan)
    shown = SHOWN_FIST if np.isnan(reference) else min(SHOWN_FIST, reference - FIST_DROP)
    for label in fists:
        if label in straight:
            value, limit = straight[label], CLOSED if label == "fist" else shown
            ok = None if np.isnan(value) else value <= limit
            judge.say(label, ok, f"straightness {value:.2f}", f"≤ {limit:.2f}", plot)


def _pinch(take: RecordTake, judge: LayerJudge, label: str, finger: str, rows: IntArray) -> None:
    distance = take.pinch[rows]
    touching = distance[np.isfinite(distance).all(axis=1) & (distance.min(axis=1) <= CONTACT)]
    named = FINGERS.index(finger)
    limit = f"nearest in ≥ {NEAREST:.0%}, ≤ {CONTACT * 1e3:g} mm"
    plot = (take.pinch[:, named] * 1e3, "mm", (CONTACT * 1e3,))
    if len(touching) < LEAST:
        nearest = float(np.nanmin(distance)) if np.isfinite(distance).any() else np.nan
        ok = None if np.isnan(nearest) else False
        judge.say(label, ok, f"no touch: {nearest * 1e3:.0f} mm", limit, plot)
        return
    share = float((touching.argmin(axis=1) == named).mean())
    apart = float(np.median(touching[:, named])) * 1e3
    ok = share >= NEAREST and apart <= CONTACT * 1e3
    judge.say(label, ok, f"nearest in {share:.0%}, {apart:.0f} mm", limit, plot)


def _turn(take: RecordTake, judge: LayerJudge, rows: dict[str, IntArray]) -> None:
    """Check that the wrist turns most in this step."""
    axes = hand_axes(take.position)
    turned = {}
    for label, inside in rows.items():
        known = inside[np.isfinite(axes[inside]).all(axis=(1, 2))]
        if len(known) > 1:
            turned[label] = float(angles_deg(axes[known], axes[known[0]]).max())
    if "wrist_rotate" not in turned:
        judge.say("wrist_rotate", None, "not seen", f"≥ {TURNED_DEG:g}°")
        return
    most = max(turned, key=lambda label: turned[label])
    ok = turned["wrist_rotate"] >= TURNED_DEG and most == "wrist_rotate"
    figure = f"{turned['wrist_rotate']:.0f}°" + ("" if ok else f", most in {most}")
    judge.say("wrist_rotate", ok, figure, f"≥ {TURNED_DEG:g}°, the most of all steps")
