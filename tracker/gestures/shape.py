"""Features of the hand's shape from which gestures are recognised, with their uncertainty.

The features are in the hand's own frame and independent of its position and orientation, so a
gesture continues while the position is lost and the fingers are known. Only a thrust depends on the
hand's motion in the room.
"""

from __future__ import annotations

import math
from collections import deque
from itertools import pairwise
from typing import NamedTuple

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.messages import Estimate, Validity

UNKNOWN = math.nan
NONE = -1  # row of a missing part
LOST, MEASURED = int(Validity.LOST), int(Validity.MEASURED)
PAD = 0.004  # m before the tip: centre of the pad, where thumb and finger touch
FLEXIONS = ("mcp", "pip", "dip")
THRUST = 0.2  # s over which a thrust is measured
MOMENT = 1e-6  # s
SHORTEST = 1e-6  # m


class GestureShape(NamedTuple):
    """The features at one time; NaN where unknown, rows in the order of `FINGERS`.

    bend (4,) rad: sum of a finger's three flexions; measured (4,): at least one of them is
    measured, else all are inferred. thumb_bend rad: of the thumb's two outer joints. gap (4,) m:
    from the thumb's end to each finger's, between surfaces, with gap_sd (4,) m. thumb_off m: from
    the thumb's tip to the nearest of the index finger's bones. across m: from the thumb's tip to
    the middle fingertip. thrust m: displacement of the index fingertip along its finger minus that
    to a side, in the last `THRUST` s.
    """

    bend: tuple[float, ...]
    measured: tuple[bool, ...]
    thumb_bend: float
    gap: tuple[float, ...]
    gap_sd: tuple[float, ...]
    thumb_off: float
    across: float
    thrust: float


class _PlainEstimate(NamedTuple):
    """An estimate as Python numbers. For so few values, arrays would take ten times as long as the
    arithmetic, which runs in the tracking thread."""

    t: float
    p: list[list[float]]
    state: list[int]
    sd: list[float]
    angle: list[float]
    angle_state: list[int]


