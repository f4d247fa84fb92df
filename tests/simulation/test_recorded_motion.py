"""Recorded hands: file formats are parsed, and a known motion is recovered from its points."""

from pathlib import Path

import numpy as np
import pytest

from tests.fixtures import DATA
from tests.notices import raises
from tracker.base.errors import FileError
from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.recorded.load import (
    TARGETS,
    SplineMotion,
    load_motion,
    read_bvh,
    read_track,
)
from tracker.simulation.recorded.track import PointTrack, mirrored

G_FROM_LEAP = np.array([[0.0, 0, -1], [-1, 0, 0], [0, 1, 0]])  # x right, y up, z to the user


def _keypoints(
    hand: HandModel, motion: SimulatedMotion, t: np.ndarray, size: float = 1.0
) -> np.ndarray:
    """(n, 20, 3) Leap's joints of the moving hand in G, all lengths times ``size``."""
    rows = [hand.keypoint_names.index(n) for n in TARGETS]
    poses = motion.poses(t)
    points = [hand.keypoints(*hand.forward(a, R, p)) for a, R, p in zip(*poses, strict=True)]
    return np.array(points)[:, rows] * size


def _write_leap(path: Path, t: np.ndarray, points_G: np.ndarray, side: str = "right") -> None:
    joints = 1000 * points_G @ G_FROM_LEAP
    np.savez(path, t=t, joints=joints.reshape(-1, 5, 4, 3), hand=np.array([side]))


@pytest.fixture(scope="module")
def known(hand: HandModel) -> RandomPostures:
    return RandomPostures(hand, 6, duration=8)


def test_known_motion_is_recovered_from_its_points(
    hand: HandModel, known: RandomPostures, tmp_path: Path
) -> None:
    """Joints of a 10 % larger hand; angles, relative rotations and the path are recovered."""
    t = np.arange(0, 8, 0.01)
    _write_leap(tmp_path / "hand.npz", t, _keypoints(hand, known, t, size=1.1))
    motion = load_motion(tmp_path / "hand.npz", hand)
    at = np.arange(0.5, 7.5, 0.05)
    found, true = motion.poses(at), known.poses(at)
    fingers = [i for i, n in enumerate(hand.joint_names) if n.endswith("p_flexion")]
    gap = np.rad2deg(np.abs(found.angles - true.angles))[:, fingers]
    assert np.median(gap) < 4 and np.percentile(gap, 90) < 15
    between = np.swapaxes(found.R_GB[:1], 1, 2) @ found.R_GB
    expected = np.swapaxes(true.R_GB[:1], 1, 2) @ true.R_GB
    turn = np.linalg.norm(so3.log(np.swapaxes(between, 1, 2) @ expected), axis=1)
    assert np.rad2deg(np.percentile(turn, 90)) < 8
    assert motion.residual < 0.003
    assert found.R_GB[0, 2, 2] > 0.9  # up is preserved


@pytest.mark.long
def test_gaps_are_filled(hand: HandModel, known: RandomPostures, tmp_path: Path) -> None:
    t = np.arange(0, 8, 0.01)
    points = _keypoints(hand, known, t)
    _write_leap(tmp_path / "whole.npz", t, points)
    points[100:130, TARGETS.index("index_tip")] = np.nan
    points[300:340, TARGETS.index("thumb_tip")] = np.nan
    _write_leap(tmp_path / "gaps.npz", t, points)
    whole, gaps = (load_motion(tmp_path / f"{n}.npz", hand) for n in ("whole", "gaps"))
    at = np.arange(0.5, 7.5, 0.02)
    difference = np.rad2deg(np.abs(whole.poses(at).angles - gaps.poses(at).angles))
    assert np.isfinite(difference).all() and np.percentile(difference, 99) < 15


def test_left_hand_is_mirrored(hand: HandModel, known: RandomPostures, tmp_path: Path) -> None:
    t = np.arange(0, 4, 0.01)
    points = _keypoints(hand, known, t)
    _write_leap(tmp_path / "right.npz", t, points)
    _write_leap(tmp_path / "left.npz", t, points * [1, -1, 1], "left")
    right, left = (load_motion(tmp_path / f"{n}.npz", hand) for n in ("right", "left"))
    at = np.arange(0.5, 3.5, 0.1)
    np.testing.assert_allclose(left.poses(at).angles, right.poses(at).angles, atol=0.02)


def test_mirroring_preserves_distances_and_up() -> None:
    points = np.random.default_rng(1).normal(size=(4, 7, 3))
    track = PointTrack(np.arange(4.0), points, ("wrist",) * 7, np.array([0, 1.0, 0]), "left", None)
    other = mirrored(track, "right")
    np.testing.assert_allclose(other.points @ track.up, points @ track.up)
    np.testing.assert_allclose(
        np.linalg.norm(other.points[:, 0] - other.points[:, 3], axis=1),
        np.linalg.norm(points[:, 0] - points[:, 3], axis=1),
    )
    triple = np.linalg.det(points[:, :3] - points[:, 3:4])
    np.testing.assert_allclose(np.linalg.det(other.points[:, :3] - other.points[:, 3:4]), -triple)


