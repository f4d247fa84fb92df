"""Measurement rows of matched markers.

A marker's placement error is common to both images: the noise of a stereo pair is A A^T s_m² + I
s_px² with A = [Pi_L; Pi_R] R_CG (docs/chain.md, eq. 25). Treating it as independent pixel noise
would discard the depth information.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.params import PixelNoise
from tracker.fusion.chain.prediction import Prediction, seen_covariance
from tracker.geometry.kernels import inverse3, rotate
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, Matrix, Stack, Stack4, Vector, Written


@kernel(nogil=False)
def point_rows(
    prediction: Prediction, match: IntMatrix, left: Matrix, right: Matrix, noise: PixelNoise
) -> tuple[Matrix, Matrix, Vector, Matrix]:
    """`stack_rows` of the markers that may be seen, with three rows in place of four where both
    cameras see one: the measurement of its position in G. The fourth has no information on the
    state.

    With J (4, 3) of both cameras' A, the residual is (JᵀJ)⁻¹ Jᵀ r (m) and its noise
    I sd_marker² + (JᵀJ)⁻¹ sd_pixel² (m²). match (2, M) rows of left and right (k, 2) px.
    """
    rows, H, HP = prediction.rows, prediction.H, prediction.HP
    # 1. count the rows
    m = 0
    for k in range(len(rows)):
        seen = int(match[0, rows[k]] >= 0) + int(match[1, rows[k]] >= 0)
        m += seen + 1 if seen else 0
    rows_H, rows_HP = np.empty((m, H.shape[2])), np.empty((m, H.shape[2]))
    out_r, R = np.empty(m), np.zeros((m, m))
    J, r = np.empty((4, 3)), np.empty(4)
    at = 0
    for k in range(len(rows)):
        # 2. the marker's pixels, and their residuals
        end = _put_pixels(J, r, rows[k], prediction, match, left, right)
        if end == 0:
            continue
        S = seen_covariance(J[:end], prediction.cov[k], noise.pixel_px)
        weight = _huber(r[:end], S, noise.huber)
        if end == 4:
            # 3a. both cameras: a position in G (eq. 26)
            R_k, out_r[at : at + 3] = _solved(J, r)
            rows_H[at : at + 3], rows_HP[at : at + 3] = H[k], HP[k]
            R_k *= noise.pixel_px**2
            for a in range(3):
                R_k[a, a] += noise.marker**2
        else:
            # 3b. one camera: its pixels (eq. 25)
            out_r[at : at + 2] = r[:2]
            _put_product(rows_H[at : at + 2], J, H[k])
            _put_product(rows_HP[at : at + 2], J, HP[k])
            R_k = seen_covariance(J[:2], np.eye(3) * noise.marker**2, noise.pixel_px)
        last = at + len(R_k)
        R[at:last, at:last] = R_k * weight
        at = last
    return rows_H, rows_HP, out_r, R


@kernel
def _put_pixels(
    J: Written[Matrix],
    r: Written[Vector],
    marker: int,
    prediction: Prediction,
    match: IntMatrix,
    left: Matrix,
    right: Matrix,
) -> int:
    """Jacobians J (4, 3) and residuals r (4,) px of a marker in the cameras that show it, left
    before right; returns the number of rows."""
    end = 0
    for c in range(2):
        row = match[c, marker]
        if row < 0:
            continue
        for a in range(2):
            J[end] = prediction.A[c, marker, a]
            r[end] = (right[row, a] if c else left[row, a]) - prediction.uv[c, marker, a]
            end += 1
    return end


@kernel
def _put_product(out: Written[Matrix], J: Matrix, H: Matrix) -> None:
    """out (k, N) = J H for the first k rows of J and H (3, N)."""
    for a in range(len(out)):
        x, y, z = J[a]
        for i in range(H.shape[1]):
            out[a, i] = x * H[0, i] + y * H[1, i] + z * H[2, i]


@kernel
def _solved(J: Matrix, r: Vector) -> tuple[Matrix, Vector]:
    """(JᵀJ)⁻¹ (3, 3) and (JᵀJ)⁻¹ Jᵀ r (3,)."""
    JJ, Jr = np.zeros((3, 3)), np.zeros(3)
    for e in range(len(J)):
        for a in range(3):
            Jr[a] += J[e, a] * r[e]
            for b in range(3):
                JJ[a, b] += J[e, a] * J[e, b]
    inverse = inverse3(JJ)
    return inverse, rotate(inverse, Jr)


@kernel(nogil=False)
def stack_rows(
    H: Stack, HP: Stack, A: Stack4, residual: Stack, noise: PixelNoise
) -> tuple[Matrix, Matrix, Vector, Matrix]:
    """H, HP (m, N), r (m,) and noise (m, m) of the matched markers.

    H, HP (n, 3, N) of n markers in G and their product with P; A (2, n, 2, 3) d uv / d p_G;
    residual (2, n, 2) px, NaN where a camera has no match. A marker's rows are adjacent, left
    before right. Its placement error (m) is common to both images, that of a pixel is not; beyond
    ``noise.huber`` standard deviations the noise grows with the distance.
    """
    # 1. count the rows
    matched = 0
    for c in range(2):
        for k in range(H.shape[0]):
            if not np.isnan(residual[c, k, 0]):
                matched += 1
    m, size = 2 * matched, H.shape[2]
    rows_H, rows_HP = np.empty((m, size)), np.empty((m, size))
    J, r, R = np.empty((m, 3)), np.empty(m), np.zeros((m, m))
    end = 0
    for k in range(H.shape[0]):
        # 2. the pixels of one marker
        start = end
        for c in range(2):
            if np.isnan(residual[c, k, 0]):
                continue
            for a in range(2):
                J[end], r[end] = A[c, k, a], residual[c, k, a]
                x, y, z = J[end]
                for i in range(size):
                    rows_H[end, i] = x * H[k, 0, i] + y * H[k, 1, i] + z * H[k, 2, i]
                    rows_HP[end, i] = x * HP[k, 0, i] + y * HP[k, 1, i] + z * HP[k, 2, i]
                end += 1
        # 3. their noise; the placement error is common to both images (eq. 25)
        if end > start:
            R_k = J[start:end] @ J[start:end].T * noise.marker**2
            for i in range(end - start):
                R_k[i, i] += noise.pixel_px**2
            S = rows_HP[start:end] @ rows_H[start:end].T + R_k
            R[start:end, start:end] = R_k * _huber(r[start:end], S, noise.huber)
    return rows_H, rows_HP, r, R


@kernel
def _huber(r: Vector, S: Matrix, threshold: float) -> float:
    """Factor on the noise: 1 up to the threshold, then growing with the distance (eq. 27)."""
    distance = np.sqrt(_mahalanobis2(S, r) / len(r))
    return max(1.0, distance / threshold) ** 2


@kernel
def _mahalanobis2(S: Matrix, r: Vector) -> float:
    """r^T S^-1 r of a small positive definite S, by its Cholesky factor."""
    n, total = len(r), 0.0
    L, y = np.zeros((n, n)), np.empty(n)
    for i in range(n):
        for j in range(i + 1):
            x = S[i, j]
            for k in range(j):
                x -= L[i, k] * L[j, k]
            L[i, j] = np.sqrt(x) if i == j else x / L[j, j]
        y[i] = r[i]
        for k in range(i):
            y[i] -= L[i, k] * y[k]
        y[i] /= L[i, i]
        total += y[i] * y[i]
    return total
