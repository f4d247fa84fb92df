"""The update against the dense Joseph form."""

import numpy as np

from tracker.fusion.kalman import mahalanobis2, update


def problem(n: int = 60, m: int = 25) -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(0)
    A = rng.normal(size=(n, n))
    return A @ A.T, rng.normal(size=(m, n)), rng.normal(size=m), np.diag(0.1 + rng.random(m))


def test_equal_to_joseph() -> None:
    P, H, r, R = problem()
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    J = np.eye(len(P)) - K @ H
    joseph = J @ P @ J.T + K @ R @ K.T
    dx, out = update(P, H, r, R)
    scale = np.abs(joseph).max()
    assert np.allclose(out, joseph, atol=1e-10 * scale, rtol=0)
    assert np.allclose(dx, K @ r, atol=1e-10 * np.abs(dx).max())
    assert np.array_equal(out, out.T)
    assert np.linalg.eigvalsh(out).min() > -1e-9 * scale


def test_mahalanobis_distance() -> None:
    P, H, r, R = problem(5, 3)
    S = H @ P @ H.T + R
    assert np.isclose(mahalanobis2(H @ P @ H.T, r, R), r @ np.linalg.inv(S) @ r)
