"""Begin and end of gestures: hysteresis, a short delay, no gestures while the hand is lost.

The confidence of a gesture is that of the measurement, not the extent of the gesture. A finger
without a sensor is inferred from the others, and its pinch cannot be distinguished from its
neighbour's: the estimate's standard deviations quantify that.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import NamedTuple

from tracker.gestures.shape import GestureShape, ShapeReader
from tracker.gestures.values import (
    BEGINS_AT,
    ENDS_AT,
    GESTURES,
    PINCHES,
    POKE,
    POSTURES,
    GestureParams,
    values,
)
from tracker.hand.model import HandModel
from tracker.messages import Estimate, Event, Tracking

LEAST_SD = 1e-4  # m


def confidence(gesture: str, shape: GestureShape, params: GestureParams) -> float:
    """0 to 1. For a pinch: the probability that the pads are within reach of one another, and that
    no other finger's are closer, with the errors of the gaps assumed normal and independent. For
    the others: the share of the fingers measured by sensors. 0 where a part is lost."""
    if gesture in PINCHES:
        return _of_pinch(PINCHES.index(gesture), shape, params)
    known = [m and math.isfinite(b) for m, b in zip(shape.measured, shape.bend, strict=True)]
    return sum(known) / len(known)


def _of_pinch(finger: int, shape: GestureShape, params: GestureParams) -> float:
    touching = params.touching
    reach = touching.none + ENDS_AT * (touching.full - touching.none)
    gap, sd = shape.gap, shape.gap_sd
    if not (math.isfinite(gap[finger]) and math.isfinite(sd[finger])):
        return 0.0
    sure = _below(gap[finger] - reach, sd[finger])
    for other in range(len(PINCHES)):
        if other != finger and math.isfinite(gap[other]) and math.isfinite(sd[other]):
            sure *= _below(gap[finger] - gap[other], math.hypot(sd[finger], sd[other]))
    return sure


def _below(mean: float, sd: float) -> float:
    """Probability that a normal variable is below 0."""
    return 0.5 * math.erfc(mean / (math.sqrt(2.0) * max(sd, LEAST_SD)))


KIND = "gesture"
WAIT = 0.03  # s for which a value must persist, to begin and to end: three packets


class StartRule(NamedTuple):
    """A gesture begins when its value has been above ``above`` for ``wait`` s, or ``plain_wait`` if
    it is then above `PLAIN`."""

    above: float = BEGINS_AT
    wait: float = WAIT
    plain_wait: float = WAIT


USUAL = StartRule()
PLAIN = 0.95
UNSURE = {"open_palm": StartRule(PLAIN), "grasp": StartRule(0.75, 0.15, 0.06)}
"""Used where some fingers are inferred. Closing fingers move their neighbours along, but next to
straight or half-bent fingers others may differ: of simulated people who moved freely, with ring and
little finger inferred, 36 of 39 false starts in 31 minutes were of these two gestures. Hands that
bend or straighten pass through a grasp within 0.15 s."""
NEVER = StartRule(math.inf)
MUCH_MORE = 0.2  # by which another posture's value must exceed that of the active one
NEARER = 0.006  # m by which another finger's pad must be closer than that of the active pinch
LOSES_AFTER = 0.1  # s for which a gesture continues after its features are lost
LARGEST_SD = 0.016  # m, of the gap of a pinch, above which it does not begin; that of points


class Phase(NamedTuple):
    """A gesture begins or ends; ``value`` 0 to 1 at that time, ``confidence`` 0 to 1 of what is
    measured and not inferred (`confidence`); 0 while the hand is lost."""

    gesture: str
    begins: bool
    t: float
    value: float
    confidence: float = 1.0


@dataclass
class _One:
    """The state of one gesture."""

    active: bool = False
    since: float = math.nan  # when the evidence for a change began
    known: float = -math.inf  # when the value was last known
    value: float = field(default=math.nan)


class GestureRecogniser:
    """Processes one hand's estimates in order; the same estimates give the same gestures."""

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
        self._shape: GestureShape | None = None

    @property
    def active(self) -> tuple[str, ...]:
        """The active gestures."""
        return tuple(name for name, one in self._ones.items() if one.active)

    @property
    def confidences(self) -> dict[str, float]:
        """Confidence of each active gesture, 0 to 1."""
        shape = self._shape
        if shape is None:
            return dict.fromkeys(self.active, 0.0)
        return {name: confidence(name, shape, self._params) for name in self.active}

    @property
    def values(self) -> dict[str, float]:
        """Values of the last estimate, 0 to 1; NaN where the gesture is lost."""
        return {name: one.value for name, one in self._ones.items()}

    def feed(self, estimate: Estimate) -> list[Phase]:
        """Returns the gestures that begin or end with an estimate."""
        t, found = estimate.t, self._values(estimate)
        leader = _leader(found, self._ones, self._gaps())
        changing = []
        for name, one in self._ones.items():
            one.value = found[name]
            if math.isfinite(one.value):
                one.known = t
            if self._changes(name, t, name in leader):
                changing.append(name)
        for name in [n for n in changing if not self._ones[n].active]:
            changing += [o for o in self._in_the_way(name) if o not in changing]
        phases = [self._changed(name, t) for name in changing]
        return sorted(phases, key=lambda phase: phase.begins)  # one ends before the next begins

    def _in_the_way(self, name: str) -> list[str]:
        """Active gestures that end immediately when another of their kind begins."""
        kind = PINCHES if name in PINCHES else POSTURES if name in POSTURES else ()
        return [other for other in kind if self._ones[other].active]

    def _changed(self, name: str, t: float) -> Phase:
        one = self._ones[name]
        one.active, one.since = not one.active, math.nan
        sure = confidence(name, self._shape, self._params) if self._shape else 0.0
        return Phase(name, one.active, t, _shown(one.value), sure)

    def _gaps(self) -> dict[str, float]:
        """m between pads, by pinch; infinite where unknown."""
        gaps = self._shape.gap if self._shape else (math.inf,) * len(PINCHES)
        return {n: math.inf if math.isnan(g) else g for n, g in zip(PINCHES, gaps, strict=True)}

    def _values(self, estimate: Estimate) -> dict[str, float]:
        self._shape = None
        if estimate.tracking == Tracking.SEARCHING:
            return dict.fromkeys(GESTURES, math.nan)
        shape = self._shape = self._shapes.read(estimate)
        found = values(shape, self._params)
        for name, sd in zip(PINCHES, shape.gap_sd, strict=True):
            if sd > LARGEST_SD and not self._ones[name].active:
                found[name] = math.nan  # the gap is too uncertain
        return found

    def _changes(self, name: str, t: float, leads: bool) -> bool:
        """Whether a gesture begins or ends now. Its value may persist while another gesture still
        has priority: then it begins as soon as that ends."""
        one, start = self._ones[name], USUAL
        if one.active and math.isnan(one.value):
            return t - one.known > LOSES_AFTER
        if one.active:
            is_evident = one.value < ENDS_AT or not leads
        elif is_evident := one.value > BEGINS_AT:
            start = self._start(name)
            is_evident = one.value > start.above
        if not is_evident:
            one.since = math.nan
            return False
        if math.isnan(one.since):
            one.since = t
        wait = start.plain_wait if one.value > PLAIN else start.wait
        return (leads or one.active) and t - one.since >= wait - 1e-9

    def _start(self, name: str) -> StartRule:
        """The conditions to begin; for a posture without any measurement they cannot be met."""
        if name not in POSTURES or self._shape is None:
            return USUAL
        sure = confidence(name, self._shape, self._params)
        if sure == 0.0:
            return NEVER
        return UNSURE.get(name, USUAL) if sure < 1.0 else USUAL


