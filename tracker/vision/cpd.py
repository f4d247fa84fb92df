"""Coherent point drift in the two small forms that tracking needs.

A Gaussian mixture on one set is moved to fit the other by expectation and maximisation (Myronenko &
Song 2010, doi:10.1109/TPAMI.2010.46). Only points of one hue can correspond. Noise is given rather
than estimated where it is known, and the outlier term is a uniform density over a volume: the
w / N of eq. 2 of Lee et al. 2021 has no unit of density.
"""

from __future__ import annotations

import math

import numpy as np

from tracker.kernels import kernel
from tracker.messages import Array, IntArray


@kernel
def parallax_em(
    left: Array,
    left_hue: IntArray,
    right: Array,
    right_hue: IntArray,
    zeta: float,
    sd_u: tuple[float, float],
    sd_v: float,
    outlier: float,
    iterations: int,
) -> tuple[float, float]:
    """One horizontal parallax between two images: l_i = r_j + (zeta, 0). Pixels, rectified.

    left (n, 2), right (m, 2). The SD along u is estimated within ``sd_u`` = (least, most) and
    starts at the most: a hand spans 10 to 20 px of disparity, so it must not collapse. ``outlier``
    is the mixture's share of blobs without a partner. Returns zeta and the SD.
    """
    s = sd_u[1]
    # an outlier is uniform over the ellipse of three SD about the expected place
    floor = outlier / (1.0 - outlier) * 2.0 / 9.0
    for _ in range(iterations):
        sum_p, sum_pu, sum_puu = 0.0, 0.0, 0.0
        for i in range(len(left)):
            total, total_u, total_uu = 0.0, 0.0, 0.0
            for j in range(len(right)):
                if left_hue[i] != right_hue[j]:
                    continue
                dv = (left[i, 1] - right[j, 1]) / sd_v
                if abs(dv) > 4.0:
                    continue
                du = left[i, 0] - right[j, 0]
                e = (du - zeta) / s
                g = math.exp(-0.5 * (e * e + dv * dv))
                total += g
                total_u += g * du
                total_uu += g * du * du
            total_p = total + floor
            sum_p += total / total_p
            sum_pu += total_u / total_p
            sum_puu += total_uu / total_p
        if sum_p < 1e-9:
            break
        zeta = sum_pu / sum_p
        s = min(max(math.sqrt(max(sum_puu / sum_p - zeta * zeta, 0.0)), sd_u[0]), sd_u[1])
    return zeta, s


@kernel
def translation_em(
    points: Array,
    hue: IntArray,
    cov: Array,
    markers: Array,
    marker_hue: IntArray,
    prior: Array,
    outlier: float,
    volume: float,
    spread: tuple[float, float],
    iterations: int,
) -> tuple[Array, Array]:
    """One 3-DOF translation between expected markers and points seen: o_i ~ N(m_j + eta, C_i).

    points (n, 3) with noise cov (n, 3, 3), markers (m, 3) with prior (m,) that sums to one within
    each hue. C_i = cov_i + s² I, where s falls from spread[0] to spread[1] geometrically. The
    outlier density is outlier / volume (eq. 2). Returns eta (3,) and the posterior P (n, m) of the
    last expectation.
    """
    n, m = len(points), len(markers)
    P = np.zeros((n, m))
    eta, inverse = np.zeros(3), np.empty((3, 3))
    information, weighted = np.empty((3, 3)), np.empty(3)
    factor = (spread[1] / spread[0]) ** (1.0 / max(iterations - 1, 1))
    s = spread[0]
    for step in range(iterations + 1):
        information[:] = 0.0
        weighted[:] = 0.0
        for i in range(n):
            det = _inverse3(cov[i], s * s, inverse)
            scale = (1.0 - outlier) / math.sqrt((2.0 * math.pi) ** 3 * det)
            total = outlier / volume + _expect(
                P[i], points[i], hue[i], markers, marker_hue, prior, eta, inverse, scale
            )
            _maximise(P[i], total, inverse, points[i], markers, information, weighted)
        if step < iterations:
            if information[0, 0] < 1e-9:
                break
            _solve3(information, weighted, eta)
            s = max(s * factor, spread[1])
    return eta, P


@kernel
def _expect(
    row: Array,
    point: Array,
    hue: int,
    markers: Array,
    marker_hue: IntArray,
    prior: Array,
    eta: Array,
    W: Array,
    scale: float,
) -> float:
    """row[j] = (1 - w) p(m_j) N(o; m_j + eta, W^-1), eqs. 2 and 3 before division; their sum."""
    total = 0.0
    for j in range(len(markers)):
        row[j] = 0.0
        if marker_hue[j] != hue or prior[j] <= 0.0:
            continue
        x = point[0] - markers[j, 0] - eta[0]
        y = point[1] - markers[j, 1] - eta[1]
        z = point[2] - markers[j, 2] - eta[2]
        d2 = W[0, 0] * x * x + W[1, 1] * y * y + W[2, 2] * z * z
        d2 += 2.0 * (W[0, 1] * x * y + W[0, 2] * x * z + W[1, 2] * y * z)
        if d2 < 80.0:  # beyond, the density is nothing beside the outliers'
            row[j] = scale * prior[j] * math.exp(-0.5 * d2)
            total += row[j]
    return total


@kernel
def _maximise(
    row: Array,
    total: float,
    W: Array,
    point: Array,
    markers: Array,
    information: Array,
    weighted: Array,
) -> None:
    """Divide the row by ``total``; add sum p W and W sum p (o - m) to eta's normal equations."""
    mass, x, y, z = 0.0, 0.0, 0.0, 0.0
    for j in range(len(markers)):
        if row[j] > 0.0:
            row[j] /= total
            mass += row[j]
            x += row[j] * (point[0] - markers[j, 0])
            y += row[j] * (point[1] - markers[j, 1])
            z += row[j] * (point[2] - markers[j, 2])
    for r in range(3):
        for c in range(3):
            information[r, c] += mass * W[r, c]
        weighted[r] += W[r, 0] * x + W[r, 1] * y + W[r, 2] * z


@kernel
def _inverse3(cov: Array, extra: float, out: Array) -> float:
    """out = (cov + extra I)^-1 of a symmetric matrix by cofactors; returns the determinant."""
    a, b, c = cov[0, 0] + extra, cov[0, 1], cov[0, 2]
    d, e, f = cov[1, 1] + extra, cov[1, 2], cov[2, 2] + extra
    A, B, C = d * f - e * e, c * e - b * f, b * e - c * d
    det = a * A + b * B + c * C
    out[0, 0], out[0, 1], out[0, 2] = A / det, B / det, C / det
    out[1, 0], out[1, 1], out[1, 2] = B / det, (a * f - c * c) / det, (b * c - a * e) / det
    out[2, 0], out[2, 1], out[2, 2] = C / det, out[1, 2], (a * d - b * b) / det
    return det


@kernel
def _solve3(M: Array, y: Array, out: Array) -> None:
    """out = M^-1 y of a symmetric positive definite M."""
    inverse = np.empty((3, 3))
    _inverse3(M, 0.0, inverse)
    for r in range(3):
        out[r] = inverse[r, 0] * y[0] + inverse[r, 1] * y[1] + inverse[r, 2] * y[2]
