"""The Kalman update shared by all engines, and products with sparse rows."""

from __future__ import annotations

import numpy as np
from scipy.linalg.blas import dsyrk, dtrsm
from scipy.linalg.lapack import dpotrf

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector, Written
from tracker.messages import Array


def update(P: Array, H: Array, r: Array, R: Array) -> tuple[Array, Array]:
    """One linear update. P (N, N), H (m, N), innovation r (m,), R (m, m).

    Returns the error vector dx (N,) and the new P, symmetric by construction:
    P - W^T W with W = U^-T H P and U^T U = H P H^T + R (docs/chain.md, eq. 38).
    """
    HP = H @ P
    return update_with(P, HP, HP @ H.T, r, R)


def update_with(P: Array, HP: Array, HPH: Array, r: Array, R: Array) -> tuple[Array, Array]:
    """As `update`, for a caller that already has H P (m, N) and H P H^T (m, m)."""
    out = P.copy()
    return correct(out, HP, HPH, r, R), out


def correct(P: Array, HP: Array, HPH: Array, r: Array, R: Array) -> Array:
    """`update_with` in place: dx (N,); the C-ordered P is overwritten with the new one."""
    # 1. U^T U = S
    U = _factor(HPH + R)
    # 2. W and dx; the transposes have LAPACK's memory order, so nothing is copied
    Wt = dtrsm(1.0, U, HP.T, side=1, lower=0)
    dx: Array = Wt @ dtrsm(1.0, U, r[:, None], lower=0, trans_a=1)[:, 0]
    # 3. one triangle of P - W^T W, and its mirror
    dsyrk(-1.0, Wt, beta=1.0, c=P.T, overwrite_c=1)  # the upper triangle of the transpose
    _mirror(P)
    return dx


@kernel(nogil=False)
def _mirror(P: Written[Matrix]) -> None:
    """Copy the lower triangle to the upper one, in tiles that fit the cache."""
    n, tile = len(P), 32
    for top in range(0, n, tile):
        for left in range(0, top + 1, tile):
            for i in range(top, min(top + tile, n)):
                for j in range(left, min(left + tile, i)):
                    P[j, i] = P[i, j]


def _factor(S: Array) -> Array:
    """Upper U with U^T U = S (m, m), a C-ordered matrix of which the lower triangle is read and
    overwritten.

    LAPACK is called directly: at this size scipy's checks take as long as the arithmetic. Raises
    LinAlgError where S is not positive definite.
    """
    U, info = dpotrf(S.T, lower=0, clean=0, overwrite_a=1)
    if info != 0:
        raise np.linalg.LinAlgError("the innovation covariance is not positive definite")
    return np.asarray(U)


@kernel
def times(H: Matrix, P: Matrix) -> Matrix:
    """H P for a sparse H (m, N) and P (N, k)."""
    out = np.zeros((len(H), P.shape[1]))
    for i in range(len(H)):
        for j in range(H.shape[1]):
            factor = H[i, j]
            if factor != 0.0:
                for k in range(P.shape[1]):
                    out[i, k] += factor * P[j, k]
    return out


@kernel(nogil=False)
def products(H: Matrix, P: Matrix) -> tuple[Matrix, Matrix]:
    """H P (m, N) and H P Hᵀ (m, m)."""
    HP = times(H, P)
    return HP, times(H, HP.T.copy())


@kernel(nogil=False)
def joined(
    H_1: Matrix,
    HP_1: Matrix,
    r_1: Vector,
    R_1: Matrix,
    H_2: Matrix,
    r_2: Vector,
    variance: Vector,
    P: Matrix,
) -> tuple[Matrix, Matrix, Matrix, Vector, Matrix]:
    """H, H P, H P Hᵀ, r and R of two independent measurements.

    H P of the first is given; R_1 (m, m) is its noise, and ``variance`` (k,) the diagonal noise of
    the second.
    """
    m, k = len(r_1), len(r_2)
    H, HP = np.empty((m + k, len(P))), np.empty((m + k, len(P)))
    r, R = np.empty(m + k), np.zeros((m + k, m + k))
    H[:m], HP[:m], r[:m], R[:m, :m] = H_1, HP_1, r_1, R_1
    H[m:], HP[m:], r[m:] = H_2, times(H_2, P), r_2
    for i in range(k):
        R[m + i, m + i] = variance[i]
    return H, HP, times(H, HP.T.copy()), r, R
