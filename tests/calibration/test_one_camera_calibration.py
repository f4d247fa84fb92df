"""Calibration of one camera, and of two with different image sizes."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.checks import Extrinsics, extrinsics_of, rig_problems
from tracker.calibration.stereo.collect import Collector, ExposureResult
from tracker.calibration.stereo.coverage import advice, coverage
from tracker.calibration.stereo.files import load_rig, save_calibration
from tracker.calibration.stereo.solve import Solution, SolveParams, solve
from tracker.calibration.stereo.verify import verify
from tracker.calibration.stereo.views import BoardFinder, BoardLook, StereoView
from tracker.geometry import so3
from tracker.messages import Array
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig, rig_of_one
from tracker.simulation.board_camera import BoardCamera
from tracker.simulation.board_images import BoardPose, TrueRig, board_poses

SPEC = BoardSpec()
WEBCAM = Intrinsics(
    640,
    480,
    np.array([[610.0, 0.0, 322.0], [0.0, 611.0, 236.0], [0.0, 0.0, 1.0]]),
    np.array([0.08, -0.15, 0.0006, -0.0004, 0.0]),
)
WIDE = Intrinsics(
    1280,
    720,
    np.array([[1010.0, 0.0, 642.0], [0.0, 1011.0, 355.0], [0.0, 0.0, 1.0]]),
    np.array([-0.10, 0.02, 0.0, 0.0, 0.0]),
)
NOISE_PX = 0.1
ALONE = TrueRig(WEBCAM, None, np.eye(3), np.zeros(3))


def seen_by(camera: Intrinsics, p_C: Array, rng: np.random.Generator) -> Array:
    uv, _ = cv2.projectPoints(p_C, np.zeros(3), np.zeros(3), camera.K, camera.D)
    return uv.reshape(-1, 2) + rng.normal(0, NOISE_PX, (len(p_C), 2))


def view_of(pose: BoardPose, rng: np.random.Generator) -> StereoView:
    uv = seen_by(WEBCAM, SPEC.points @ pose.R_CB.T + pose.p_CB, rng)
    return StereoView(np.arange(SPEC.corner_count), SPEC.points, uv, None)


@lru_cache
def views(count: int, seed: int) -> tuple[StereoView, ...]:
    rng = np.random.default_rng(seed)
    return tuple(view_of(p, rng) for p in board_poses(SPEC, ALONE, count, seed))


@lru_cache
def solution() -> Solution:
    return solve(views(16, 1), [(640, 480)])


def test_one_camera_is_calibrated_within_half_a_per_cent() -> None:
    s = solution()
    assert s.right is None and s.error.shape == (16, 1)
    assert s.left.K[0, 0] == pytest.approx(610.0, rel=0.005)
    assert s.left.K[:2, 2] == pytest.approx(WEBCAM.K[:2, 2], abs=3.0)
    assert s.rms_px < 2 * NOISE_PX
    assert rig_problems(Extrinsics(s.left, None, s.R, s.T)) == []


def test_its_rig_has_the_rays_of_the_lens() -> None:
    rig = rig_of_one(WEBCAM)
    assert rig.one_camera and rig.sides == ("left",)
    p_C = np.random.default_rng(2).uniform([-0.1, -0.1, 0.3], [0.1, 0.1, 0.6], (20, 3))
    raw = seen_by(WEBCAM, p_C, np.random.default_rng(0))
    assert rig.project(p_C) == pytest.approx(rig.left.rectify(raw), abs=4 * NOISE_PX)


def test_new_views_verify_it() -> None:
    fresh = views(6, 77)
    good = verify(solution().rig, fresh)
    assert good.verdict()[0] == "good" and good.one_camera
    bent = replace(WEBCAM, D=WEBCAM.D + [0.5, 0.0, 0.0, 0.0, 0.0])
    assert verify(rig_of_one(bent), fresh).verdict()[0] == "refused"
    assert verify(solution().rig, fresh[:2]).verdict()[0] == "waiting"


def test_an_impossible_lens_is_rejected() -> None:
    fisheye = replace(WEBCAM, D=np.array([1.5, 0, 0, 0, 0.0]))
    (problem,) = rig_problems(Extrinsics(fisheye, None, np.eye(3), np.zeros(3)))
    assert (problem.code, problem.values["lens"]) == ("stereo.distortion", "lens")


def test_its_file_is_accepted_wherever_a_calibration_is(tmp_path: Path) -> None:
    path = tmp_path / "webcam.yml"
    save_calibration(path, WEBCAM, note="16 views")
    rig = load_rig(path)
    assert rig.one_camera and (rig.left.width, rig.left.height) == (640, 480)
    back = extrinsics_of(rig)
    assert back.right is None and np.array_equal(back.left.K, WEBCAM.K)
    assert np.array_equal(back.left.D, WEBCAM.D)


ROS = """image_width: 640
image_height: 480
camera_name: webcam
camera_matrix:
  rows: 3
  cols: 3
  data: [610., 0., 322., 0., 611., 236., 0., 0., 1.]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.08, -0.15, 0.0006, -0.0004, 0.]
