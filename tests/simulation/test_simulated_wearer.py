"""A simulated person differs from the files by the parameters, and in nothing else."""

from dataclasses import replace

import numpy as np
import pytest

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.output.completion import Completion
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array
from tracker.simulation.kinematics import angles_from_many, forward_many
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.wearer import FINGER, THUMB, EndJoints, Wearer, WearerParams

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
    lengths, girths = (np.array([w.scale[:, k] for w in wearers]) for k in (0, 1))
    common, breadth = lengths.mean(axis=1), girths.mean(axis=1)
    assert common.std() == pytest.approx(0.06, rel=0.25)
    assert np.abs(common - 1).max() < 0.19
    assert (lengths / common[:, None]).std() == pytest.approx(0.04, rel=0.15)
    # ANSUR II, men and women: breadth and length correlate by 0.71; breadth varies by 7.5 %
    assert np.corrcoef(common, breadth)[0, 1] == pytest.approx(0.71, abs=0.12)
    assert breadth.std() == pytest.approx(0.075, rel=0.2)
    nominal = np.array([i.R_BI for i in glove.imus])
    turns = so3.log(np.array([np.swapaxes(nominal, 1, 2) @ w.imu_R_BI for w in wearers]))
    total = np.rad2deg(np.sqrt(np.mean(np.sum(turns**2, axis=-1))))
    assert total == pytest.approx(7.5, rel=0.07)


def residual_deg(hand: HandModel, angle: str, of: str, seeds: range) -> tuple[Array, Array]:
    """For each person, the residual of ``angle`` about a line over ``of``, and the correlation."""
    residual, correlation = [], []
    i, j = hand.angle_index[f"{angle}_flexion"], hand.angle_index[f"{of}_flexion"]
    for seed in seeds:
        poses = RandomPostures(hand, seed).poses(np.arange(2.0, 60.0, 0.4)).angles
        ends = EndJoints(hand, np.random.default_rng(seed), FINGER, THUMB, 2.0)
        poses[:, ends.angle] += ends.deviation(np.arange(2.0, 60.0, 0.4), poses)
        x, y = poses[:, j], poses[:, i]
        residual.append(np.std(y - np.polyval(np.polyfit(x, y, 1), x)))
        correlation.append(np.corrcoef(x, y)[0, 1])
    return np.rad2deg(residual), np.array(correlation)


@pytest.mark.parametrize(
    ("angle", "of", "least", "most"),
    [
        ("thumb_ip", "thumb_mcp", 5, 23),
        ("index_dip", "index_pip", 4, 17),
        ("ring_mcp", "middle_mcp", 12, 24),
        ("ring_pip", "middle_pip", 8, 17),
        ("little_mcp", "ring_mcp", 8, 15),
        ("little_pip", "ring_pip", 6, 15),
    ],
)
def test_joints_depend_on_their_neighbours_as_in_recordings(
    hand: HandModel, angle: str, of: str, least: float, most: float
) -> None:
    """The extremes are those of 7 and 16 recorded people; the median is in the middle half of that
    range, and most simulated people are within it."""
    residual, _ = residual_deg(hand, angle, of, range(24))
    quarter = (most - least) / 4
    assert least + 0.5 * quarter < np.median(residual) < most - quarter
    assert np.mean((residual > least - 2) & (residual < most + 2)) > 0.7


def test_end_joints_correlate_with_either_sign(hand: HandModel) -> None:
    """Recorded thumbs: -0.7 to 0.7; index fingers -0.4 to 0.7, and 0.9 where nothing is held."""
    _, thumb = residual_deg(hand, "thumb_ip", "thumb_mcp", range(24))
    assert abs(np.median(thumb)) < 0.35 and thumb.min() < -0.4 and thumb.max() > 0.4
    _, index = residual_deg(hand, "index_dip", "index_pip", range(24))
    assert 0.3 < np.median(index) < 0.8 and index.min() < 0.1


def test_end_joints_are_steady_in_a_held_posture(hand: HandModel) -> None:
    """They differ between postures, and drift by a few degrees within one."""
    t = np.arange(0.0, 40.0, 0.5)
    held = np.tile(RandomPostures(hand, 1).poses(np.array([20.0])).angles, (len(t), 1))
    drift = []
    for seed in range(20):
        ends = EndJoints(hand, np.random.default_rng(seed), FINGER, THUMB, 2.0)
        drift.append(ends.deviation(t, held).std(axis=0))
    assert 2.0 < np.rad2deg(np.mean(drift)) < 4.0


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
    np.testing.assert_array_equal(first.end_joints.offset, again.end_joints.offset)
    turned = np.linalg.norm(first.imu_R_BI - again.imu_R_BI, axis=(1, 2))
    assert turned.min() > np.deg2rad(1.0)
    assert np.abs(first.markers(1.0) - again.markers(1.0)).max() > 1e-3
    np.testing.assert_array_equal(Wearer.random(hand, glove, 7).imu_R_BI, first.imu_R_BI)
