"""Products with matrices whose rows are mostly zero, such as a measurement's derivatives."""

from __future__ import annotations

import numba
import numpy as np


@numba.njit(cache=True, nogil=True)
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