def _leader(found: dict[str, float], ones: dict[str, _One], gap: dict[str, float]) -> set[str]:
    """At most one pinch and, without a pinch, one posture: the active one, or the one with the
    largest value; and a poke of a pointing hand.

    Of two pinches it is the one whose pads, by their ``gap`` (m), are closer. A pinch has priority
    over a grasp, which it resembles; a fist and a thumb up over a pinch.
    """
    pinch, posture = _pinch(found, ones, gap), _posture(found, ones)
    if pinch and posture in ("thumb_up", "fist"):
        pinch = None
    if pinch and posture == "grasp":
        posture = None
    poke = POKE if posture == "point" else None
    return {name for name in (pinch, posture, poke) if name}


def _pinch(found: dict[str, float], ones: dict[str, _One], gap: dict[str, float]) -> str | None:
    strong = min((n for n in PINCHES if found[n] > BEGINS_AT), key=gap.__getitem__, default=None)
    standing = _standing(PINCHES, found, ones)
    if strong and standing and gap[strong] < gap[standing] - NEARER:
        return strong
    return standing or strong


def _posture(found: dict[str, float], ones: dict[str, _One]) -> str | None:
    strong = next((n for n in POSTURES if found[n] > BEGINS_AT), None)
    standing = _standing(POSTURES, found, ones)
    if strong and standing and found[strong] > _shown(found[standing]) + MUCH_MORE:
        return strong
    return standing or strong


def _standing(names: tuple[str, ...], found: dict[str, float], ones: dict[str, _One]) -> str | None:
    return next((n for n in names if ones[n].active and not found[n] < ENDS_AT), None)


def _shown(value: float) -> float:
    return 0.0 if math.isnan(value) else value


def gesture_event(phase: Phase, side: str) -> Event:
    """The event for sessions and streams (docs/sessions.md)."""
    return Event(
        phase.t,
        KIND,
        "",
        {
            "hand": side,
            "gesture": phase.gesture,
            "phase": "begin" if phase.begins else "end",
            "value": round(phase.value, 3),
            "confidence": round(phase.confidence, 3),
        },
    )
