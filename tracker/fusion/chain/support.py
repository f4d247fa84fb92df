"""How well an image supports a pose: matched markers compared with chance matches.

Among many blobs of the background a wrong pose finds matches too. Their expected number follows
from the density of the blobs and the size of the gates: only the excess supports the pose. Each
digit is evaluated separately, since a hand may be correct except for its thumb.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.pixels import GATE_PX, GATE_SQUARED, SeenBlobs, Tally
from tracker.fusion.chain.prediction import Prediction
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Vector
from tracker.messages import IntArray

AROUND_PX = 60.0  # beyond the expected markers, area in which blobs are counted
LIKELY = 0.3  # prior of a marker that counts as evidence for the position
LEAST_CHANCE = 0.5  # markers: sd² of chance matches where there are hardly any blobs
SURELY = 3.0  # standard deviations above chance
CROWDED = 2.0  # blobs in an image per expected marker
CROWDED_SHARE = 0.4  # of the expected markers, where there are many blobs
START_SHARE, CROWDED_START_SHARE = 0.45, 0.62  # likewise for a hand found without a prior
DIGIT_SHARE = 0.34  # of a digit's expected markers
LIKELY_SHARE = 0.25  # of the expected markers, for the state MEASURED
LEAST_DIGIT = 1.5  # expected markers of a digit required to evaluate it


class Evidence(NamedTuple):
    """Evidence of an image for a pose: markers ``matched`` in at least one camera and ``expected``
    (the priors' sum); ``chance``: expected number of chance matches; ``crowd``: blobs of an image
    per expected marker. Per digit (D,) matched and expected."""

    matched: int
    expected: float
    chance: float
    crowd: float
    digit_matched: Vector
    digit_expected: Vector

    @property
    def share(self) -> float:
        """Matched share of the expected markers."""
        return self.matched / max(self.expected, 1.0)

    @property
    def is_credible(self) -> bool:
        """Whether more markers match than chance explains; always true where blobs are few."""
        if self.crowd < CROWDED:
            return True
        beyond = SURELY * float(np.sqrt(max(self.chance, LEAST_CHANCE)))
        return self.share >= CROWDED_SHARE and self.matched - self.chance >= beyond

    @property
    def is_start(self) -> bool:
        """Whether a pose found by a search, which maximises chance matches, is accepted."""
        crowded = min(max(self.crowd - 1.0, 0.0), 1.0)
        return self.share >= START_SHARE + crowded * (CROWDED_START_SHARE - START_SHARE)

    @property
    def tally(self) -> Tally:
        """Matched and expected markers."""
        return Tally(self.matched, self.expected)

    @property
    def is_likely(self) -> bool:
        """Whether enough of the expected markers are matched."""
        return self.share >= LIKELY_SHARE

    @property
    def unsupported(self) -> IntArray:
        """Digits that should be visible but are not matched."""
        poor = self.digit_matched < DIGIT_SHARE * self.digit_expected
        return np.flatnonzero(poor & (self.digit_expected >= LEAST_DIGIT))

    @property
    def supported(self) -> IntArray:
        """Digits whose markers are matched as expected."""
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
    """(hues,) blobs per px² around the hand, not counting half of the expected markers."""
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
