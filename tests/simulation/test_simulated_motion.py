"""Motions are smooth, within limits and where they should be."""

import numpy as np
import pytest

from tracker.hand.model import HandModel
from tracker.simulation.motion import Faster, Still, pose_at
from tracker.simulation.random_postures import PostureParams, RandomPostures, leaving
from tracker.simulation.smooth import Oscillation, SmoothNoise, minimum_jerk, rng_for
from tracker.vision.rig import default_pose


def test_minimum_jerk_is_at_rest_at_both_ends() -> None:
    h = 1e-4
    for end, value in ((0.0, 0.0), (1.0, 1.0)):
        x = minimum_jerk(np.array([end - h, end, end + h]))
        assert x[1] == value
        assert abs(x[2] - x[0]) / (2 * h) < 1e-6
        assert abs(x[2] - 2 * x[1] + x[0]) / h**2 < 1e-2


def test_smooth_noise_has_the_given_correlation() -> None:
    lag = 0.7
    products, squares = [], []
    for seed in range(300):
        noise = SmoothNoise(rng_for(seed, "test"), (8,), correlation=0.7)
        now, later = noise(np.array([3.0, 3.0 + lag]))
        products.append(now * later)
        squares.append(now * now)
    assert np.mean(squares) == pytest.approx(1.0, abs=0.1)
    assert np.mean(products) == pytest.approx(np.exp(-0.5), abs=0.1)


def test_oscillation_stays_in_its_band() -> None:
    t = np.arange(0, 20, 0.01)
    spectrum = np.abs(np.fft.rfft(Oscillation(rng_for(1, "o"), 1, 6.0, 11.0)(t)[:, 0])) ** 2
    hz = np.fft.rfftfreq(len(t), 0.01)
    assert spectrum[(hz > 5.5) & (hz < 11.5)].sum() > 0.95 * spectrum.sum()


def test_first_posture_is_flat_and_palm_down_before_the_camera(hand: HandModel) -> None:
    angles, R_GB, p_GB = pose_at(RandomPostures(hand, 3), 0.8)
    assert np.max(np.abs(angles)) < np.deg2rad(9)
    assert R_GB[2, 2] > np.cos(np.deg2rad(5))
    camera = default_pose()
    p_C = (p_GB - camera.p_GC) @ camera.R_GC
    assert 0.25 < p_C[2] < 0.5


@pytest.mark.parametrize("seed", [0, 1])
def test_random_postures_stay_near_the_limits_and_in_the_volume(hand: HandModel, seed: int) -> None:
    poses = RandomPostures(hand, seed, duration=60).poses(np.arange(0, 60, 0.05))
    slack = np.deg2rad(6)  # sway and tremor go slightly beyond
    assert np.all(poses.angles > hand.angle_limits[:, 0] - slack)
    assert np.all(poses.angles < hand.angle_limits[:, 1] + slack)
    centre = poses.p_GB + poses.R_GB[:, :, 0] * hand.length / 2
    depth = (centre - default_pose().p_GC) @ default_pose().R_GC[:, 2]
    assert depth.min() > 0.24 and depth.max() < 0.46


def test_motion_is_twice_continuously_differentiable(hand: HandModel) -> None:
    still = PostureParams(sway_mm=0, sway_deg=0, tremor_deg=0, tremor_mm=0)
    motion = RandomPostures(hand, 5, duration=12, params=still)
    h = 1e-3
    t = np.arange(0.1, 11, h)
    p = motion.poses(t).p_GB
    acceleration = np.diff(p, 2, axis=0) / h**2
    # a jump would not shrink with the step; a minimum-jerk move changes by its jerk times h
    assert np.abs(np.diff(acceleration, axis=0)).max() < 0.02 * np.abs(acceleration).max()


def test_motion_is_independent_of_the_order_of_evaluation(hand: HandModel) -> None:
    t = np.array([1.0, 7.3, 4.4])
    one, other = RandomPostures(hand, 8).poses(t), RandomPostures(hand, 8).poses(t[::-1])
    np.testing.assert_allclose(one.p_GB, other.p_GB[::-1], atol=1e-14)
    assert not np.allclose(one.angles, RandomPostures(hand, 9).poses(t).angles)


def test_leaving_is_outside_both_images_exactly_in_the_interval(hand: HandModel) -> None:
    motion = RandomPostures(hand, 4, duration=20)
    away = leaving(motion, ((5.0, 10.0),))
    p_C = (away.poses(np.array([3.0, 5.0, 7.5, 10.0, 12.0])).p_GB - default_pose().p_GC) @ (
        default_pose().R_GC
    )
    outside = p_C[:, 0] > 1.3 * p_C[:, 2]  # 45° to each side are visible
    assert outside.tolist() == [False, True, True, True, False]


def test_faster_is_the_same_path(hand: HandModel) -> None:
    motion = RandomPostures(hand, 2, duration=10)
    double = Faster(motion, 2.0)
    assert double.duration == 5.0
    np.testing.assert_array_equal(pose_at(double, 2.0)[0], pose_at(motion, 4.0)[0])


def test_still_repeats_its_posture(hand: HandModel) -> None:
    poses = Still(np.zeros(3), np.eye(3), np.ones(3)).poses(np.arange(4.0))
    assert poses.R_GB.shape == (4, 3, 3) and np.all(poses.p_GB == 1)
