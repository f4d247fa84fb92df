"""How much of each gesture a shape shows, from 0 to 1.

OpenXR's XR_EXT_hand_interaction gives pinch, grasp, aim and poke such values; the others are the
field's. A value is the least of its conditions, each a ramp over what people do, so a little more
of an angle is a little more of a value and no threshold stands in two places.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from tracker.gestures.shape import HandShape
from tracker.hand.names import FINGERS

PINCHES = tuple(f"pinch_{finger}" for finger in FINGERS)
POSTURES = ("thumb_up", "fist", "point", "open_palm", "grasp")
"""Of these a hand shows one at a time; the earlier is the more particular."""
POKE = "poke"
"""What a hand does while it points."""
GESTURES = (*PINCHES, *POSTURES, POKE)
BEGINS_AT, ENDS_AT = 0.6, 0.3
"""Values at which a gesture begins and ends."""


class Ramp(NamedTuple):
    """0 at ``none`` and beyond, 1 at ``full`` and beyond; either may be the larger."""

    none: float
    full: float

    def of(self, x: float) -> float:
        """NaN of NaN."""
        share = (x - self.none) / (self.full - self.none)
        return share if math.isnan(share) else min(max(share, 0.0), 1.0)


class GestureParams(NamedTuple):
    """Angles are sums of a finger's flexions. What is asked of a wearer in the guided poses (a fist
    of 235° and straight fingers within 15°) lies well inside; free motion mostly between."""

    clenched: Ramp = Ramp(math.radians(140.0), math.radians(195.0))
    curled: Ramp = Ramp(math.radians(110.0), math.radians(165.0))  # beside a pointing finger
    straight: Ramp = Ramp(math.radians(75.0), math.radians(35.0))
    around: Ramp = Ramp(math.radians(40.0), math.radians(90.0))  # about an object
    not_clenched: Ramp = Ramp(math.radians(205.0), math.radians(165.0))
    thumb_straight: Ramp = Ramp(math.radians(65.0), math.radians(35.0))
    thumb_away: Ramp = Ramp(0.040, 0.058)  # m from the index finger's bones
    thumb_near: Ramp = Ramp(0.060, 0.048)
    opposed: Ramp = Ramp(0.110, 0.085)  # m between the tips of thumb and middle finger
    apart: Ramp = Ramp(0.015, 0.030)  # and not yet closed
    touching: Ramp = Ramp(0.030, 0.004)  # m between pads
    thrust: Ramp = Ramp(0.010, 0.025)  # m ahead in 0.2 s


def values(shape: HandShape, params: GestureParams) -> dict[str, float]:
    """Of all `GESTURES`; NaN where what it is told by is lost."""
    return {name: rule(shape, params) for name, rule in _RULES.items()}


def _pinch(finger: int) -> Callable[[HandShape, GestureParams], float]:
    def value(s: HandShape, p: GestureParams) -> float:
        """In a fist a finger holds its pad to the palm, not to the thumb's; with the others
        out of the way it may be bent as far, and pinches."""
        others = (sum(s.bend) - s.bend[finger]) / (len(s.bend) - 1)
        bend = _least(s.bend[finger], others)
        return _least(p.touching.of(s.gap[finger]), p.not_clenched.of(bend))

    return value


def _thumb_up(s: HandShape, p: GestureParams) -> float:
    clenched = [p.curled.of(bend) for bend in s.bend]
    return _least(*clenched, p.thumb_straight.of(s.thumb_bend), p.thumb_away.of(s.thumb_off))


def _fist(s: HandShape, p: GestureParams) -> float:
    return _least(*(p.clenched.of(bend) for bend in s.bend), p.thumb_near.of(s.thumb_off))


def _point(s: HandShape, p: GestureParams) -> float:
    """The index finger alone: OpenXR's aim."""
    return _least(p.straight.of(s.bend[0]), *(p.curled.of(bend) for bend in s.bend[1:]))


def _poke(s: HandShape, p: GestureParams) -> float:
    """The pointing finger is thrust ahead."""
    return _least(_point(s, p), p.thrust.of(s.thrust))


def _open_palm(s: HandShape, p: GestureParams) -> float:
    return _least(*(p.straight.of(bend) for bend in s.bend), p.thumb_straight.of(s.thumb_bend))


def _grasp(s: HandShape, p: GestureParams) -> float:
    """Fingers about an object, the thumb against them."""
    around = [_least(p.around.of(bend), p.not_clenched.of(bend)) for bend in s.bend]
    return _least(*around, p.opposed.of(s.across), p.apart.of(s.across))


def _least(*conditions: float) -> float:
    """NaN where one is unknown."""
    return math.nan if any(math.isnan(c) for c in conditions) else min(conditions)


_RULES: dict[str, Callable[[HandShape, GestureParams], float]] = {
    **{name: _pinch(i) for i, name in enumerate(PINCHES)},
    "thumb_up": _thumb_up,
    "fist": _fist,
    "point": _point,
    "open_palm": _open_palm,
    "grasp": _grasp,
    POKE: _poke,
}