class ShapeReader:
    """Computes shapes from the estimates of one hand, in order."""

    def __init__(self, hand: HandModel, keypoint_names: tuple[str, ...]) -> None:
        row = {name: i for i, name in enumerate(keypoint_names)}
        self._radius = {s.name: s.radius for s in hand.segments}

        def angles(finger: str, *joints: str) -> tuple[int, ...]:
            return tuple(hand.angle_index.get(f"{finger}_{j}_flexion", NONE) for j in joints)

        def points(finger: str, *parts: str) -> tuple[int, ...]:
            return tuple(row.get(f"{finger}_{part}", NONE) for part in parts)

        self._bends = [angles(f, *FLEXIONS) for f in FINGERS]
        self._thumb_bend = angles("thumb", "mcp", "ip")
        self._ends = {f: points(f, "ip" if f == "thumb" else "dip", "tip") for f in CHAINS}
        self._index = points("index", "mcp", "pip", "dip", "tip")
        self._way: deque[tuple[float, list[float]]] = deque()  # trajectory of the index fingertip

    def read(self, estimate: Estimate) -> GestureShape:
        """The shape in an estimate; a finger with lost parts is unknown."""
        e = _PlainEstimate(
            estimate.t,
            estimate.keypoints.tolist(),
            estimate.keypoint_state.tolist(),
            estimate.keypoint_sd.tolist(),
            estimate.angles.tolist(),
            estimate.angle_state.tolist(),
        )
        thumb = self._bone(e, "thumb")
        gaps = [_between(thumb, self._bone(e, finger)) for finger in FINGERS]
        return GestureShape(
            bend=tuple(_bend(e, columns) for columns in self._bends),
            measured=tuple(_measured(e, columns) for columns in self._bends),
            thumb_bend=_bend(e, self._thumb_bend),
            gap=tuple(gap for gap, _ in gaps),
            gap_sd=tuple(sd for _, sd in gaps),
            thumb_off=self._thumb_off(e),
            across=self._distance(e, "thumb", "middle"),
            thrust=self._thrust(e),
        )

    def _bone(self, e: _PlainEstimate, finger: str) -> _Bone | None:
        rows = self._ends[finger]
        if _lost(rows, e.state):
            return None
        a, b = e.p[rows[0]], e.p[rows[1]]
        length = max(math.dist(a, b), SHORTEST)
        pad = [y + PAD * (x - y) / length for x, y in zip(a, b, strict=True)]
        return _Bone(pad, self._radius[f"{finger}_distal"], e.sd[rows[1]])

    def _thumb_off(self, e: _PlainEstimate) -> float:
        """From the thumb's tip to the chain of the index finger's bones."""
        thumb = self._ends["thumb"][1]
        if _lost((*self._index, thumb), e.state):
            return UNKNOWN
        nodes = [e.p[i] for i in self._index]
        return min(_from_line(e.p[thumb], a, b) for a, b in pairwise(nodes))

    def _distance(self, e: _PlainEstimate, one: str, other: str) -> float:
        """m between two fingertips."""
        rows = self._ends[one][1], self._ends[other][1]
        return UNKNOWN if _lost(rows, e.state) else math.dist(e.p[rows[0]], e.p[rows[1]])

    def _thrust(self, e: _PlainEstimate) -> float:
        """Unknown until the fingertip has been measured for `THRUST` s."""
        rows, way, t = (self._index[0], self._index[-1]), self._way, e.t
        if _lost(rows, e.state):
            way.clear()
            return UNKNOWN
        base, tip = e.p[rows[0]], e.p[rows[1]]
        if way and not way[-1][0] < t < way[-1][0] + THRUST:
            way.clear()
        way.append((t, tip))
        while len(way) > 1 and way[1][0] <= t - THRUST + MOMENT:
            way.popleft()
        if t - way[0][0] < THRUST - MOMENT:
            return UNKNOWN
        return _ahead(way[0][1], tip, base)


class _Bone(NamedTuple):
    """A fingertip's bone: the middle of its pad's axis (3,) m, radius and sd m."""

    pad: list[float]
    radius: float
    sd: float


def _lost(rows: tuple[int, ...], states: list[int]) -> bool:
    """Whether any of them is lost or missing."""
    return min(rows) < 0 or LOST in [states[row] for row in rows]


def _bend(e: _PlainEstimate, columns: tuple[int, ...]) -> float:
    return UNKNOWN if _lost(columns, e.angle_state) else sum(e.angle[i] for i in columns)


def _measured(e: _PlainEstimate, columns: tuple[int, ...]) -> bool:
    return any(i >= 0 and e.angle_state[i] == MEASURED for i in columns)


def _between(thumb: _Bone | None, other: _Bone | None) -> tuple[float, float]:
    """m between surfaces, and its sd."""
    if thumb is None or other is None:
        return UNKNOWN, UNKNOWN
    near = math.dist(thumb.pad, other.pad) - thumb.radius - other.radius
    return near, math.hypot(thumb.sd, other.sd)


def _ahead(before: list[float], tip: list[float], base: list[float]) -> float:
    """m that a point moved along its finger, minus its motion to a side."""
    length = max(math.dist(tip, base), SHORTEST)
    went = [x - y for x, y in zip(tip, before, strict=True)]
    along = sum(w * (x - y) / length for w, x, y in zip(went, tip, base, strict=True))
    across = math.sqrt(max(sum(w * w for w in went) - along * along, 0.0))
    return along - across


def _from_line(p: list[float], a: list[float], b: list[float]) -> float:
    """m from a point to the line segment between two points."""
    d = [y - x for x, y in zip(a, b, strict=True)]
    share = sum((z - x) * w for z, x, w in zip(p, a, d, strict=True))
    share = min(max(share / max(sum(w * w for w in d), 1e-12), 0.0), 1.0)
    return math.dist(p, [x + share * w for x, w in zip(a, d, strict=True)])
