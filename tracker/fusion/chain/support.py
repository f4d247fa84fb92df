"""How well an image supports a pose: markers that are there, and how many chance would put there.

Among many blobs of the room a wrong pose finds company too. What it finds by chance is known from
how dense the blobs are and how wide the gates: only what goes beyond that speaks for the pose. Each
digit is judged by itself, for a hand may stand right with its thumb elsewhere.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.pixels import GATE_PX, GATE_SQUARED, SeenBlobs, Tally
from tracker.fusion.chain.prediction import Prediction
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Vector
from tracker.messages import IntArray

AROUND_PX = 60.0  # beyond the expected markers, where blobs are counted
LIKELY = 0.3  # prior of a marker that has a say in where the hand is
LEAST_CHANCE = 0.5  # markers: sd² of what chance finds where there is next to nothing
SURELY = 3.0  # standard deviations beyond chance
CROWDED = 2.0  # blobs in an image for each expected marker
CROWDED_SHARE = 0.4  # of the expected markers, among many blobs
START_SHARE, CROWDED_START_SHARE = 0.45, 0.62  # the same for a hand found from nothing
DIGIT_SHARE = 0.34  # of a digit's expected markers
LIKELY_SHARE = 0.25  # of the expected markers, for a hand that is called measured
LEAST_DIGIT = 1.5  # expected markers of a digit, to judge it at all


class Evidence(NamedTuple):
    """What an image says of a pose: markers ``matched`` in at least one camera and ``expected``
    (the priors' sum); ``chance``: how many blobs would match anywhere else; ``crowd``: blobs of an
    image for each expected marker. Per digit (D,) matched and expected."""

    matched: int
    expected: float
    chance: float
    crowd: float
    digit_matched: Vector
    digit_expected: Vector

    @property
    def share(self) -> float:
        """Of the expected markers."""
        return self.matched / max(self.expected, 1.0)

    @property
    def is_credible(self) -> bool:
        """Whether more markers are there than chance explains; where blobs are few, it is asked
        nothing."""
        if self.crowd < CROWDED:
            return True
        beyond = SURELY * float(np.sqrt(max(self.chance, LEAST_CHANCE)))
        return self.share >= CROWDED_SHARE and self.matched - self.chance >= beyond

    @property
    def is_start(self) -> bool:
        """Whether a pose that was searched for, and so finds the best that chance offers, is it."""
        crowded = min(max(self.crowd - 1.0, 0.0), 1.0)
        return self.share >= START_SHARE + crowded * (CROWDED_START_SHARE - START_SHARE)

    @property
    def tally(self) -> Tally:
        """How many of how many."""
        return Tally(self.matched, self.expected)

    @property
    def is_likely(self) -> bool:
        """Whether a good part of the markers that should be seen are."""
        return self.share >= LIKELY_SHARE

    @property
    def unsupported(self) -> IntArray:
        """Digits that should be seen and are not."""
        poor = self.digit_matched < DIGIT_SHARE * self.digit_expected
        return np.flatnonzero(poor & (self.digit_expected >= LEAST_DIGIT))

    @property
    def supported(self) -> IntArray:
        """Digits of which markers are seen as they should be."""
        rich = self.digit_matched >= DIGIT_SHARE * self.digit_expected
        return np.flatnonzero(rich & (self.digit_matched > 0))


@kernel(nogil=False)
def evidence(
    prediction: Prediction,
    match: IntMatrix,
    left: SeenBlobs,
    right: SeenBlobs,
    marker_hue: IntVector,
    marker_digit: IntVector,
    digits: int,
) -> tuple[int, float, float, float, Vector, Vector]:
    """The fields of `Evidence` of markers matched (2, M); marker_digit (M,) -1 for the root's."""
    prior, rows = prediction.prior, prediction.rows
    digit_matched, digit_expected = np.zeros(digits), np.zeros(digits)
    matched, expected = 0, 0.0
    for j in range(match.shape[1]):
        likely = max(prior[0, j], prior[1, j])
        there = match[0, j] >= 0 or match[1, j] >= 0
        matched += there
        expected += likely
        if marker_digit[j] >= 0:
            digit_matched[marker_digit[j]] += there
            digit_expected[marker_digit[j]] += likely
    alone, crowd = np.ones(len(rows)), 0.0
    for c in range(2):
        seen = right if c else left
        crowd = max(crowd, len(seen.uv) / max(expected, 1.0))
        density = _densities(prediction, c, seen, marker_hue)
        for k in range(len(rows)):
            S = prediction.S[c, k]
            spread = np.sqrt(max(S[0, 0] * S[1, 1] - S[0, 1] * S[1, 0], 0.0))
            area = np.pi * min(GATE_SQUARED * spread, GATE_PX**2)
            p = 1.0 - np.exp(-density[marker_hue[rows[k]]] * area)
            alone[k] *= 1.0 - p * prior[c, rows[k]]
    return matched, expected, float(np.sum(1.0 - alone)), crowd, digit_matched, digit_expected


@kernel
def _densities(prediction: Prediction, c: int, seen: SeenBlobs, marker_hue: IntVector) -> Vector:
    """(hues,) blobs per px² around the hand, beyond half of the markers expected there."""
    prior, uv = prediction.prior[c], prediction.uv[c]
    out = np.zeros(marker_hue.max() + 1)
    u0, v0, u1, v1 = np.inf, np.inf, -np.inf, -np.inf
    for j in range(len(uv)):
        if prior[j] >= LIKELY:
            u0, v0 = min(u0, uv[j, 0]), min(v0, uv[j, 1])
            u1, v1 = max(u1, uv[j, 0]), max(v1, uv[j, 1])
            out[marker_hue[j]] -= 0.5 * prior[j]
    if not u1 >= u0:
        return np.zeros_like(out)
    u0, v0, u1, v1 = u0 - AROUND_PX, v0 - AROUND_PX, u1 + AROUND_PX, v1 + AROUND_PX
    for i in range(len(seen.uv)):
        u, v = seen.uv[i, 0], seen.uv[i, 1]
        if u0 <= u <= u1 and v0 <= v <= v1 and seen.hue[i] < len(out):
            out[seen.hue[i]] += 1.0
    return np.maximum(out, 0.0) / ((u1 - u0) * (v1 - v0))
