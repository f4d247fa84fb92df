"""The Kalman update shared by all engines."""

from __future__ import annotations

import numpy as np
from scipy.linalg.blas import dsyrk, dtrsm
from scipy.linalg.lapack import dpotrf

from tracker.kernels import kernel
from tracker.messages import Array


def update(P: Array, H: Array, r: Array, R: Array) -> tuple[Array, Array]:
    """One linear update. P (N, N), H (m, N), innovation r (m,), R (m, m).

    Returns the error vector dx (N,) and the new P, symmetric by construction:
    P - W^T W with W = L^-1 H P and L L^T = H P H^T + R.
    """
    HP = H @ P
    return update_with(P, HP, HP @ H.T, r, R)


def update_with(P: Array, HP: Array, HPH: Array, r: Array, R: Array) -> tuple[Array, Array]:
    """As `update`, for a caller that has H P (m, N) and H P H^T (m, m) already."""
    L = _factor(HPH + R)
    # HP's transpose is in the library's own order: solving from the right saves two copies of it
    Wt = dtrsm(1.0, L, HP.T, side=1, lower=1, trans_a=1)
    dx = Wt @ dtrsm(1.0, L, r[:, None], lower=1)[:, 0]
    out = P.copy()
    dsyrk(-1.0, Wt, beta=1.0, c=out.T, overwrite_c=1)  # the upper triangle of the transpose
    _mirror(out)
    return dx, out


@kernel
def _mirror(P):  # type: ignore[no-untyped-def]
    """Copy the lower triangle to the upper one, in tiles that stay in the cache."""
    n, tile = len(P), 32
    for top in range(0, n, tile):
        for left in range(0, top + 1, tile):
            for i in range(top, min(top + tile, n)):
                for j in range(left, min(left + tile, i)):
                    P[j, i] = P[i, j]


def mahalanobis2(HPH: Array, r: Array, R: Array) -> float:
    """r^T S^-1 r."""
    x = dtrsm(1.0, _factor(HPH + R), r[:, None], lower=1)[:, 0]
    return float(x @ x)


def _factor(S: Array) -> Array:
    """Lower Cholesky factor of S, made symmetric. Raises LinAlgError where S is not positive.

    LAPACK is called directly: at this size scipy's checks cost as much as the arithmetic.
    """
    L, info = dpotrf((S + S.T) / 2, lower=1, clean=0)
    if info != 0:
        raise np.linalg.LinAlgError("the innovation covariance is not positive definite")
    return np.asarray(L)
