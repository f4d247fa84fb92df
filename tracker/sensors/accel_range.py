"""The accelerometers' range of a glove that has not said it, from gravity.

At rest |a| is 1 g, so the raw value is 32768 / range: neighbouring ranges differ by a factor of
two, which no bias hides. The gyroscopes' range cannot be told from rest.
"""

from __future__ import annotations

import math
from collections import Counter, deque

import numpy as np

from tracker.messages import Array

RANGES_G = (2, 4, 8, 16)  # of the MPU-9250
SPAN = 0.5  # s of rest
STEADY = 0.05  # sd of |a| over its mean, at rest: a hand that is held still, not one laid down
WITHIN = math.log2(1.15)  # octaves; half an octave would be as near to the next range
AGREEING = 0.75  # share of the IMUs that have to say the same
FEWEST = 10  # packets


class RangeFromRest:
    """Looks at raw samples until the glove has been still for `SPAN`."""

    def __init__(self) -> None:
        self._recent: deque[tuple[float, Array]] = deque()

    def look(self, raw: Array, t: float) -> int | None:
        """Take raw accelerations (n, 3) of time ``t`` (s). The range in g, None while not known."""
        self._recent.append((t, np.linalg.norm(raw, axis=1)))
        while t - self._recent[0][0] > SPAN:
            self._recent.popleft()
        if len(self._recent) < FEWEST or t - self._recent[0][0] < 0.9 * SPAN:
            return None
        norms = np.array([row for _, row in self._recent])
        return _common_range(norms.mean(axis=0), norms.std(axis=0))


def _common_range(mean: Array, sd: Array) -> int | None:
    """The range in which most IMUs feel 1 g; those that give zeros have no voice."""
    answering = mean > 0
    if not answering.any() or np.any(sd[answering] > STEADY * mean[answering]):
        return None
    votes = Counter(_fitting(float(m)) for m in mean[answering])
    best, count = votes.most_common(1)[0]
    return best if count >= AGREEING * np.count_nonzero(answering) else None


def _fitting(counts: float) -> int | None:
    """The range in which ``counts`` is 1 g; None where none fits."""
    for range_g in RANGES_G:
        if abs(math.log2(counts * range_g / 32768)) < WITHIN:
            return range_g
    return None
