"""The Kalman update shared by all engines."""

from __future__ import annotations

from scipy.linalg import cho_factor, cho_solve, solve_triangular

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
    S = HPH + R
    S = (S + S.T) / 2
    L, _ = cho_factor(S, lower=True, check_finite=False)
    W = solve_triangular(L, HP, lower=True, check_finite=False)
    dx = W.T @ solve_triangular(L, r, lower=True, check_finite=False)
    return dx, P - W.T @ W  # numpy multiplies a matrix by its own transpose symmetrically


def mahalanobis2(HPH: Array, r: Array, R: Array) -> float:
    """r^T S^-1 r."""
    c = cho_factor(HPH + R, lower=True, check_finite=False)
    return float(r @ cho_solve(c, r, check_finite=False))
