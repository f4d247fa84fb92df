"""Poses of segments from their own stereo points, and the rows that loose coupling makes."""

import numpy as np
import pytest

from tests.fusion.vist.test_vist_jacobians import differences, random_state
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.fusion.ablations.segment_pose import by_segment, fit_pose
from tracker.fusion.ablations.variants import check_variant
from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import THETA, ChainLayout
from tracker.fusion.chain.params import ChainParams, NoiseParams
from tracker.fusion.chain.pixels import PixelModel, SeenBlobs
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.recognition import LooseRows
from tracker.fusion.chain.state import initial_state, inject
from tracker.fusion.vist.filter import loose_rows, pose_rows
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.markers import Matched
from tracker.fusion.vist.points import positions
from tracker.geometry import so3
from tracker.vision.rig import ideal_rig

SHAPE = np.array([[0.0, 0.0, 0.0], [0.03, 0.0, 0.002], [0.01, 0.02, 0.0], [0.025, 0.015, 0.004]])
NOISE = np.diag([0.001, 0.001, 0.003]) ** 2
R_TRUE = so3.exp(np.array([0.3, -0.8, 2.0]))
P_TRUE = np.array([0.05, -0.1, 0.4])


def test_exact_points_give_the_exact_pose():
    pose = fit_pose(SHAPE, SHAPE @ R_TRUE.T + P_TRUE, np.tile(NOISE, (4, 1, 1)))
    np.testing.assert_allclose(pose.R_GB, R_TRUE, atol=1e-9)
    np.testing.assert_allclose(pose.centre_G, R_TRUE @ SHAPE.mean(axis=0) + P_TRUE, atol=1e-12)


def test_its_covariance_is_that_of_many_fits():
    rng = np.random.default_rng(0)
    errors, nees = [], []
    for _ in range(400):
        noise = rng.multivariate_normal(np.zeros(3), NOISE, 4)
        pose = fit_pose(SHAPE, SHAPE @ R_TRUE.T + P_TRUE + noise, np.tile(NOISE, (4, 1, 1)))
        centre = R_TRUE @ SHAPE.mean(axis=0) + P_TRUE
        e = np.r_[pose.centre_G - centre, so3.log(R_TRUE.T @ pose.R_GB)]
        errors.append(e)
        nees.append(e @ np.linalg.solve(pose.cov, e) / 6)
    assert np.mean(nees) == pytest.approx(1.0, abs=0.1)
    np.testing.assert_allclose(np.std(errors, axis=0), np.sqrt(np.diag(pose.cov)), rtol=0.25)


def test_collinear_points_and_an_outlier_give_no_result():
    cov = np.tile(NOISE, (4, 1, 1))
    line = np.outer([0.0, 0.01, 0.02, 0.03], [1.0, 0.5, 0.0])
    assert fit_pose(line, line @ R_TRUE.T + P_TRUE, cov) is None
    assert fit_pose(SHAPE[:2], SHAPE[:2] @ R_TRUE.T + P_TRUE, cov[:2]) is None
    points = SHAPE @ R_TRUE.T + P_TRUE
    points[1] += 0.03
    assert fit_pose(SHAPE, points, cov) is None


def test_segments_with_three_markers_take_part():
    found = dict(by_segment(np.array([0, 2, 0, 2, 0, 5])))
    np.testing.assert_array_equal(found.pop(0), [0, 2, 4])
    assert not found


def test_pose_jacobian_of_the_papers_filter(hand, glove):
    layout = VistLayout(hand, glove)
    state, lever = random_state(layout, 3), np.array([0.01, -0.02, 0.005])
    for segment in (0, 4):
        H, _, R_GB = pose_rows(state, layout, segment, lever)

        def f(s, segment=segment, R_GB=R_GB):
            _, place, turned = pose_rows(s, layout, segment, lever)
            return np.r_[place, so3.log(R_GB.T @ turned)]

        np.testing.assert_allclose(H, differences(f, state, layout.size), atol=1e-6)


def test_markers_where_they_are_expected_correct_nothing(hand, glove):
    layout = VistLayout(hand, glove)
    state = random_state(layout, 5)
    markers = np.arange(len(layout.used_markers))
    p_G = positions(state, layout.chain.marker_segment, layout.marker_lever)
    matched = Matched(markers, markers, markers, p_G, np.tile(NOISE, (len(markers), 1, 1)))
    H, r, R = loose_rows(state, layout, matched, huber=3.0)
    assert len(H) == len(r) == len(R) >= 6 * 3
    np.testing.assert_allclose(r, 0, atol=1e-8)
    H, r, R = loose_rows(state, layout, matched.none(), huber=3.0)
    assert H.shape == (0, layout.size)
    assert R.shape == (0, 0)


@pytest.fixture
def chain(hand, glove):
    """A chain before the camera, what would be seen of it exactly, and what makes rows of that."""
    layout, rig = ChainLayout(hand, glove), ideal_rig()
    state = initial_state(layout)
    state.P = initial_covariance(layout, ChainParams().prior)
    state.p = rig.pose.p_GC + 0.35 * rig.pose.R_GC[:, 2]
    p_C = (marker_positions(state, layout) - rig.pose.p_GC) @ rig.pose.R_GC
    hue, rows = layout.glove.marker_hue, np.arange(len(p_C))
    seen = tuple(SeenBlobs(rig.project(p_C, right), hue, rows) for right in (False, True))
    pixels, loose = PixelModel(layout, rig, NoiseParams()), LooseRows(layout, rig, NoiseParams())

    def rows_of(s):
        prediction = pixels.predict(s, rig.pose)
        return loose(s, prediction, seen, np.stack([rows, rows]), rig.pose)

    return layout, state, rows_of


def test_chain_rows_are_derivatives_of_the_pose(chain):
    layout, state, rows_of = chain
    H, HP, r, _ = rows_of(state)
    assert len(r) >= 6
    np.testing.assert_allclose(r, 0, atol=1e-7)
    np.testing.assert_allclose(HP, H @ state.P, atol=1e-12)
    for column in (0, 1, 2, THETA, THETA + 1, THETA + 2):
        dx = np.zeros(layout.blocks.size)
        dx[column] = 1e-5
        moved = state.copy()
        inject(moved, layout, dx)
        np.testing.assert_allclose(rows_of(moved)[2], -H[:, column] * 1e-5, atol=2e-8)


@pytest.mark.parametrize("words", [("next", "tight"), ("imu", "glued")])
def test_words_without_meaning_are_refused(words):
    with raises(ConfigError, "option.choice"):
        check_variant(*words)
