"""Confidence of a recognised gesture: how well the sensors determine it, not how pronounced it is.

A finger without a sensor is inferred from the others, and its pinch cannot be distinguished from
its neighbour's; the confidence follows from the standard deviations of the estimate.
"""

from __future__ import annotations

import math

from tracker.gestures.shape import GestureShape
from tracker.gestures.values import ENDS_AT, PINCHES, GestureParams

LEAST_SD = 1e-4  # m


def confidence(gesture: str, shape: GestureShape, params: GestureParams) -> float:
    """0 to 1. Of a pinch: the probability that pads are within reach of one another, and that no
    other finger's are nearer, as if the gaps' errors were normal and apart. Of the others: the
    share of the fingers that sensors tell. 0 where a part is lost."""
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
