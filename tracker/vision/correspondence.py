"""Matching of blobs with markers, guided by the filter's prediction.

`assigned` works on one image: an optimal assignment under Mahalanobis distance.
`match_translation` works on stereo points as Lee et al. 2021 do (eqs. 1 to 3): a 3-DOF CPD.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Stack, Vector
from tracker.messages import Array, IntArray
from tracker.vision.assignment import assign
from tracker.vision.cpd import (
    ExpectedMarkers,
    HuedPixels,
    HuedPoints,
    TranslationMixture,
    translation_em,
)

FORBIDDEN = 1e6  # a cost above that of any dummy


@dataclass(frozen=True)
class GateParams:
    """Limits of the assignment in one image."""

    gate: float = 18.0  # Mahalanobis² of two degrees of freedom
    gate_px: float = 80.0
    dummy_cost: float = 16.0  # of leaving a blob unmatched
    min_prior: float = 1e-3  # keeps ln p finite


class ExpectedPixels(NamedTuple):
    """Predicted markers in one image: uv (m, 2) px, innovation covariance S (m, 2, 2), hue (m,),
    and prior (m,) of visibility, above zero."""

    uv: Matrix
    S: Stack
    hue: IntVector
    prior: Vector


@kernel(nogil=False)
def misfit(left: Matrix, right: Matrix, match: IntMatrix, uv: Stack) -> float:
    """px, the median distance of the blobs of the left and right image from the predictions uv
    (2, M, 2) of the markers that match (2, M) assigns; infinite without matches."""
    apart = np.empty(match.size)
    n = 0
    for c in range(2):
        blobs = left if c == 0 else right
        for m in range(match.shape[1]):
            k = match[c, m]
            if k >= 0:
                u, v = blobs[k, 0] - uv[c, m, 0], blobs[k, 1] - uv[c, m, 1]
                apart[n] = np.sqrt(u * u + v * v)
                n += 1
    if n == 0:
        return np.inf
    ordered = np.sort(apart[:n])
    return float((ordered[(n - 1) // 2] + ordered[n // 2]) / 2.0)


@kernel
def assigned(
    blobs: HuedPixels, markers: ExpectedPixels, gate: float, gate_px: float, dummy_cost: float
) -> IntVector:
    """The optimal assignment among pairs of lower cost than leaving both unmatched; (m,) blobs."""
    cost = _gated_costs(blobs, markers, gate, gate_px)
    out = assign(cost, dummy_cost)
    for j in range(len(out)):
        if out[j] >= 0 and cost[out[j], j] >= dummy_cost:
            out[j] = -1
    return out


@kernel
def _gated_costs(blobs: HuedPixels, markers: ExpectedPixels, gate: float, gate_px: float) -> Matrix:
    """(n, m) costs; FORBIDDEN between hues and outside the gates."""
    uv, hue, predicted, S = blobs.uv, blobs.hue, markers.uv, markers.S
    cost = np.full((len(uv), len(predicted)), FORBIDDEN)
    for j in range(len(predicted)):
        a, b, c = S[j, 0, 0], S[j, 0, 1], S[j, 1, 1]
        det = a * c - b * b
        if not det > 0:
            continue
        base = np.log(det) - 2.0 * np.log(markers.prior[j])
        for i in range(len(uv)):
            if hue[i] != markers.hue[j]:
                continue
            du, dv = uv[i, 0] - predicted[j, 0], uv[i, 1] - predicted[j, 1]
            d2 = (c * du * du - 2.0 * b * du * dv + a * dv * dv) / det
            if d2 < gate and du * du + dv * dv < gate_px * gate_px:
                cost[i, j] = d2 + base
    return cost


@dataclass(frozen=True)
class TranslationParams:
    """CPD between stereo points and predicted markers."""

    outlier: float = 0.1  # w_c of eq. 2
    volume: float = 1e-3  # m³, over which an outlier is uniform
    sd_first: float = 0.012  # m, annealed
    sd_last: float = 0.004  # m
    iterations: int = 15
    min_posterior: float = 0.5  # of belonging to any marker
    max_distance: float = 0.020  # m from the shifted marker

    @cached_property
    def mixture(self) -> TranslationMixture:
        """The parameters of the EM."""
        return TranslationMixture(
            self.outlier, self.volume, self.sd_first, self.sd_last, self.iterations
        )


@dataclass(frozen=True, eq=False)
class TranslationMatch:
    """marker (n,) of each point, -1 for none; eta (3,) m the common shift; posterior (n,)."""

    marker: IntArray
    eta: Array
    posterior: Array


def match_translation(
    points_G: Array,
    hue: IntArray,
    markers_G: Array,
    marker_hue: IntArray,
    prior: Array,
    cov: Array,
    params: TranslationParams | None = None,
) -> TranslationMatch:
    """Matches stereo points with markers by 3-DOF CPD per hue (Lee et al. 2021, eqs. 1 to 3).

    points_G (n, 3) and markers_G (M, 3) m, prior (M,) of being seen by both cameras, cov (3, 3) or
    (n, 3, 3) m² the noise of triangulation in G. A point is assigned its most likely marker; of
    several points on one marker the nearest is used. ``eta`` serves the assignment only.
    """
    params = params or TranslationParams()
    n = len(points_G)
    if n == 0 or len(markers_G) == 0:
        return TranslationMatch(np.full(n, -1, np.int64), np.zeros(3), np.zeros(n))
    points, markers = np.ascontiguousarray(points_G, float), np.ascontiguousarray(markers_G, float)
    each = np.ascontiguousarray(np.broadcast_to(cov, (n, 3, 3)), float)
    eta, P = translation_em(
        HuedPoints(points, hue, each),
        ExpectedMarkers(markers, marker_hue, normalised(prior, marker_hue)),
        params.mixture,
    )
    marker, posterior = _likeliest(
        P, points, markers, eta, params.min_posterior, params.max_distance
    )
    return TranslationMatch(marker, eta, posterior)


@kernel
def normalised(prior: Vector, hue: IntVector) -> Vector:
    """Priors normalised to a sum of one within each hue; a hue of zeros is unchanged."""
    out = np.zeros(len(prior))
    for j in range(len(prior)):
        total = 0.0
        for k in range(len(prior)):
            if hue[k] == hue[j]:
                total += prior[k]
        if total > 0:
            out[j] = prior[j] / total
    return out


@kernel
def _likeliest(
    P: Matrix, points: Matrix, markers: Matrix, eta: Vector, min_posterior: float, reach: float
) -> tuple[IntVector, Vector]:
    """MAP marker of each point within the limits, each marker assigned once."""
    n, m = P.shape
    out, posterior = np.full(n, -1, np.int64), np.zeros(n)
    owner, least = np.full(m, -1, np.int64), np.full(m, reach)
    for i in range(n):
        j = np.argmax(P[i])
        posterior[i] = P[i].sum()
        distance = np.sqrt(((points[i] - markers[j] - eta) ** 2).sum())
        if posterior[i] <= min_posterior or distance >= least[j]:
            continue
        if owner[j] >= 0:
            out[owner[j]] = -1
        out[i], owner[j], least[j] = j, i, distance
    return out, posterior
