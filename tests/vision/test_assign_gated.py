"""Assignment in one image against brute force and by its limits."""

from itertools import permutations

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

from tests.vision.gated_assignment import assign_gated
from tracker.vision.assignment import assign
from tracker.vision.correspondence import GateParams

S4 = np.diag([4.0, 4.0])


def covariances(n: int) -> np.ndarray:
    return np.broadcast_to(S4, (n, 2, 2)).copy()


def brute_force(uv, hue, predicted, S, marker_hue, prior, params) -> float:
    """Minimum total cost over all assignments of markers, or none, to blobs."""
    n, m = len(uv), len(predicted)
    best = np.inf
    for choice in permutations([*range(m), *[-1] * n], n):
        total = 0.0
        for i, j in enumerate(choice):
            total += params.dummy_cost if j < 0 else pair_cost(uv[i], predicted[j], S[j], prior[j])
            if j >= 0 and hue[i] != marker_hue[j]:
                total += 1e5
        best = min(best, total)
    return best


def pair_cost(z, predicted, S, prior) -> float:
    d = z - predicted
    return float(d @ np.linalg.solve(S, d) + np.log(np.linalg.det(S)) - 2 * np.log(prior))


@pytest.mark.parametrize("seed", range(8))
def test_total_cost_is_the_minimum_of_all_assignments(seed: int) -> None:
    rng = np.random.default_rng(seed)
    n, m = 4, 4
    predicted = rng.uniform(0, 12, (m, 2))
    uv = predicted + rng.normal(0, 3, (m, 2))
    hue, marker_hue = rng.integers(0, 2, n), rng.integers(0, 2, m)
    A = rng.normal(0, 1.5, (m, 2, 2))
    S = A @ A.swapaxes(1, 2) + S4
    prior = rng.uniform(0.05, 1, m)
    params = GateParams(gate=1e3)
    got = assign_gated(uv, hue, predicted, S, marker_hue, prior, params)
    used = got[got >= 0]
    assert len(set(used)) == len(used)
    total = params.dummy_cost * (n - len(used))
    for j in np.flatnonzero(got >= 0):
        assert hue[got[j]] == marker_hue[j]
        total += pair_cost(uv[got[j]], predicted[j], S[j], prior[j])
    expected = brute_force(uv, hue, predicted, S, marker_hue, prior, params)
    assert total == pytest.approx(expected, abs=1e-9)


def test_hues_are_never_mixed() -> None:
    uv = np.array([[10.0, 10.0]])
    got = assign_gated(uv, np.array([1]), uv, covariances(1), np.array([0]), np.ones(1))
    assert got.tolist() == [-1]


def test_blob_outside_the_gate_is_not_matched() -> None:
    predicted = np.array([[10.0, 10.0]])
    zero = np.zeros(1, np.int64)
    for shift, expected in ((8.0, 0), (9.0, -1)):  # 16 and 20.25 of Mahalanobis², gate 18
        got = assign_gated(
            predicted + [shift, 0],
            zero,
            predicted,
            covariances(1),
            zero,
            np.ones(1),
            GateParams(dummy_cost=30.0),
        )
        assert got.tolist() == [expected]


def test_pixel_gate_applies_for_any_covariance() -> None:
    predicted = np.zeros((1, 2))
    zero = np.zeros(1, np.int64)
    S = np.diag([1e4, 1e4])[None]
    params = GateParams(dummy_cost=40.0)
    near, far = np.array([[70.0, 0]]), np.array([[90.0, 0]])
    assert assign_gated(near, zero, predicted, S, zero, np.ones(1), params)[0] == 0
    assert assign_gated(far, zero, predicted, S, zero, np.ones(1), params)[0] == -1


def test_the_more_likely_marker_wins_between_equals() -> None:
    predicted = np.array([[0.0, 0.0], [2.0, 0.0]])
    zero = np.zeros(2, np.int64)
    prior = np.array([0.05, 0.9])
    got = assign_gated(np.array([[1.0, 0]]), zero[:1], predicted, covariances(2), zero, prior)
    assert got.tolist() == [-1, 0]


@pytest.mark.parametrize(("n", "m"), [(0, 3), (3, 0), (0, 0)])
def test_nothing_to_assign(n: int, m: int) -> None:
    got = assign_gated(
        np.zeros((n, 2)),
        np.zeros(n, np.int64),
        np.zeros((m, 2)),
        covariances(m),
        np.zeros(m, np.int64),
        np.ones(m),
    )
    assert got.tolist() == [-1] * m


@pytest.mark.parametrize("seed", range(60))
def test_the_cost_equals_that_of_scipys_assignment(seed: int) -> None:
    """With one dummy column per row; including forbidden pairs and negative costs."""
    rng = np.random.default_rng(seed)
    n, m = rng.integers(0, 9, 2)
    cost, alone = rng.normal(0, 10, (n, m)), float(rng.normal(5, 5))
    cost[rng.random((n, m)) < 0.4] = 1e6
    got = assign(cost, alone)
    rows = got[got >= 0]
    assert len(set(rows)) == len(rows)
    total = cost[rows, np.flatnonzero(got >= 0)].sum() + alone * (n - len(rows))
    padded = np.concatenate([cost, np.full((n, n), alone)], axis=1)
    assert total == pytest.approx(padded[linear_sum_assignment(padded)].sum(), abs=1e-9)
