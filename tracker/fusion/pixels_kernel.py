"""Stacking the pixel rows of all matched markers, compiled: the dearest loop of a picture."""

from __future__ import annotations

import numba
import numpy as np


@numba.njit(cache=True)
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


@numba.njit(cache=True)
def _huber(r, S, threshold):  # type: ignore[no-untyped-def]
    """Factor on the noise: 1 up to the threshold, then growing with the distance."""
    distance = np.sqrt(r @ np.linalg.solve(S, r) / len(r))
    return max(1.0, distance / threshold) ** 2