"""


def test_a_ros_file_is_of_one_camera(tmp_path: Path) -> None:
    path = tmp_path / "webcam.yaml"
    path.write_text(ROS)
    rig = load_rig(path)
    assert rig.one_camera and np.array_equal(rig.left.K, WEBCAM.K)
    path.write_text(ROS.replace("[610.", "[6.10"))
    with raises(ConfigError, "stereo.refused"):
        load_rig(path)


def test_views_of_one_camera_are_collected_and_advised() -> None:
    collector = Collector(640)
    first, second = views(16, 1)[:2]
    answers = [collector.offer(BoardLook(None, None, v)) for v in (first, first, second, second)]
    assert answers == [
        ExposureResult.MOVING,
        ExposureResult.TAKEN,
        ExposureResult.MOVING,
        ExposureResult.TAKEN,
    ]
    cover = coverage(collector.views, [(640, 480)])
    assert len(cover.maps) == 1 and 0 < cover.area < 1
    more = advice(cover)
    assert more is not None and more.code in ("stereo.cover_empty", "stereo.cover_tilt")


def test_a_simulated_board_in_front_of_one_camera_is_found() -> None:
    camera = BoardCamera(rig_of_one(WEBCAM), SPEC, sleep=lambda _dt: None)
    camera.open()
    pair = camera.read()
    assert pair is not None and pair[1] is None
    look = BoardFinder(SPEC).look(*pair)
    assert look.view is not None and look.view.right is None
    empty = BoardFinder(SPEC).look(np.full_like(pair[0], 90))
    assert empty.problem is not None and empty.problem.code == "board.not_seen"


# --- two cameras whose images differ in size


R, T = so3.exp(np.array([0.01, 0.02, -0.004])), np.array([-0.055, 0.001, 0.0005])


def test_two_images_of_different_sizes_make_a_rig(tmp_path: Path) -> None:
    """A colour camera and an infrared one: points are recovered from the pixels of both."""
    path = tmp_path / "depth.yml"
    save_calibration(path, WIDE, WEBCAM, R, T)
    rig = load_rig(path)
    assert (rig.right.width, rig.right.height) == (640, 480)
    p_C = np.random.default_rng(3).uniform([-0.08, -0.08, 0.3], [0.08, 0.08, 0.6], (20, 3))
    none = np.zeros(3)
    left, _ = cv2.projectPoints(p_C, none, none, WIDE.K, WIDE.D)
    right, _ = cv2.projectPoints(p_C, cv2.Rodrigues(R)[0], T, WEBCAM.K, WEBCAM.D)
    found = rig.triangulate(
        rig.left.rectify(left.reshape(-1, 2)), rig.right.rectify(right.reshape(-1, 2))
    )
    assert found @ rig.left.R == pytest.approx(p_C, abs=2e-5)


def test_they_are_calibrated_together() -> None:
    pair = TrueRig(WIDE, WEBCAM, R, T)
    rng, taken = np.random.default_rng(1), []
    for pose in board_poses(SPEC, pair, 14, 3):
        p_C = SPEC.points @ pose.R_CB.T + pose.p_CB
        sides = seen_by(WIDE, p_C, rng), seen_by(WEBCAM, p_C @ R.T + T, rng)
        taken.append(StereoView(np.arange(SPEC.corner_count), SPEC.points, *sides))
    s = solve(taken, [(1280, 720), (640, 480)])
    assert s.right is not None and (s.right.width, s.right.height) == (640, 480)
    assert pytest.approx(T, abs=1e-3) == s.T
    assert verify(s.rig, taken[:5]).rms_px < 0.5
    assert rig_problems(Extrinsics(s.left, s.right, s.R, s.T)) == []


def test_the_rectified_right_image_keeps_its_own_size() -> None:
    rig = rectified_rig(WIDE, WEBCAM, R, T)
    assert (rig.left.width, rig.right.width) == (1280, 640)
    assert np.array_equal(rig.left.P[:, :3], rig.right.P[:, :3])


@pytest.mark.data
def test_real_chessboard_images_of_one_camera_give_its_lens(data_folder: Path) -> None:
    """The left ones of OpenCV's samples; PROVENANCE.txt lists f 536 px and 0.41 px."""
    finder, found = BoardFinder(BoardSpec("chessboard", 10, 7, 0.025)), []
    for path in sorted((data_folder / "stereo_chessboard").glob("left*.jpg")):
        look = finder.look(cv2.imread(str(path)), None)
        assert look.view is not None and look.view.right is None, f"{path.name}: {look.problem}"
        found.append(look.view)
    s = solve(found, [(640, 480)], SolveParams(least_views=len(found)))
    assert s.rms_px < 0.5
    assert s.left.K[0, 0] == pytest.approx(536, rel=0.015)
    assert rig_problems(Extrinsics(s.left, None, s.R, s.T)) == []
