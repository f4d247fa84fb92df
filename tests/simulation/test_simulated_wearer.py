"""A simulated person differs from the files by the parameters, and in nothing else."""

from dataclasses import replace

import numpy as np
import pytest

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.output.completion import Completion
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.kinematics import angles_from_many, forward_many
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.wearer import Wearer, WearerParams

T = np.arange(0.0, 20.0, 0.25)


def test_exact_wearer_is_the_hand_file(hand: HandModel, glove: GloveModel) -> None:
    """The simulator's kinematics against the hand model's own."""
    wearer, motion = Wearer.exact(hand, glove), RandomPostures(hand, 1)
    truth, poses = wearer.truth(motion, T), motion.poses(T)
    for k in range(0, len(T), 8):
        R, p = hand.forward(poses.angles[k], poses.R_GB[k], poses.p_GB[k])
        np.testing.assert_allclose(truth.R_GB[k], R, atol=1e-12)
        np.testing.assert_allclose(truth.p_GB[k], p, atol=1e-12)
        expected = glove.keypoint_positions(hand, R, p)
        np.testing.assert_allclose(wearer.keypoints(R, p), expected, atol=1e-12)
    np.testing.assert_allclose(truth.angles, poses.angles, atol=1e-9)


def test_angles_are_those_computed_by_the_filters(hand: HandModel, glove: GloveModel) -> None:
    """Both compute them from orientations, the filters by their own compiled code."""
    truth = Wearer(hand, glove, 3).truth(RandomPostures(hand, 3), T)
    layout = ChainLayout(hand, glove)
    complete, a = Completion(layout), layout.active
    moved = [c for i in a for c in hand.axis_columns[i] if c >= 0]
    assert len(moved) > 5
    for k in range(0, len(T), 8):
        shown = complete(truth.R_GB[k, a], truth.p_GB[k, a], np.ones((len(a), 3)))[3]
        np.testing.assert_allclose(truth.angles[k, moved], shown[moved], atol=1e-9)


def test_bone_lengths_are_constant(hand: HandModel, glove: GloveModel) -> None:
    wearer = Wearer(hand, glove, 7)
    truth = wearer.truth(RandomPostures(hand, 7), T)
    for i, s in enumerate(hand.segments):
        a = hand.parent[i]
        if a > 0:
            length = np.linalg.norm(truth.p_GB[:, i] - truth.p_GB[:, a], axis=1)
            nominal = float(np.linalg.norm(s.origin)) * wearer.scale[a, 0]
            np.testing.assert_allclose(length, nominal, rtol=1e-9)


def test_a_ruler_measures_the_wearers_own_hand(hand: HandModel, glove: GloveModel) -> None:
    assert Wearer.exact(hand, glove).hand_length == pytest.approx(hand.length, rel=0.02)  # file's
    names = ["wrist", "middle_mcp", "middle_pip", "middle_dip", "middle_tip"]
    columns = [hand.keypoint_names.index(name) for name in names]
    for seed in range(5):
        wearer = Wearer(hand, glove, seed)
        R, p, _ = wearer.segments(RandomPostures(hand, seed), T[:1])
        bones = np.diff(hand.keypoints(R[0], p[0], wearer.scale)[columns], axis=0)
        # the knuckle is up to four standard deviations of 1.5 mm off, and off the centre line
        assert np.linalg.norm(bones, axis=1).sum() == pytest.approx(wearer.hand_length, abs=0.007)


def test_people_have_the_given_spread(hand: HandModel, glove: GloveModel) -> None:
    wearers = [Wearer(hand, glove, seed) for seed in range(150)]
    lengths = np.array([w.scale[:, 0] for w in wearers])
    common = lengths.mean(axis=1)
    assert common.std() == pytest.approx(0.05, rel=0.25)
    assert np.abs(common - 1).max() < 0.13
    assert (lengths / common[:, None]).std() == pytest.approx(0.02, rel=0.15)
    nominal = np.array([i.R_BI for i in glove.imus])
    turns = so3.log(np.array([np.swapaxes(nominal, 1, 2) @ w.imu_R_BI for w in wearers]))
    total = np.rad2deg(np.sqrt(np.mean(np.sum(turns**2, axis=-1))))
    assert total == pytest.approx(7.5, rel=0.07)


