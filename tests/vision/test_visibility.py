"""The prior of a marker: facing, field of view, occlusion."""

import numpy as np
import pytest
from scipy.stats import norm

from tracker.messages import CameraPose
from tracker.vision.rig import ideal_rig
from tracker.vision.visibility import (
    HandShape,
    MarkerRows,
    PosedHand,
    VisibilityParams,
    both_cameras,
    facing,
    turned,
    visibility,
)

POSE = CameraPose(np.diag([1.0, -1.0, -1.0]), np.zeros(3))  # faces along -z of G
RIG = ideal_rig(pose=POSE)
UP = np.array([0.0, 0.0, 1.0])
LONE = HandShape(np.array([0.05]), np.array([0.01]), np.array([0.0]))
FAR_AWAY = PosedHand(LONE, np.eye(3)[None], np.array([[5.0, 5.0, 5.0]]))


def lone_prior(p_G, normal_G, **more):
    p_G, normal_G = np.atleast_2d(p_G), np.atleast_2d(normal_G)
    segment = np.zeros(len(p_G), np.int64)
    return visibility(FAR_AWAY, MarkerRows(p_G, normal_G, segment), RIG, POSE, **more)


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


def test_a_marker_in_the_centre_is_visible_only_if_it_faces_the_camera() -> None:
    p = [0.03, 0.0, -0.4]
    assert lone_prior(p, UP) == pytest.approx(np.ones((2, 1)), abs=1e-9)
    assert np.all(lone_prior(p, -UP) == 0)


def test_field_of_view_follows_eq_5() -> None:
    """The share of a Gaussian inside the nearest edge, against scipy's cdf."""
    u = np.array([-6.0, 0.0, 3.0, 20.0])
    x = (u - RIG.cx) * 0.4 / RIG.fx
    p = np.column_stack([x, np.zeros(4), np.full(4, -0.4)])
    cov = np.broadcast_to(np.diag([9.0, 400.0]), (2, 4, 2, 2))
    prior = lone_prior(p, np.broadcast_to(UP, (4, 3)), cov_px=cov)
    assert prior[0] == pytest.approx(norm.cdf(u / 3.0), abs=1e-6)


def test_point_behind_the_camera_is_invisible() -> None:
    assert np.all(lone_prior([0.0, 0.0, 0.3], -UP) == 0)


def test_right_camera_is_one_baseline_to_the_right() -> None:
    """At the left edge only the left camera sees a near marker."""
    x = (15.0 - RIG.cx) * 0.3 / RIG.fx
    left, right = lone_prior([x, 0.0, -0.3], UP)[:, 0]
    assert left == pytest.approx(1.0)
    assert right < 1e-6
    assert both_cameras(np.array([[left], [right]]))[0] < 1e-6


def two_segments(width: float) -> tuple[HandShape, np.ndarray, np.ndarray]:
    """A marker's own segment at 0.4 m, and another 0.1 m nearer, both along x at y = 0."""
    shape = HandShape(np.full(2, 0.05), np.full(2, 0.01), np.array([0.0, width]))
    R = np.broadcast_to(np.eye(3), (2, 3, 3)).copy()
    return PosedHand(shape, R, np.array([[0.0, 0.0, -0.41], [0.0, 0.0, -0.3]]))


@pytest.mark.parametrize("width", [0.0, 0.03])
@pytest.mark.parametrize(("nearer", "hidden"), [(1, True), (0, False)])
def test_segment_occludes_only_what_is_behind_it(width: float, nearer: int, hidden: bool) -> None:
    two = two_segments(width)
    if not nearer:
        two.p_GB[1, 2] = -0.5
    own = np.zeros(1, np.int64)
    marker = MarkerRows(np.array([[0.025, 0, -0.4]]), UP[None], own)
    prior = visibility(two, marker, RIG, POSE)
    assert (prior[0, 0] < 0.1) == hidden


def test_own_segment_does_not_occlude_a_marker() -> None:
    own = np.ones(1, np.int64)
    at = np.array([[0.025, 0, -0.29]])
    prior = visibility(two_segments(0.0), MarkerRows(at, UP[None], own), RIG, POSE)
    assert prior[0, 0] == pytest.approx(1.0)


def test_normals_are_rotated_as_by_numpy() -> None:
    """Except for rounding: numbers are below one, and some processors round less often."""
    rng = np.random.default_rng(3)
    R = np.linalg.qr(rng.normal(size=(21, 3, 3)))[0]
    segment, normal = rng.integers(0, 21, 37), rng.normal(size=(37, 3))
    expected = np.einsum("mij,mj->mi", R[segment], normal)
    assert np.abs(turned(R, segment, normal) - expected).max() < 1e-15
