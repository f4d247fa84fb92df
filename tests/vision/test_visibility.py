"""The prior of a marker: facing, field of view, occlusion."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import norm

from tracker.messages import CameraPose
from tracker.vision.rig import ideal_rig
from tracker.vision.visibility import (
    HandShape,
    VisibilityParams,
    _cuts_capsule,
    _cuts_slab,
    both_cameras,
    facing,
    visibility,
)

POSE = CameraPose(np.diag([1.0, -1.0, -1.0]), np.zeros(3))  # looks along -z of G
RIG = ideal_rig(pose=POSE)
UP = np.array([0.0, 0.0, 1.0])
LONE = HandShape(np.array([0.05]), np.array([0.01]), np.array([0.0]))
FAR_AWAY = (np.eye(3)[None], np.array([[5.0, 5.0, 5.0]]))


def lone_prior(p_G, normal_G, **more):
    p_G, normal_G = np.atleast_2d(p_G), np.atleast_2d(normal_G)
    segment = np.zeros(len(p_G), np.int64)
    return visibility(LONE, RIG, POSE, p_G, normal_G, segment, *FAR_AWAY, **more)


@pytest.mark.parametrize(
    ("angle_deg", "expected"), [(0, 1.0), (57.9, 1.0), (71.5, 0.5), (85.1, 0.0), (180, 0.0)]
)
def test_facing_follows_eq_4(angle_deg: float, expected: float) -> None:
    a = np.deg2rad(angle_deg)
    normal = np.array([[np.sin(a), 0.0, np.cos(a)]])
    p = np.array([[0.0, 0.0, -0.4]])
    v = VisibilityParams()
    limits = v.facing_full_deg, v.facing_none_deg
    assert facing(p, normal, np.zeros(3), *limits) == pytest.approx(expected, abs=1e-3)


def test_facing_marker_in_the_middle_is_seen_and_one_turned_away_is_not() -> None:
    p = [0.03, 0.0, -0.4]
    assert lone_prior(p, UP) == pytest.approx(np.ones((2, 1)), abs=1e-9)
    assert np.all(lone_prior(p, -UP) == 0)


def test_field_of_view_follows_eq_5() -> None:
    """The share of a Gaussian that lies inside the nearest edge, against scipy's own cdf."""
    u = np.array([-6.0, 0.0, 3.0, 20.0])
    x = (u - RIG.cx) * 0.4 / RIG.fx
    p = np.column_stack([x, np.zeros(4), np.full(4, -0.4)])
    cov = np.broadcast_to(np.diag([9.0, 400.0]), (2, 4, 2, 2))
    prior = lone_prior(p, np.broadcast_to(UP, (4, 3)), cov_px=cov)
    assert prior[0] == pytest.approx(norm.cdf(u / 3.0), abs=1e-6)


def test_point_behind_the_camera_is_not_seen() -> None:
    assert np.all(lone_prior([0.0, 0.0, 0.3], -UP) == 0)


def test_right_camera_stands_a_baseline_to_the_right() -> None:
    """At the left edge only the left camera still sees a near marker."""
    x = (15.0 - RIG.cx) * 0.3 / RIG.fx
    left, right = lone_prior([x, 0.0, -0.3], UP)[:, 0]
    assert left == pytest.approx(1.0)
    assert right < 1e-6
    assert both_cameras(np.array([[left], [right]]))[0] < 1e-6


def two_segments(width: float) -> tuple[HandShape, np.ndarray, np.ndarray]:
    """A marker's own segment at 0.4 m, and another 0.1 m nearer, both along x at y = 0."""
    shape = HandShape(np.full(2, 0.05), np.full(2, 0.01), np.array([0.0, width]))
    R = np.broadcast_to(np.eye(3), (2, 3, 3)).copy()
    return shape, R, np.array([[0.0, 0.0, -0.41], [0.0, 0.0, -0.3]])


@pytest.mark.parametrize("width", [0.0, 0.03])
@pytest.mark.parametrize(("nearer", "hidden"), [(1, True), (0, False)])
def test_segment_hides_what_is_behind_it_only(width: float, nearer: int, hidden: bool) -> None:
    shape, R, p = two_segments(width)
    if not nearer:
        p[1, 2] = -0.5
    own = np.zeros(1, np.int64)
    prior = visibility(shape, RIG, POSE, np.array([[0.025, 0, -0.4]]), UP[None], own, R, p)
    assert (prior[0, 0] < 0.1) == hidden


def test_own_segment_does_not_hide_a_marker() -> None:
    shape, R, p = two_segments(0.0)
    own = np.ones(1, np.int64)
    at = np.array([[0.025, 0, -0.29]])
    assert visibility(shape, RIG, POSE, at, UP[None], own, R, p)[0, 0] == pytest.approx(1.0)


def test_capsule_cut_agrees_with_a_numerical_minimum() -> None:
    rng = np.random.default_rng(3)
    disagreements = 0
    for _ in range(60):
        a, b = rng.normal(0, 0.03, 3) + [0.02, 0, 0.03], rng.normal(0, 0.03, 3)
        gap = _least_distance(a, b, 0.04)
        for radius in (gap * 0.98, gap * 1.02):
            disagreements += _cuts_capsule(a, b, 0.04, radius) != (radius > gap)
    assert disagreements == 0


def _least_distance(a: np.ndarray, b: np.ndarray, length: float) -> float:
    def gap2(x: np.ndarray) -> float:
        d = a + x[0] * (b - a) - [x[1] * length, 0, 0]
        return 1e4 * float(d @ d)

    best = minimize(gap2, [0.5, 0.5], bounds=[(0, 1), (0, 1)], tol=1e-14)
    return float(np.sqrt(best.fun / 1e4))


def test_slab_cut_agrees_with_dense_sampling() -> None:
    rng = np.random.default_rng(4)
    t = np.linspace(0, 1, 4001)[:, None]
    for _ in range(200):
        a, b = rng.normal(0, 0.06, 3), rng.normal(0, 0.06, 3)
        p = a + t * (b - a)
        inside = (p[:, 0] >= 0) & (p[:, 0] <= 0.08)
        inside &= (np.abs(p[:, 1]) <= 0.04) & (np.abs(p[:, 2]) <= 0.012)
        if inside.sum() not in (1, 2):  # a grazed corner is beyond the sampling
            assert _cuts_slab(a, b, 0.08, 0.04, 0.012) == bool(inside.any())


def test_parallel_line_beside_a_capsule() -> None:
    a, b = np.array([-0.1, 0.02, 0.0]), np.array([0.2, 0.02, 0.0])
    assert not _cuts_capsule(a, b, 0.05, 0.019)
    assert _cuts_capsule(a, b, 0.05, 0.021)
