"""Rules on the hand's shape: completeness, size, rigid bones, order of fingers, side."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from extensions.conformance.finding import LayerJudge, RuleFinding
from extensions.conformance.placement import angles_deg, hand_axes
from extensions.conformance.take import (
    CHAINS,
    GRASPS,
    KNUCKLES,
    METACARPALS,
    OPENS,
    PALM,
    PINCHES,
    REQUIRED,
    SCRIPT,
    SETTLED,
    TIPS,
    WRIST,
    RecordTake,
    ScriptStep,
)
from tracker.base.clock import NS
from tracker.hand.names import FINGERS
from tracker.messages import Array, IntArray

COMPLETE = 0.95  # share of records with all 21 joints
SUSTAINED = 0.5  # s: a different set of valid joints this long counts as a change of source
RADIUS = (0.001, 0.05)  # m
BAD_RADII = 0.01  # share
LENGTH = (0.10, 0.30)  # m from wrist to middle tip, along the bones
VARIES = 0.10  # standard deviation of a bone's length relative to its mean
RATIOS = {"middle/palm": (0.6, 1.5), "little/middle": (0.55, 1.0), "thumb/middle": (0.6, 1.5)}
ORDER = 0.9  # share of records
ACROSS = 0.3  # of the distance from index to little knuckle, along the wrist's x
CURL = 0.25  # of straightness, between the most curled and the most extended fifth
PALMWARD = 0.01  # m that tips sink when curled
FIFTH, QUARTER = 0.2, 0.25
PLACED = 0.25  # tolerance of palm and metacarpals, as a share of the palm's length
TOGETHER = 0.003  # m
MISPLACED = 0.05  # share


def judge_shape(take: RecordTake) -> list[RuleFinding]:
    judge = LayerJudge("shape", take)
    whole = np.asarray(take.valid[:, REQUIRED].all(axis=1))
    _complete(take, judge, whole)
    _source(take, judge)
    _radius(take, judge)
    _size(take, judge)
    _bones(take, judge)
    _order(take, judge, whole)
    _side(take, judge, whole)
    _palm(take, judge)
    return judge.found


def _complete(take: RecordTake, judge: LayerJudge, whole: NDArray[np.bool_]) -> None:
    n = int(take.active.sum())
    share = float(whole.sum() / n) if n else 0.0
    plot = (take.valid[:, REQUIRED].sum(axis=1).astype(float), "joints", (21.0,))
    ok = None if not n else share >= COMPLETE
    judge.say("all 21 joints", ok, f"{share:.1%}", f"≥ {COMPLETE:.0%}", plot)


def _source(take: RecordTake, judge: LayerJudge) -> None:
    """Count changes between sustained sets of valid joints."""
    lasting: list[bytes] = []
    rows = np.flatnonzero(take.valid.any(axis=1))
    sets = take.valid[rows]
    breaks = np.flatnonzero((sets[1:] != sets[:-1]).any(axis=1)) + 1
    for run in np.split(rows, breaks):
        if len(run) and (take.sample[run[-1]] - take.sample[run[0]]) / NS >= SUSTAINED:
            lasting.append(take.valid[run[0]].tobytes())
    changes = sum(a != b for a, b in pairwise(lasting))
    ok = None if not len(rows) else changes == 0
    judge.say("the same joints all along", ok, f"{changes} changes that last", "0")


def _radius(take: RecordTake, judge: LayerJudge) -> None:
    radii = take.radius[take.valid]
    if not len(radii):
        judge.say("radius", None, "no joint", "1–50 mm")
        return
    bad = float((~((radii >= RADIUS[0]) & (radii <= RADIUS[1]))).mean())
    figure = f"{np.nanmin(radii) * 1e3:.1f}–{np.nanmax(radii) * 1e3:.1f} mm, {bad:.1%} outside"
    judge.say("radius", bad <= BAD_RADII, figure, f"1–50 mm in {1 - BAD_RADII:.0%}")


def _lengths(take: RecordTake, chain: list[int]) -> Array:
    return np.asarray(np.linalg.norm(np.diff(take.position[:, chain], axis=1), axis=2))


def _median(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.median(known)) if len(known) else np.nan


def _size(take: RecordTake, judge: LayerJudge) -> None:
    along = _lengths(take, [WRIST, *CHAINS["middle"]]).sum(axis=1)
    size = _median(along)
    ok = None if np.isnan(size) else LENGTH[0] <= size <= LENGTH[1]
    plot = (along, "m", LENGTH)
    judge.say("wrist to middle tip", ok, f"{size:.3f} m", "0.10–0.30 m", plot)
    long = {d: _median(_lengths(take, CHAINS[d]).sum(axis=1)) for d in CHAINS}
    long["palm"] = _median(_lengths(take, [WRIST, KNUCKLES["middle"]]).sum(axis=1))
    for name, (low, high) in RATIOS.items():
        a, b = name.split("/")
        ratio = long[a] / long[b]
        ok = None if np.isnan(ratio) else low <= ratio <= high
        judge.say(f"length of {a} by {b}", ok, f"{ratio:.2f}", f"{low:g}–{high:g}")


def _bones(take: RecordTake, judge: LayerJudge) -> None:
    worst, where = 0.0, ""
    for digit, chain in CHAINS.items():
        lengths = _lengths(take, [WRIST, *chain])
        for k, column in enumerate(lengths.T):
            known = column[np.isfinite(column)]
            if len(known) > 1 and known.mean() > 1e-6 and known.std() / known.mean() >= worst:
                worst, where = float(known.std() / known.mean()), f"{digit}, bone {k + 1}"
    judge.say("rigid bones", worst <= VARIES if where else None, f"{worst:.3f} ({where})", "≤ 0.10")


def _extremes(straight: Array, share: float) -> tuple[IntArray, IntArray]:
    """Rows of the most curled and the most extended known records."""
    rows = np.argsort(straight, kind="stable").astype(np.int64)[: int(np.isfinite(straight).sum())]
    n = max(1, int(share * len(rows)))
    return rows[:n], rows[-n:]


def _order(take: RecordTake, judge: LayerJudge, whole: NDArray[np.bool_]) -> None:
    limit = f"≥ {ORDER:.0%}"
    if not whole.any():
        judge.say("knuckles in order", None, "no record with all joints", limit)
        judge.say("joints from root to tip", None, "no record with all joints", limit)
        return
    p = take.position[whole]
    index, little = p[:, KNUCKLES["index"]], p[:, KNUCKLES["little"]]
    across = little - index
    span = np.maximum((across * across).sum(axis=1), 1e-12)
    middle, ring = (
        ((p[:, KNUCKLES[f]] - index) * across).sum(axis=1) / span for f in ("middle", "ring")
    )
    thumb = p[:, CHAINS["thumb"][1]]
    near = np.linalg.norm(thumb - index, axis=1) < np.linalg.norm(thumb - little, axis=1)
    share = float(((middle > 0) & (ring > middle) & (ring < 1) & near).mean())
    judge.say("knuckles in order", share >= ORDER, f"{share:.1%}", limit)
    reach = {d: np.linalg.norm(p[:, c] - p[:, WRIST, None], axis=2) for d, c in CHAINS.items()}
    rising = np.all([(np.diff(r, axis=1) > 0).all(axis=1) for r in reach.values()], axis=0)
    _, extended = _extremes(take.straightness[whole], QUARTER)
    share = float(rising[extended].mean())
    judge.say("joints from root to tip", share >= ORDER, f"{share:.1%} extended", limit)


def _side(take: RecordTake, judge: LayerJudge, whole: NDArray[np.bool_]) -> None:
    across = take.local[:, KNUCKLES["little"]] - take.local[:, KNUCKLES["index"]]
    x = across[:, 0] / np.maximum(np.linalg.norm(across, axis=1), 1e-9)
    share, sign = _median(x), 1.0 if take.side == "right" else -1.0
    ok = None if np.isnan(share) or abs(share) < ACROSS else share * sign > 0
    figure = f"x {share:+.2f} from index to little"
    limit = f"{'≥ +' if sign > 0 else '≤ −'}{ACROSS:g}"
    judge.say(f"a {take.side} hand", ok, figure, limit, (x, "", (sign * ACROSS,)))
    limit = f"≥ {PALMWARD * 1e3:g} mm to the palm"
    rows = np.flatnonzero(whole)
    if len(rows) < 10:
        judge.say("fingers bend to the palm", None, "too few records", limit)
        return
    tips, knuckles = ([which[f] for f in FINGERS] for which in (TIPS, KNUCKLES))
    rise = (take.local[rows][:, tips, 1] - take.local[rows][:, knuckles, 1]).mean(axis=1)
    straight = take.straightness[rows]
    curled, extended = _extremes(straight, FIFTH)
    spread = float(straight[extended].mean() - straight[curled].mean())
    shift = float(rise[curled].mean() - rise[extended].mean())
    ok = None if spread < CURL or abs(shift) < PALMWARD else shift < 0
    figure = f"{-shift * 1e3:.0f} mm when curled by {spread:.2f}"
    judge.say("fingers bend to the palm", ok, figure, limit)


def _palm(take: RecordTake, judge: LayerJudge) -> None:
    """Check that the palm is at the middle of the middle metacarpal, and each metacarpal joint on
    the line from wrist to knuckle."""
    p = take.position
    palm = np.linalg.norm(p[:, KNUCKLES["middle"]] - p[:, WRIST], axis=1)
    centre = (p[:, METACARPALS["middle"]] + p[:, KNUCKLES["middle"]]) / 2
    off = {"palm": np.linalg.norm(p[:, PALM] - centre, axis=1) / palm}
    for f in FINGERS:
        off[f] = _off_line(p[:, METACARPALS[f]], p[:, WRIST], p[:, KNUCKLES[f]]) / palm
    optional = [PALM, *METACARPALS.values()]
    worst, seen = 0.0, False
    for (_, values), joint in zip(off.items(), optional, strict=True):
        known = np.isfinite(values)
        if known.any():
            seen = True
            bad = (values[known] > PLACED) | (_nearest(p[known], joint) < TOGETHER)
            worst = max(worst, float(bad.mean()))
    ok = worst <= MISPLACED if seen else None
    judge.say(
        "palm and metacarpals", ok, f"{worst:.1%} off", f"≤ {MISPLACED:.0%}", None, advice=True
    )


def _off_line(point: Array, a: Array, b: Array) -> Array:
    """Distance (N,) m of a point from the line through two others."""
    ab = b - a
    share = ((point - a) * ab).sum(axis=1) / np.maximum((ab * ab).sum(axis=1), 1e-12)
    return np.asarray(np.linalg.norm(point - a - np.clip(share, 0, 1)[:, None] * ab, axis=1))


def _nearest(p: Array, joint: int) -> Array:
    """Distance (N,) m to the nearest other joint."""
    others = np.delete(p, joint, axis=1)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        return np.asarray(np.nanmin(np.linalg.norm(others - p[:, joint, None], axis=2), axis=1))


# ---- rules on the scripted steps: each gesture is shown in the settled part of its window

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
