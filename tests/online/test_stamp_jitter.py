"""The jitter of time stamps: measured from the stamps alone, and used as noise."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.fusion.chain.prediction import Prediction
from tracker.fusion.chain.stamp_noise import StampNoise, common_noise, row_velocities, widened
from tracker.messages import Array
from tracker.online.frame_timing import StampJitter


def stamps(fps: float, sd: float, seconds: float = 10.0, seed: int = 1) -> Array:
    """One of twenty images is missing."""
    rng = np.random.default_rng(seed)
    t = np.arange(0.0, seconds, 1 / fps)
    kept = rng.random(len(t)) > 0.05
    jittered: Array = np.maximum.accumulate(t + rng.normal(0, sd, len(t)))[kept]
    return jittered + 1e-6 * np.arange(len(jittered))


def fed(jitter: StampJitter, t: Array) -> StampJitter:
    for one in t:
        jitter.take(float(one))
    return jitter


@pytest.mark.parametrize("fps", [15.0, 30.0, 60.0])
@pytest.mark.parametrize("sd", [0.001, 0.002, 0.004])
def test_jitter_is_measured_past_missing_images(fps: float, sd: float) -> None:
    found = [fed(StampJitter(), stamps(fps, sd, seed=k)).measured for k in range(5)]
    # at 60 images per second, 4 ms are a quarter of a period, and some images change places
    assert np.mean(found) == pytest.approx(sd, rel=0.15 if fps * sd < 0.15 else 0.3)


def test_exact_stamps_have_no_noise_even_if_the_rate_changes() -> None:
    t = np.concatenate([np.arange(0, 4, 1 / 30), 4 + np.arange(0, 4, 1 / 15)])
    jitter = fed(StampJitter(), t)
    assert jitter.sd == 0.0 and jitter.measured < 1e-4


def test_a_saved_state_resumes_identically() -> None:
    t = stamps(30.0, 0.003)
    whole, first, second = fed(StampJitter(), t), fed(StampJitter(), t[:120]), StampJitter()
    second.set_state(first.get_state())
    assert vars(fed(second, t[120:]).get_state()) == vars(whole.get_state())


def test_the_common_noise_is_that_of_all_markers_at_a_wrong_instant() -> None:
    """Monte Carlo: rows of a hand seen at instants with the jitter have this covariance."""
    rng = np.random.default_rng(3)
    A, v_G = rng.normal(0, 800, (2, 4, 2, 3)), rng.normal(0, 1.0, (4, 3))
    rows, match = np.array([0, 1, 3]), np.array([[0, -1, -1, 1], [1, 0, -1, -1]])
    none = np.zeros((3, 3, 3))
    prediction = Prediction(
        rows, np.zeros((2, 4, 2)), np.ones((2, 4)), none, none, none, A, np.zeros((2, 3, 2, 2))
    )
    w = row_velocities(A, rows, match, v_G, 7)
    assert w == pytest.approx(np.concatenate([v_G[0], A[1, 1] @ v_G[1], A[0, 3] @ v_G[3]]))
    late = rng.normal(0, 0.004, 20_000)
    moved = late[:, None] * w
    R = common_noise(prediction, match, StampNoise(0.004, v_G), 7)
    scale = np.sqrt(np.outer(np.diag(R), np.diag(R)))
    assert np.cov(moved.T) / scale == pytest.approx(R / scale, abs=0.05)


def test_each_marker_is_less_certain_along_its_own_velocity() -> None:
    rng = np.random.default_rng(4)
    A, v_G = rng.normal(0, 800, (2, 4, 2, 3)), rng.normal(0, 1.0, (4, 3))
    rows, none = np.array([0, 1, 3]), np.zeros((3, 3, 3))
    root = rng.normal(0, 1e-3, (3, 3, 3))
    cov = root @ root.transpose(0, 2, 1)
    moved = cov + 0.004**2 * np.einsum("ni,nj->nij", v_G[rows], v_G[rows])
    seen = np.einsum("cnij,njk,cnlk->cnil", A[:, rows], moved, A[:, rows]) + 0.5**2 * np.eye(2)
    prediction = Prediction(
        rows, np.zeros((2, 4, 2)), np.ones((2, 4)), none, none, cov, A, np.zeros((2, 3, 2, 2))
    )
    widened(prediction, StampNoise(0.004, v_G), pixel_px=0.5)
    assert prediction.cov == pytest.approx(moved, rel=1e-12)
    np.testing.assert_allclose(prediction.S, seen, rtol=1e-9)
