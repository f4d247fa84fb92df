"""Rules on the hand's position in the room, and on the orientation of its axes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from extensions.conformance.finding import LayerJudge, RuleFinding
from extensions.conformance.take import (
    CHAINS,
    KNUCKLES,
    TIPS,
    WRIST,
    RecordTake,
    ScriptStep,
    rotations,
)
from tracker.hand.names import FINGERS
from tracker.messages import Array

NEAR = 0.25  # m from the origin, which is on the floor
NEAR_SHARE = 0.5
MOVED = 0.001  # m of a fingertip from one record to the next
LEAST_MOVED = 30  # records
FROZEN = 0.2  # share
ALONG = 0.7  # of −z with the bone
TURNED_DEG, APART_DEG = 90.0, 30.0


def judge_placement(take: RecordTake, steps: Sequence[ScriptStep]) -> list[RuleFinding]:
    judge = LayerJudge("placement", take)
    _origin(take, judge)
    _frozen(take, judge)
    _axes(take, judge)
    _same_frame(take, judge, steps)
    return judge.found


def _origin(take: RecordTake, judge: LayerJudge) -> None:
    distance = np.linalg.norm(take.position[:, WRIST], axis=1)
    known = distance[np.isfinite(distance)]
    near = float((known < NEAR).mean()) if len(known) else np.nan
    figure = f"nearer in {near:.1%}"
    ok = None if not len(known) else near <= NEAR_SHARE
    limit = f"> {NEAR:g} m in more than half"
    judge.say("the wrist is in the room", ok, figure, limit, (distance, "m", (NEAR,)))


def _frozen(take: RecordTake, judge: LayerJudge) -> None:
    wrist = np.concatenate([take.position[:, WRIST], take.orientation[:, WRIST]], axis=1)
    tips = take.position[:, [TIPS[f] for f in FINGERS]]
    step = np.linalg.norm(np.diff(tips, axis=0), axis=2)
    moving = np.isfinite(step).all(axis=1) & (step >= MOVED).any(axis=1)
    same = (wrist[1:] == wrist[:-1]).all(axis=1)[moving]
    share = float(same.mean()) if len(same) else np.nan
    ok = None if len(same) < LEAST_MOVED else share <= FROZEN
    figure = f"{share:.1%} of {len(same)} records with moving fingers"
    judge.say("the wrist is not frozen", ok, figure, f"≤ {FROZEN:.0%}")


def _axes(take: RecordTake, judge: LayerJudge) -> None:
    xyzw, wxyz = _along(take, [0, 1, 2, 3]), _along(take, [1, 2, 3, 0])
    ok = None if np.isnan(xyzw) else xyzw >= ALONG and xyzw >= wxyz
    figure = f"{xyzw:.2f}" + (f"; read as wxyz {wxyz:.2f}" if not ok else "")
    judge.say("−z along the bones, xyzw", ok, figure, f"≥ {ALONG:g}")


def _along(take: RecordTake, order: list[int]) -> float:
    """Mean cosine between −z and the bone for quaternions in this order."""
    found = []
    for chain in CHAINS.values():
        for a, b in pairwise(chain):
            bone = take.position[:, b] - take.position[:, a]
            bone = bone / np.maximum(np.linalg.norm(bone, axis=1, keepdims=True), 1e-9)
            q = take.orientation[:, a][:, order]
            known = np.isfinite(bone).all(axis=1) & np.isfinite(q).all(axis=1)
            z = rotations(q[known])[:, :, 2]
            found.append(-(z * bone[known]).sum(axis=1))
    every = np.concatenate(found)
    return float(every.mean()) if len(every) else np.nan


def hand_axes(position: Array) -> Array:
    """Axes (N, 3, 3) from positions (N, 26, 3). Columns: forward, across the palm, normal."""
    forward = position[:, KNUCKLES["middle"]] - position[:, WRIST]
    across = position[:, KNUCKLES["little"]] - position[:, KNUCKLES["index"]]
    columns = [forward, across, np.cross(forward, across)]
    return np.stack([c / np.linalg.norm(c, axis=1, keepdims=True) for c in columns], axis=2)


def angles_deg(axes: Array, reference: Array) -> Array:
    """Largest angle (N,) between the three axes (N, 3, 3) and those of ``reference`` (3, 3)."""
    cosine = np.clip((axes * reference).sum(axis=1), -1, 1)
    return np.asarray(np.rad2deg(np.arccos(cosine)).max(axis=1))


def _same_frame(take: RecordTake, judge: LayerJudge, steps: Sequence[ScriptStep]) -> None:
    """Compare the rotation of the wrist's quaternion with that of the joints' positions."""
    limit = f"≤ {APART_DEG:g}° (95 %) over ≥ {TURNED_DEG:g}°"
    window = next((s for s in steps if s.label == "wrist_rotate"), None)
    axes = hand_axes(take.position)
    inside = np.isfinite(axes).all(axis=(1, 2))
    if window is not None:
        inside &= (take.sample >= window.start_ns) & (take.sample < window.end_ns)
    rows = np.flatnonzero(inside)
    if window is None or len(rows) < 2:
        judge.say("wrist and joints turn together", None, "no step wrist_rotate", limit)
        return
    local = np.swapaxes(rotations(take.orientation[rows, WRIST]), 1, 2) @ axes[rows]
    turned = float(angles_deg(axes[rows], axes[rows[0]]).max())
    apart = angles_deg(local, local[0])
    p95 = float(np.percentile(apart[1:], 95))
    values = np.full(len(take), np.nan)
    values[rows] = apart
    ok = None if turned < TURNED_DEG else p95 <= APART_DEG
    figure = f"{p95:.1f}° over {turned:.0f}°"
    judge.say("wrist and joints turn together", ok, figure, limit, (values, "°", (APART_DEG,)))
