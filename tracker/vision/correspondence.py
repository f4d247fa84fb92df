"""Which blob is which marker, with the filter's prediction as guide.

`assign_gated` works on one picture: an optimal assignment under Mahalanobis distance.
`match_translation` works on stereo points as Lee et al. 2021 do (eqs. 1 to 3): a 3-DOF CPD.
"""

from __future__ import annotations

from dataclasses import dataclass

import numba
import numpy as np
from scipy.optimize import linear_sum_assignment

from tracker.messages import Array, IntArray
from tracker.vision.visibility import HandShape, VisibilityParams, both_cameras, visibility

__all__ = [
    "GateParams",
    "HandShape",
    "VisibilityParams",
    "assign_gated",
    "both_cameras",
    "visibility",
]

FORBIDDEN = 1e6  # a cost that no dummy lets through


@dataclass(frozen=True)
class GateParams:
    """Limits of the assignment in one picture."""

    gate: float = 18.0  # Mahalanobis² of two degrees of freedom
    gate_px: float = 80.0
    dummy_cost: float = 16.0  # of leaving a blob unexplained
    min_prior: float = 1e-3  # keeps ln p finite


def assign_gated(
    uv: Array,
    hue: IntArray,
    predicted_uv: Array,
    S: Array,
    marker_hue: IntArray,
    prior: Array,
    params: GateParams | None = None,
) -> IntArray:
    """The blob (M,) of each marker of one image, -1 for none.

    uv (n, 2) px and hue (n,) of the blobs; predicted_uv (M, 2) px, innovation covariance
    S (M, 2, 2) px², marker_hue (M,) and prior (M,). The sum over pairs of
    Mahalanobis² + ln det S - 2 ln p is least, and a blob may stay alone at ``dummy_cost``.
    """
    params = params or GateParams()
    out = np.full(len(predicted_uv), -1, np.int64)
    if len(uv) == 0 or len(predicted_uv) == 0:
        return out
    cost = _gated_costs(
        np.ascontiguousarray(uv, float),
        hue,
        np.ascontiguousarray(predicted_uv, float),
        np.ascontiguousarray(S, float),
        marker_hue,
        np.maximum(prior, params.min_prior),
        params.gate,
        params.gate_px,
    )
    _assign(cost, params.dummy_cost, out)
    return out


def _assign(cost: Array, dummy_cost: float, out: IntArray) -> None:
    """Fills out (M,) with the row of cost (n, M) chosen for each column."""
    useful = cost < dummy_cost  # a dearer pair is never better than two lone ones
    rows = np.flatnonzero(useful.any(axis=1))
    columns = np.flatnonzero(useful.any(axis=0))
    if len(rows) == 0:
        return
    small = cost[np.ix_(rows, columns)]
    padded = np.concatenate([small, np.full((len(rows), len(rows)), dummy_cost)], axis=1)
    chosen_rows, chosen = linear_sum_assignment(padded)
    real = chosen < len(columns)
    out[columns[chosen[real]]] = rows[chosen_rows[real]]


@numba.njit(cache=True, nogil=True)
def _gated_costs(
    uv: Array,
    hue: IntArray,
    predicted: Array,
    S: Array,
    marker_hue: IntArray,
    prior: Array,
    gate: float,
    gate_px: float,
) -> Array:
    """(n, M) costs; FORBIDDEN between hues and outside the gates."""
    cost = np.full((len(uv), len(predicted)), FORBIDDEN)
    for j in range(len(predicted)):
        a, b, c = S[j, 0, 0], S[j, 0, 1], S[j, 1, 1]
        det = a * c - b * b
        if not det > 0:
            continue
        base = np.log(det) - 2.0 * np.log(prior[j])
        for i in range(len(uv)):
            if hue[i] != marker_hue[j]:
                continue
            du, dv = uv[i, 0] - predicted[j, 0], uv[i, 1] - predicted[j, 1]
            d2 = (c * du * du - 2.0 * b * du * dv + a * dv * dv) / det
            if d2 < gate and du * du + dv * dv < gate_px * gate_px:
                cost[i, j] = d2 + base
    return cost