def test_spline_passes_slow_motion_unchanged(hand: HandModel) -> None:
    t = np.arange(0, 6, 0.02)
    angles = np.outer(0.3 + 0.2 * np.sin(2 * np.pi * 0.5 * t), np.ones(len(hand.joint_names)) * 0.3)
    R = so3.exp(np.outer(np.sin(t), [0.2, 1.2, 0.4]))
    p = np.column_stack([0.1 * np.sin(2 * t), 0.1 * np.cos(t), 0 * t])
    motion = SplineMotion(t, angles, R, p, hand.angle_limits)
    at = np.arange(0.503, 5.4, 0.037)
    found = motion.poses(at)
    np.testing.assert_allclose(found.p_GB[:, 0], 0.1 * np.sin(2 * at), atol=2e-4)
    expected = so3.exp(np.outer(np.sin(at), [0.2, 1.2, 0.4]))
    np.testing.assert_allclose(found.R_GB, expected, atol=2e-3)


BVH = """HIERARCHY
ROOT RightHand
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
%s}
MOTION
Frames: 2
Frame Time: 0.01
0 0 0 0 0 0 %s
1 2 3 90 0 0 %s
"""


def _bvh() -> str:
    finger = """  JOINT Right{0}1
  {{
    OFFSET 8 0 {1}
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Right{0}2
    {{
      OFFSET 4 0 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT Right{0}3
      {{
        OFFSET 3 0 0
        CHANNELS 3 Zrotation Xrotation Yrotation
        End Site
        {{
          OFFSET 2 0 0
        }}
      }}
    }}
  }}
"""
    names = ("HandThumb", "HandIndex", "HandMiddle", "HandRing", "HandPinky")
    text = "".join(finger.format(n, i) for i, n in enumerate(names))
    bent = " ".join(["0 0 0 90 0 0 0 0 0"] * 5)
    return BVH % (text, " ".join(["0"] * 45), bent)


def test_bvh_positions_are_those_of_its_own_kinematics() -> None:
    track = read_bvh(Path("x.bvh"), _bvh())
    at = {n: i for i, n in enumerate(track.targets)}
    assert len(at) == 20 and track.side == "right"
    np.testing.assert_allclose(track.points[0, at["index_tip"]], [17, 0, 1])
    # second frame: the root turned 90° about z at (1, 2, 3), the PIP 90° about z again
    np.testing.assert_allclose(track.points[1, at["index_pip"]], [1, 14, 4], atol=1e-9)
    np.testing.assert_allclose(track.points[1, at["index_tip"]], [-4, 14, 4], atol=1e-9)


@pytest.mark.parametrize(
    ("name", "text", "code"),
    [
        ("a.bvh", "nothing", "motion.not_bvh"),
        ("a.tsv", "nothing", "motion.not_qualisys"),
        ("a.npz", "nothing", "motion.not_leap"),
        ("a.txt", "nothing", "motion.unknown_kind"),
    ],
)
def test_other_files_are_rejected(tmp_path: Path, name: str, text: str, code: str) -> None:
    (tmp_path / name).write_text(text)
    with raises(FileError, code):
        read_track(tmp_path / name)


def _recording(*parts: str) -> Path:
    path = DATA.joinpath(*parts)
    if not path.is_file():
        pytest.skip(f"{path.name} is not here")
    return path


@pytest.mark.data
def test_qualisys_gaps_and_rigid_triangle_match_its_notes() -> None:
    track = read_track(_recording("dfki_hand_mocap", "recording.tsv"))
    missing = np.isnan(track.points[:, :, 0]).mean(axis=0)
    assert missing[track.targets.index("thumb_tip")] == pytest.approx(0.082, abs=0.001)
    top, left = (track.points[:, track.targets.index(f"dorsum:{n}")] for n in ("top", "left"))
    side = np.linalg.norm(top - left, axis=1)
    assert min(abs(side.mean() - s) for s in (55.2, 44.7, 32.4)) < 0.1 and side.std() < 0.2


@pytest.mark.data
@pytest.mark.parametrize("name", ["pinch__right31", "confidence2__left123"])
def test_real_hands_are_fitted_within_limits(hand: HandModel, name: str) -> None:
    motion = load_motion(_recording("leap_recordings", "decoded", f"{name}.npz"), hand)
    poses = motion.poses(np.arange(0, motion.duration, 0.02))
    assert motion.residual < 0.004
    slack = np.deg2rad(2)
    assert np.all(poses.angles > hand.angle_limits[:, 0] - slack)
    assert np.all(poses.angles < hand.angle_limits[:, 1] + slack)
