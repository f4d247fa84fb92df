"""The arithmetic of `tracker.fusion.pixels`, compiled: the dearest loops of a picture."""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel


@kernel
def pixel_jacobians(p_C, R_GC, fx, fy, baseline):  # type: ignore[no-untyped-def]
    """(2, n, 2, 3) d uv / d p_G of both cameras, of points p_C (n, 3)."""
    n = len(p_C)
    out = np.empty((2, n, 2, 3))
    for c in range(2):
        shift = baseline if c else 0.0
        for k in range(n):
            z = max(p_C[k, 2], 0.01)
            u_z = -fx * (p_C[k, 0] - shift) / z**2
            v_z = -fy * p_C[k, 1] / z**2
            for i in range(3):
                out[c, k, 0, i] = fx / z * R_GC[i, 0] + u_z * R_GC[i, 2]
                out[c, k, 1, i] = fy / z * R_GC[i, 1] + v_z * R_GC[i, 2]
    return out


@kernel
def innovation_covariance(H, HP, A, sd_marker, sd_pixel):  # type: ignore[no-untyped-def]
    """(2, n, 2, 2) px² of n markers in both cameras; shapes as in `stack_rows`."""
    n, size = len(H), H.shape[2]
    out = np.empty((2, n, 2, 2))
    cov = np.empty((3, 3))
    for k in range(n):
        cov[:] = 0.0
        for j in range(size):
            for b in range(3):
                h = H[k, b, j]
                if h != 0.0:
                    for a in range(3):
                        cov[a, b] += HP[k, a, j] * h
        for a in range(3):
            cov[a, a] += sd_marker**2
        for c in range(2):
            out[c, k] = A[c, k] @ cov @ A[c, k].T
            for a in range(2):
                out[c, k, a, a] += sd_pixel**2
    return out


@kernel
def spread(S):  # type: ignore[no-untyped-def]
    """Median of ln det of S (n, 2, 2)."""
    out = np.empty(len(S))
    for k in range(len(S)):
        out[k] = np.log(S[k, 0, 0] * S[k, 1, 1] - S[k, 0, 1] * S[k, 1, 0])
    return np.median(out)


@kernel
def stack_rows(H, HP, A, residual, sd_marker, sd_pixel, threshold):  # type: ignore[no-untyped-def]
    """H, HP (m, N), r (m,) and noise (m, m) of the markers that are matched.

    H, HP (n, 3, N) of n markers in G and their product with P; A (2, n, 2, 3) d uv / d p_G;
    residual (2, n, 2) px, NaN where a camera has no match. A marker's rows stand together, left
    before right. Its placement error sd_marker (m) is common to both images, sd_pixel (px) is not;
    beyond ``threshold`` standard deviations the noise grows with the distance.
    """
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
        if end > start:
            noise = J[start:end] @ J[start:end].T * sd_marker**2
            for i in range(end - start):
                noise[i, i] += sd_pixel**2
            S = rows_HP[start:end] @ rows_H[start:end].T + noise
            R[start:end, start:end] = noise * _huber(r[start:end], S, threshold)
    return rows_H, rows_HP, r, R


@kernel
def _huber(r, S, threshold):  # type: ignore[no-untyped-def]
    """Factor on the noise: 1 up to the threshold, then growing with the distance."""
    distance = np.sqrt(_mahalanobis2(S, r) / len(r))
    return max(1.0, distance / threshold) ** 2


@kernel
def _mahalanobis2(S, r):  # type: ignore[no-untyped-def]
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
