"""Products with matrices whose rows are mostly zero, such as a measurement's derivatives."""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel


@kernel
def times(H, P):  # type: ignore[no-untyped-def]
    """H P of H (m, N), few entries a row, and P (N, k)."""
    out = np.zeros((len(H), P.shape[1]))
    for i in range(len(H)):
        for j in range(H.shape[1]):
            factor = H[i, j]
            if factor != 0.0:
                for k in range(P.shape[1]):
                    out[i, k] += factor * P[j, k]
    return out


@kernel
def products(H, P):  # type: ignore[no-untyped-def]
    """H P (m, N) and H P Hᵀ (m, m)."""
    HP = times(H, P)
    return HP, times(H, HP.T.copy())


@kernel
def joined(H_1, HP_1, r_1, R_1, H_2, r_2, variance, P):  # type: ignore[no-untyped-def]
    """H, H P, H P Hᵀ, r and R of two independent measurements.

    H P of the first is known; R_1 (m, m), the second's noise ``variance`` (k,) on the diagonal.
    """
    m, k = len(r_1), len(r_2)
    H, HP = np.empty((m + k, len(P))), np.empty((m + k, len(P)))
    r, R = np.empty(m + k), np.zeros((m + k, m + k))
    H[:m], HP[:m], r[:m], R[:m, :m] = H_1, HP_1, r_1, R_1
    H[m:], HP[m:], r[m:] = H_2, times(H_2, P), r_2
    for i in range(k):
        R[m + i, m + i] = variance[i]
    return H, HP, times(H, HP.T.copy()), r, R
