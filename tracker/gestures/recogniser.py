"""When gestures begin and end: hysteresis, a short wait, nothing where the hand is lost."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tracker.gestures.shape import ShapeReader
from tracker.gestures.values import GESTURES, PINCHES, POSTURES, GestureParams, values
from tracker.hand.model import HandModel
from tracker.messages import Estimate, Event, Tracking

KIND = "gesture"
BEGINS_AT, ENDS_AT = 0.6, 0.3  # values
WAIT = 0.03  # s that a value must last, to begin and to end: three packets
MUCH_MORE = 0.4  # by which another gesture's value must exceed that of the one that stands
LOSES_AFTER = 0.1  # s that a gesture outlives the sight of what it is told by
LARGEST_SD = 0.012  # m, of the gap of a pinch that is believed to begin


class Phase(NamedTuple):
    """A gesture begins or ends; ``value`` 0 to 1 as it was then."""

    gesture: str
    begins: bool
    t: float
    value: float


@dataclass
class _One:
    """Where one gesture stands."""

    active: bool = False
    since: float = np.nan  # when what speaks for a change began
    known: float = -np.inf  # when the value was last known
    value: float = field(default=np.nan)


class GestureRecogniser:
    """Fed with one hand's estimates in order; the same estimates give the same gestures."""

    def __init__(
        self,
        hand: HandModel,
        keypoint_names: tuple[str, ...],
        params: GestureParams | None = None,
    ) -> None:
        self.side = hand.side
        self._shapes = ShapeReader(hand, keypoint_names)
        self._params = params or GestureParams()
        self._ones = {name: _One() for name in GESTURES}

    @property
    def active(self) -> tuple[str, ...]:
        """Gestures that are shown now."""
        return tuple(name for name, one in self._ones.items() if one.active)

    @property
    def values(self) -> dict[str, float]:
        """How much of each the last estimate shows, 0 to 1; NaN where that is lost."""
        return {name: one.value for name, one in self._ones.items()}

    def feed(self, estimate: Estimate) -> list[Phase]:
        """What begins and ends with an estimate."""
        t, found = estimate.t, self._values(estimate)
        leader = _leader(found, self._ones)
        phases = []
        for name, one in self._ones.items():
            one.value = found[name]
            if np.isfinite(one.value):
                one.known = t
            may = name in leader
            if self._changes(one, t, may):
                one.active = not one.active
                one.since = np.nan
                phases.append(Phase(name, one.active, t, _shown(one.value)))
        return sorted(phases, key=lambda phase: phase.begins)  # one ends before the next begins

    def _values(self, estimate: Estimate) -> dict[str, float]:
        if estimate.tracking == Tracking.SEARCHING:
            return dict.fromkeys(GESTURES, np.nan)
        shape = self._shapes.read(estimate)
        found = values(shape, self._params)
        for name, sd in zip(PINCHES, shape.gap_sd, strict=True):
            if sd > LARGEST_SD and not self._ones[name].active:
                found[name] = np.nan  # too little is known of the gap
        return found

    def _changes(self, one: _One, t: float, may_begin: bool) -> bool:
        """Whether a gesture begins or ends now."""
        if one.active and np.isnan(one.value):
            return t - one.known > LOSES_AFTER
        if one.active:
            wanted = one.value < ENDS_AT or not may_begin
        else:
            wanted = may_begin and one.value > BEGINS_AT
        if not wanted:
            one.since = np.nan
            return False
        if np.isnan(one.since):
            one.since = t
        return t - one.since >= WAIT - 1e-9


def _leader(found: dict[str, float], ones: dict[str, _One]) -> set[str]:
    """At most one pinch and, where there is none, one posture: that which stands, or has most.

    A pinch stands before a grasp, which it looks like; a fist and a thumb up before a pinch.
    """

    def best(names: tuple[str, ...]) -> str | None:
        strong = next((n for n in names if found[n] > BEGINS_AT), None)
        standing = next((n for n in names if ones[n].active and not found[n] < ENDS_AT), None)
        if strong and standing and _shown(found[strong]) > _shown(found[standing]) + MUCH_MORE:
            return strong
        return standing or strong

    by_value = tuple(sorted(PINCHES, key=lambda n: -_shown(found[n])))
    pinch, posture = best(by_value), best(POSTURES)
    if pinch and posture in ("thumb_up", "fist"):
        pinch = None
    if pinch and posture == "grasp":
        posture = None
    return {name for name in (pinch, posture) if name}


def _shown(value: float) -> float:
    return 0.0 if np.isnan(value) else value


def gesture_event(phase: Phase, side: str) -> Event:
    """As sessions and streams have it (docs/sessions.md)."""
    return Event(
        phase.t,
        KIND,
        "",
        {
            "hand": side,
            "gesture": phase.gesture,
            "phase": "begin" if phase.begins else "end",
            "value": round(phase.value, 3),
        },
    )
