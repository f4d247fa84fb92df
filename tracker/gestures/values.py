"""The value of each gesture for a shape, from 0 to 1.

OpenXR's XR_EXT_hand_interaction defines such values for pinch, grasp, aim and poke; the others are
common in the field. A value is the minimum of its conditions, each a ramp over the human range, so
values are continuous and each threshold is defined once.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from tracker.gestures.shape import GestureShape
from tracker.hand.names import FINGERS

PINCHES = tuple(f"pinch_{finger}" for finger in FINGERS)
POSTURES = ("thumb_up", "fist", "point", "open_palm", "grasp")
"""At most one of these is active at a time; earlier ones are more specific."""
POKE = "poke"
"""Performed in addition to pointing."""
GESTURES = (*PINCHES, *POSTURES, POKE)
BEGINS_AT, ENDS_AT = 0.6, 0.3
"""Values at which a gesture begins and ends."""


class Ramp(NamedTuple):
    """0 at ``none`` and beyond, 1 at ``full`` and beyond; either may be the larger."""

    none: float
    full: float

    def of(self, x: float) -> float:
        """NaN of NaN."""
        none, full = self
        share = (x - none) / (full - none)
        if share < 0.0:
            return 0.0
        return 1.0 if share > 1.0 else share


class GestureParams(NamedTuple):
    """Angles are sums of a finger's flexions. The guided poses (a fist of 235° and straight fingers
    within 15°) are well within the range; free motion is mostly in between."""

    clenched: Ramp = Ramp(math.radians(140.0), math.radians(195.0))
    curled: Ramp = Ramp(math.radians(110.0), math.radians(165.0))  # next to a pointing finger
    straight: Ramp = Ramp(math.radians(75.0), math.radians(35.0))
    around: Ramp = Ramp(math.radians(40.0), math.radians(90.0))  # around an object
    not_clenched: Ramp = Ramp(math.radians(205.0), math.radians(165.0))
    thumb_straight: Ramp = Ramp(math.radians(65.0), math.radians(35.0))
    thumb_away: Ramp = Ramp(0.040, 0.058)  # m from the index finger's bones
    thumb_near: Ramp = Ramp(0.060, 0.048)
    opposed: Ramp = Ramp(0.110, 0.085)  # m between the tips of thumb and middle finger
    apart: Ramp = Ramp(0.015, 0.030)  # and not yet closed
    touching: Ramp = Ramp(0.030, 0.004)  # m between pads
    thrust: Ramp = Ramp(0.010, 0.025)  # m forward in 0.2 s


def values(shape: GestureShape, params: GestureParams) -> dict[str, float]:
    """Values of all `GESTURES`; NaN if a feature of the gesture is lost.

    Runs in the tracking thread for each packet, so shared features are computed once.
    """
    s, p = shape, params
    straight, curled = [p.straight.of(b) for b in s.bend], [p.curled.of(b) for b in s.bend]
    thumb_straight = p.thumb_straight.of(s.thumb_bend)
    clenched = [p.clenched.of(b) for b in s.bend]
    around = [_least(p.around.of(b), p.not_clenched.of(b)) for b in s.bend]
    point = _least(straight[0], *curled[1:])  # the index finger alone: OpenXR's aim
    return {
        **{name: _pinch(i, s, p) for i, name in enumerate(PINCHES)},
        "thumb_up": _least(*curled, thumb_straight, p.thumb_away.of(s.thumb_off)),
        "fist": _least(*clenched, p.thumb_near.of(s.thumb_off)),
        "point": point,
        "open_palm": _least(*straight, thumb_straight),
        # fingers around an object, with the thumb opposed
        "grasp": _least(*around, p.opposed.of(s.across), p.apart.of(s.across)),
        POKE: _least(point, p.thrust.of(s.thrust)),  # thrust of the pointing finger
    }


def _pinch(finger: int, s: GestureShape, p: GestureParams) -> float:
    """In a fist a finger's pad touches the palm, not the thumb's pad; if the other fingers are
    extended it may be bent as far, and pinches."""
    others = (sum(s.bend) - s.bend[finger]) / (len(s.bend) - 1)
    bend = _least(s.bend[finger], others)
    return _least(p.touching.of(s.gap[finger]), p.not_clenched.of(bend))


def _least(*conditions: float) -> float:
    """NaN where any is unknown."""
    least = math.inf
    for condition in conditions:
        if math.isnan(condition):
            return math.nan
        if condition < least:
            least = condition
    return least
