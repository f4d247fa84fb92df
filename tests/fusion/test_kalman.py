"""The update against the dense Joseph form."""

import numpy as np

from tracker.fusion.kalman import correct, update


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


def test_in_place_is_the_same() -> None:
    P, H, r, R = problem()
    dx, out = update(P, H, r, R)
    HP = H @ P
    assert np.array_equal(correct(P, HP, HP @ H.T, r, R), dx)
    assert np.array_equal(P, out)
