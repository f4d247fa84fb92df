"""Lines of sight and rays against sampling and minimisation on capsules and boxes."""

import numpy as np
import pytest
from scipy.optimize import minimize

from tracker.geometry.solids import box_span, capsule_depth, sight_cuts_box, sight_cuts_capsule

CORNERS = (0.0, -0.04, -0.012), (0.08, 0.04, 0.012)


def test_capsule_cut_agrees_with_a_numerical_minimum() -> None:
    rng = np.random.default_rng(3)
    disagreements = 0
    for _ in range(60):
        a, b = rng.normal(0, 0.03, 3) + [0.02, 0, 0.03], rng.normal(0, 0.03, 3)
        gap = _least_distance(a, b, 0.04)
        for radius in (gap * 0.98, gap * 1.02):
            disagreements += sight_cuts_capsule(tuple(a), tuple(b), 0.04, radius) != (radius > gap)
    assert disagreements == 0


def _least_distance(a: np.ndarray, b: np.ndarray, length: float) -> float:
    def gap2(x: np.ndarray) -> float:
        d = a + x[0] * (b - a) - [x[1] * length, 0, 0]
        return 1e4 * float(d @ d)

    best = minimize(gap2, [0.5, 0.5], bounds=[(0, 1), (0, 1)], tol=1e-14)
    return float(np.sqrt(best.fun / 1e4))


def test_box_cut_agrees_with_dense_sampling() -> None:
    rng = np.random.default_rng(4)
    t = np.linspace(0, 1, 4001)[:, None]
    for _ in range(200):
        a, b = rng.normal(0, 0.06, 3), rng.normal(0, 0.06, 3)
        p = a + t * (b - a)
        inside = (p[:, 0] >= 0) & (p[:, 0] <= 0.08)
        inside &= (np.abs(p[:, 1]) <= 0.04) & (np.abs(p[:, 2]) <= 0.012)
        if inside.sum() not in (1, 2):  # a grazed corner is beyond the sampling
            assert sight_cuts_box(tuple(a), tuple(b), *CORNERS) == bool(inside.any())


def test_parallel_line_next_to_a_capsule() -> None:
    a, b = np.array([-0.1, 0.02, 0.0]), np.array([0.2, 0.02, 0.0])
    assert not sight_cuts_capsule(tuple(a), tuple(b), 0.05, 0.019)
    assert sight_cuts_capsule(tuple(a), tuple(b), 0.05, 0.021)


def on_capsule(p: np.ndarray, length: float) -> float:
    """Distance of p (3,) from the axis."""
    return float(np.hypot(np.hypot(p[1], p[2]), p[0] - np.clip(p[0], 0, length)))


@pytest.mark.parametrize("seed", range(3))
def test_a_ray_intersects_a_capsule_on_its_surface_or_misses_like_a_line_of_sight(seed) -> None:
    rng, met = np.random.default_rng(seed), 0
    for _ in range(200):
        o, d = rng.normal(0, 0.05, 3) - [0, 0, 0.5], np.append(rng.normal(0, 0.1, 2), 1.0)
        enters, leaves = (
            capsule_depth(tuple(o), tuple(d), 0.04, 0.02, side) for side in (-1.0, 1.0)
        )
        assert (enters > 0) == sight_cuts_capsule(tuple(o), tuple(o + d), 0.04, 0.02)
        if enters > 0:
            met += 1
            assert enters < leaves
            for t in (enters, leaves):
                assert on_capsule(o + t * d, 0.04) == pytest.approx(0.02, abs=1e-12)
    assert 10 < met < 180


@pytest.mark.parametrize("seed", range(3))
def test_a_ray_intersects_a_box_on_its_faces_or_misses_like_a_line_of_sight(seed) -> None:
    rng, met = np.random.default_rng(seed), 0
    half = (0.04, 0.03, 0.012)
    for _ in range(200):
        o, d = rng.normal(0, 0.05, 3) - [0, 0, 0.5], np.append(rng.normal(0, 0.1, 2), 1.0)
        enters, leaves = box_span(tuple(o), tuple(d), half)
        corners = tuple(-h for h in half), half
        assert (enters < leaves) == sight_cuts_box(tuple(o), tuple(o + d), *corners)
        if enters < leaves:
            met += 1
            for t in (enters, leaves):
                assert np.max(np.abs(o + t * d) / half) == pytest.approx(1.0, abs=1e-10)
    assert 10 < met < 180