def test_synergy_error_is_five_to_eight_degrees(hand: HandModel, glove: GloveModel) -> None:
    upright = replace(WearerParams(), axis_deg=0.0, twist_per_flexion=0.0)
    errors = []
    i, j = hand.angle_index["index_dip_flexion"], hand.angle_index["index_pip_flexion"]
    for seed in range(25):
        angles = Wearer(hand, glove, seed, upright).truth(RandomPostures(hand, seed), T).angles
        errors.append(angles[:, i] - 0.67 * angles[:, j])
    assert 5.0 <= np.rad2deg(np.std(errors)) <= 8.0


def test_markers_are_placed_and_slip_on_the_surface(hand: HandModel, glove: GloveModel) -> None:
    offsets, slips = [], []
    for seed in range(60):
        wearer = Wearer(hand, glove, seed)
        nominal = glove.marker_position * wearer.scale[wearer.marker_segment]
        now, later = wearer.markers(1.0), wearer.markers(30.0)
        offsets.append(now - nominal)
        slips.append(later - now)
        np.testing.assert_allclose(np.sum(offsets[-1] * glove.marker_normal, axis=1), 0, atol=1e-9)
    rms = np.sqrt(np.mean(np.sum(np.array(offsets) ** 2, axis=2)))
    assert rms == pytest.approx(np.hypot(1.25e-3, 1e-3), rel=0.08)
    slip = np.sqrt(np.mean(np.sum(np.array(slips) ** 2, axis=2)))
    assert slip == pytest.approx(np.sqrt(2) * 1e-3, rel=0.15)


def test_wobble_has_the_given_size_and_depends_on_motion(
    hand: HandModel, glove: GloveModel
) -> None:
    motion = RandomPostures(hand, 2)
    turns = []
    for seed in range(40):
        wearer = Wearer(hand, glove, seed, replace(WearerParams(), mounting_deg=0.0))
        R_GI, _ = wearer.imus(motion, T[::8])
        R, _, _ = wearer.segments(motion, T[::8])
        mounted = np.swapaxes(R[:, wearer.imu_segment], -1, -2) @ R_GI
        nominal = np.array([i.R_BI for i in glove.imus])
        turns.append(so3.log(np.swapaxes(nominal, 1, 2) @ mounted))
    per_axis = np.rad2deg(np.std(turns))
    assert per_axis == pytest.approx(1.2, rel=0.15)


def test_one_seed_is_one_person(hand: HandModel, glove: GloveModel) -> None:
    one, same, other = Wearer(hand, glove, 4), Wearer(hand, glove, 4), Wearer(hand, glove, 5)
    np.testing.assert_array_equal(one.imu_R_BI, same.imu_R_BI)
    assert not np.allclose(one.scale, other.scale)


def test_left_hand_is_the_mirror_image(hand: HandModel, left_hand: HandModel) -> None:
    """The same angles with abduction and twist reversed put a left hand's points at -y."""
    angles = RandomPostures(hand, 1).poses(np.array([5.0])).angles[0]
    sign = np.array([1.0 if n.endswith("flexion") else -1.0 for n in hand.joint_names])
    right = hand.keypoints(*hand.forward(angles, np.eye(3), np.zeros(3)))
    left = left_hand.keypoints(*left_hand.forward(sign * angles, np.eye(3), np.zeros(3)))
    np.testing.assert_allclose(left, right * [1, -1, 1], atol=1e-8)


def test_flexion_beyond_a_right_angle_is_recovered() -> None:
    parent, column = np.array([-1, 0]), np.array([[-1, -1, -1], [0, 1, -1]])
    origin, rest = np.zeros((2, 3)), np.tile(np.eye(3), (2, 1, 1))
    angles = np.array([[0.1, 1.9], [-0.2, 1.3]])
    root = np.tile(np.eye(3), (2, 1, 1))
    R, _ = forward_many(parent, origin, rest, column, np.zeros(2), angles, root, np.zeros((2, 3)))
    np.testing.assert_allclose(angles_from_many(parent, rest, column, R, 2), angles, atol=1e-12)


def test_one_person_puts_the_glove_on_many_times(hand, glove):
    """Bones and synergies are unchanged; the fit of the glove is drawn again."""
    first, again = (Wearer.random(hand, glove, 7, fitting=fitting) for fitting in (7, 8))
    np.testing.assert_array_equal(first.scale, again.scale)
    np.testing.assert_array_equal(first._synergy_offset, again._synergy_offset)
    turned = np.linalg.norm(first.imu_R_BI - again.imu_R_BI, axis=(1, 2))
    assert turned.min() > np.deg2rad(1.0)
    assert np.abs(first.markers(1.0) - again.markers(1.0)).max() > 1e-3
    np.testing.assert_array_equal(Wearer.random(hand, glove, 7).imu_R_BI, first.imu_R_BI)
