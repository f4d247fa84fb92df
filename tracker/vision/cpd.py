"""Coherent point drift in two specialised forms.

A Gaussian mixture on one set is moved to fit the other by expectation and maximisation (Myronenko &
Song 2010, doi:10.1109/TPAMI.2010.46). Only points of one hue can correspond. Noise is given rather
than estimated where it is known, and the outlier term is a uniform density over a volume: the w / N
of eq. 2 of Lee et al. 2021 does not have the unit of a density.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector, Written


class HuedPixels(NamedTuple):
    """Blobs of an image: uv (n, 2) px and hue (n,)."""

    uv: Matrix
    hue: IntVector


class HuedPoints(NamedTuple):
    """Measured points: p (n, 3) m, hue (n,), and the noise cov (n, 3, 3) m²."""

    p: Matrix
    hue: IntVector
    cov: Stack


class ExpectedMarkers(NamedTuple):
    """Predicted markers: p (m, 3) m, hue (m,), and prior (m,) that sums to one within each hue."""

    p: Matrix
    hue: IntVector
    prior: Vector


class ParallaxMixture(NamedTuple):
    """Parameters of `parallax_em`: minimum and maximum sd along u and the sd along v, px; the share
    ``outlier`` of unmatched blobs; number of iterations."""

    sd_u_min: float
    sd_u_max: float
    sd_v: float
    outlier: float
    iterations: int


class TranslationMixture(NamedTuple):
    """Parameters of `translation_em`: the share ``outlier`` (w_c of eq. 2), uniform over ``volume``
    m³; the first and last sd added to the noise, m; number of iterations."""

    outlier: float
    volume: float
    sd_first: float
    sd_last: float
    iterations: int


@kernel
def parallax_em(
    left: HuedPixels, right: HuedPixels, zeta: float, mixture: ParallaxMixture
) -> tuple[float, float]:
    """One horizontal parallax between two images: l_i = r_j + (zeta, 0). Pixels, rectified.

    It starts at ``zeta``, and the sd along u at its maximum: a hand spans 10 to 20 px of disparity,
    so it must not collapse. Returns zeta and that sd.
    """
    l_uv, l_hue, r_uv, r_hue = left.uv, left.hue, right.uv, right.hue
    s, sd_v = mixture.sd_u_max, mixture.sd_v
    # an outlier is uniform over the ellipse of three sd about the predicted position
    floor = mixture.outlier / (1.0 - mixture.outlier) * 2.0 / 9.0
    for _ in range(mixture.iterations):
        # 1. expectation: each left blob's posterior over its partners, as sums over p, p u, p u²
        sum_p, sum_pu, sum_puu = 0.0, 0.0, 0.0
        for i in range(len(l_uv)):
            total, total_u, total_uu = 0.0, 0.0, 0.0
            for j in range(len(r_uv)):
                if l_hue[i] != r_hue[j]:
                    continue
                dv = (l_uv[i, 1] - r_uv[j, 1]) / sd_v
                if abs(dv) > 4.0:
                    continue
                du = l_uv[i, 0] - r_uv[j, 0]
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
        # 2. maximisation: mean and sd of the disparity
        zeta = sum_pu / sum_p
        sd = math.sqrt(max(sum_puu / sum_p - zeta * zeta, 0.0))
        s = min(max(sd, mixture.sd_u_min), mixture.sd_u_max)
    return zeta, s


@kernel
def translation_em(
    points: HuedPoints, markers: ExpectedMarkers, mixture: TranslationMixture
) -> tuple[Vector, Matrix]:
    """One 3-DOF translation between predicted markers and measured points: o_i ~ N(m_j + eta, C_i).

    C_i = cov_i + s² I, where s decreases from sd_first to sd_last geometrically. The outlier
    density is outlier / volume (eq. 2). Returns eta (3,) m and the posterior P (n, m) of the last
    expectation.
    """
    n, outlier, iterations = len(points.p), mixture.outlier, mixture.iterations
    p, hue, cov = points.p, points.hue, points.cov
    P = np.zeros((n, len(markers.p)))
    eta, inverse = np.zeros(3), np.empty((3, 3))
    information, weighted = np.empty((3, 3)), np.empty(3)
    factor = (mixture.sd_last / mixture.sd_first) ** (1.0 / max(iterations - 1, 1))
    s, uniform = mixture.sd_first, outlier / mixture.volume
    for step in range(iterations + 1):
        information[:] = 0.0
        weighted[:] = 0.0
        for i in range(n):
            # 1. the Gaussian about each marker, from this point's noise and the annealed sd
            det = _inverse3(cov[i], s * s, inverse)
            scale = (1.0 - outlier) / math.sqrt((2.0 * math.pi) ** 3 * det)
            # 2. expectation: the point's posterior over markers and outliers, eqs. 2 and 3
            total = uniform + _expect(P[i], p[i], hue[i], markers, eta, inverse, scale)
            # 3. its contribution to the normal equations of eta
            _maximise(P[i], total, inverse, p[i], markers.p, information, weighted)
        if step < iterations:
            if information[0, 0] < 1e-9:
                break
            # 4. maximisation, and a narrower Gaussian
            _solve3(information, weighted, eta)
            s = max(s * factor, mixture.sd_last)
    return eta, P


@kernel
def _expect(
    row: Written[Vector],
    point: Vector,
    hue: int,
    markers: ExpectedMarkers,
    eta: Vector,
    W: Matrix,
    scale: float,
) -> float:
    """row[j] = (1 - w) p(m_j) N(o; m_j + eta, W^-1), eqs. 2 and 3 before division; their sum."""
    total, p, marker_hue, prior = 0.0, markers.p, markers.hue, markers.prior
    for j in range(len(p)):
        row[j] = 0.0
        if marker_hue[j] != hue or prior[j] <= 0.0:
            continue
        x = point[0] - p[j, 0] - eta[0]
        y = point[1] - p[j, 1] - eta[1]
        z = point[2] - p[j, 2] - eta[2]
        d2 = W[0, 0] * x * x + W[1, 1] * y * y + W[2, 2] * z * z
        d2 += 2.0 * (W[0, 1] * x * y + W[0, 2] * x * z + W[1, 2] * y * z)
        if d2 < 80.0:  # beyond, the density is negligible compared with the outliers'
            row[j] = scale * prior[j] * math.exp(-0.5 * d2)
            total += row[j]
    return total


@kernel
def _maximise(
    row: Written[Vector],
    total: float,
    W: Matrix,
    point: Vector,
    markers: Matrix,
    information: Written[Matrix],
    weighted: Written[Vector],
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
def _inverse3(cov: Matrix, extra: float, out: Written[Matrix]) -> float:
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
def _solve3(M: Matrix, y: Vector, out: Written[Vector]) -> None:
    """out = M^-1 y of a symmetric positive definite M."""
    inverse = np.empty((3, 3))
    _inverse3(M, 0.0, inverse)
    for r in range(3):
        out[r] = inverse[r, 0] * y[0] + inverse[r, 1] * y[1] + inverse[r, 2] * y[2]
