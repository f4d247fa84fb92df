"""What of a hand's shape gestures are told by, and how surely.

Numbers of the wearer's own hand in its own frame: neither where the hand is nor how it is turned
counts, so a gesture holds while the place is lost and the fingers are known.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.messages import Array, Estimate, IntArray, Validity

UNKNOWN = np.nan
PAD = 0.004  # m before the tip: the middle of the pad, where thumb and finger meet


class HandShape(NamedTuple):
    """One instant's; NaN where unknown, rows in the order of `FINGERS`.

    bend (4,) rad: sum of a finger's three flexions. thumb_bend rad: of the thumb's two outer
    joints. gap (4,) m: from the thumb's end to each finger's, between surfaces, with gap_sd (4,) m.
    thumb_off m: from the thumb's tip to the nearest of the index finger's bones.
    across m: from the thumb's tip to the middle fingertip.
    """

    bend: Array
    thumb_bend: float
    gap: Array
    gap_sd: Array
    thumb_off: float
    across: float


class ShapeReader:
    """Reads shapes out of the estimates of one hand."""

    def __init__(self, hand: HandModel, keypoint_names: tuple[str, ...]) -> None:
        self._angle = hand.angle_index
        self._row = {name: i for i, name in enumerate(keypoint_names)}
        self._radius = {s.name: s.radius for s in hand.segments}

    def read(self, estimate: Estimate) -> HandShape:
        """The shape that an estimate tells; a finger whose parts are lost is unknown."""
        gaps = [self._gap(estimate, finger) for finger in FINGERS]
        return HandShape(
            bend=np.array([self._bend(estimate, f, ("mcp", "pip", "dip")) for f in FINGERS]),
            thumb_bend=self._bend(estimate, "thumb", ("mcp", "ip")),
            gap=np.array([gap for gap, _ in gaps]),
            gap_sd=np.array([sd for _, sd in gaps]),
            thumb_off=self._thumb_off(estimate),
            across=self._distance(estimate, "thumb_tip", "middle_tip"),
        )

    def _bend(self, estimate: Estimate, finger: str, joints: tuple[str, ...]) -> float:
        columns = [self._angle.get(f"{finger}_{joint}_flexion", -1) for joint in joints]
        if min(columns) < 0 or _lost(estimate.angle_state[columns]):
            return UNKNOWN
        return float(estimate.angles[columns].sum())

    def _gap(self, estimate: Estimate, finger: str) -> tuple[float, float]:
        thumb = self._bone(estimate, "thumb_ip", "thumb_tip", "thumb_distal")
        other = self._bone(estimate, f"{finger}_dip", f"{finger}_tip", f"{finger}_distal")
        if thumb is None or other is None:
            return UNKNOWN, UNKNOWN
        near = float(np.linalg.norm(thumb.pad - other.pad)) - thumb.radius - other.radius
        return near, float(np.hypot(thumb.sd, other.sd))

    def _bone(self, estimate: Estimate, start: str, tip: str, segment: str) -> _Bone | None:
        rows = [self._row.get(start, -1), self._row.get(tip, -1)]
        if min(rows) < 0 or _lost(estimate.keypoint_state[rows]):
            return None
        a, b = estimate.keypoints[rows]
        along = (a - b) / max(float(np.linalg.norm(a - b)), 1e-6)
        sd = float(estimate.keypoint_sd[rows[1]])
        return _Bone(b + PAD * along, self._radius[segment], sd)

    def _thumb_off(self, estimate: Estimate) -> float:
        """From the thumb's tip to the chain of the index finger's bones."""
        chain = [self._row.get(f"index_{part}", -1) for part in ("mcp", "pip", "dip", "tip")]
        thumb = self._row.get("thumb_tip", -1)
        if min(*chain, thumb) < 0 or _lost(estimate.keypoint_state[[*chain, thumb]]):
            return UNKNOWN
        p, nodes = estimate.keypoints[thumb], estimate.keypoints[chain]
        return min(_from_line(p, a, b) for a, b in pairwise(nodes))

    def _distance(self, estimate: Estimate, one: str, other: str) -> float:
        rows = [self._row.get(one, -1), self._row.get(other, -1)]
        if min(rows) < 0 or _lost(estimate.keypoint_state[rows]):
            return UNKNOWN
        a, b = estimate.keypoints[rows]
        return float(np.linalg.norm(a - b))


class _Bone(NamedTuple):
    """A fingertip's bone: the middle of its pad's axis (3,) m, radius and sd m."""

    pad: Array
    radius: float
    sd: float


def fingers_of(hand: HandModel) -> tuple[str, ...]:
    """Fingers (not the thumb) that a hand has whole."""
    return tuple(f for f in FINGERS if all(segment in hand.index for segment in CHAINS[f]))


def _lost(states: IntArray) -> bool:
    return bool((states == Validity.LOST).any())


def _from_line(p: Array, a: Array, b: Array) -> float:
    """m from a point to the piece of line between two."""
    d = b - a
    share = float(np.clip((p - a) @ d / max(float(d @ d), 1e-12), 0.0, 1.0))
    return float(np.linalg.norm(p - a - share * d))
