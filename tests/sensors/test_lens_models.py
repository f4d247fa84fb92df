"""Lenses with more coefficients and fisheyes: files, rectification and sessions.

The oracle is OpenCV's own projection into the raw images: what is triangulated from those pixels
must be the points that were projected.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tests.sensors.test_rig_other_files import kalibr, tables
from tracker.base.errors import ConfigError, FileError
from tracker.calibration.stereo.checks import extrinsics_of, rig_problems
from tracker.calibration.stereo.files import calibration_text, load_rig, rig_text
from tracker.calibration.stereo.verify import verify
from tracker.calibration.stereo.views import StereoView
from tracker.messages import Array
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig, rig_of_one
from tracker.session.ros.sensors import pack_camera_info, unpack_camera_info
from tracker.vision.lens_models import distorted
from tracker.vision.rig import StereoRig

K = np.array([[520.0, 0.0, 641.0], [0.0, 523.0, 357.0], [0.0, 0.0, 1.0]])
R = cv2.Rodrigues(np.array([0.004, -0.011, 0.002]))[0]
T = np.array([-0.063, 0.0004, -0.0008])
LENSES = {
    "plumb bob": [-0.17, 0.026, 1e-4, -2e-4, -0.001],
    "rational": [0.4, -0.02, 1e-4, -2e-4, 0.003, 0.7, 0.05, 0.002],
    "thin prism": [-0.17, 0.026, 1e-4, -2e-4, 0.0, 0.01, 0.0, 0.0, 1e-3, -5e-4, 7e-4, 2e-4],
    "tilted": [-0.17, 0.026, 1e-4, -2e-4, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.01, -0.02],
    "fisheye": [0.05, -0.02, 0.006, -0.001],
}


def lens(name: str) -> Intrinsics:
    return Intrinsics(1280, 720, K, np.array(LENSES[name]), name == "fisheye")


def seen(points: Array, camera: Intrinsics, R: Array, T: Array) -> Array:
    """Raw pixels (n, 2) by OpenCV."""
    project = cv2.fisheye.projectPoints if camera.fisheye else cv2.projectPoints
    turn = cv2.Rodrigues(R)[0]
    uv, _ = project(points.reshape(-1, 1, 3), turn, T.reshape(3, 1), camera.K, camera.D)
    return uv.reshape(-1, 2)


def points_L() -> Array:
    rng = np.random.default_rng(5)
    z = rng.uniform(0.25, 0.6, 60)
    return np.column_stack([rng.uniform(-0.7, 0.7, 60) * z, rng.uniform(-0.4, 0.4, 60) * z, z])


def assert_triangulates(rig: StereoRig, left: Intrinsics, right: Intrinsics) -> None:
    """To 1 µm: a distortion is inverted iteratively."""
    points = points_L()
    uv = seen(points, left, np.eye(3), np.zeros(3)), seen(points, right, R, T)
    found = rig.triangulate(rig.left.rectify(uv[0]), rig.right.rectify(uv[1]))
    assert np.abs(found - points @ rig.left.R.T).max() < 1e-6
    np.testing.assert_allclose(rig.left.unrectify(rig.left.rectify(uv[0])), uv[0], atol=1e-4)


@pytest.mark.parametrize("name", LENSES)
def test_images_are_those_of_opencv(name: str) -> None:
    camera, points = lens(name), points_L()
    found = distorted(points, camera.K, camera.D, camera.fisheye)
    np.testing.assert_allclose(found, seen(points, camera, np.eye(3), np.zeros(3)), atol=1e-9)


@pytest.mark.parametrize("name", LENSES)
def test_a_file_of_ours_keeps_the_lens(name: str, tmp_path: Path) -> None:
    camera = lens(name)
    path = tmp_path / "rig.yml"
    path.write_text(calibration_text(camera, camera, R, T))
    rig = load_rig(path)
    assert_triangulates(rig, camera, camera)
    path.write_text(rig_text(rig))
    assert_triangulates(load_rig(path), camera, camera)


@pytest.mark.parametrize("name", LENSES)
def test_a_session_keeps_the_lens(name: str) -> None:
    camera = lens(name)
    rig = rectified_rig(camera, camera, R, T)
    again = [unpack_camera_info(pack_camera_info(0, "c", c)) for c in (rig.left, rig.right)]
    assert_triangulates(replace(rig, left=again[0], right=again[1]), camera, camera)
    assert again[0].fisheye == camera.fisheye


@pytest.mark.parametrize("name", LENSES)
def test_a_single_camera_is_verified_by_its_own_lens(name: str) -> None:
    camera = lens(name)
    grid = np.array([[x, y, 0.0] for x in range(9) for y in range(6)]) * 0.02
    views = []
    for k in range(4):
        turn = cv2.Rodrigues(np.array([0.3 * k - 0.4, 0.2, 0.1 * k]))[0]
        uv = seen(grid, camera, turn, np.array([-0.06, -0.04, 0.3]))
        views.append(StereoView(np.arange(len(grid)), grid, uv, None))
    good = verify(rig_of_one(camera), views).rms_px
    bent = replace(camera, D=camera.D * 1.3)
    assert good < 1e-3 and verify(rig_of_one(bent), views).rms_px > 0.04


def test_fisheyes_of_kalibr_and_anipose(tmp_path: Path) -> None:
    chain, table = tmp_path / "camchain.yaml", tmp_path / "calibration.toml"
    weak = {"distortion_model": "equidistant", "distortion_coeffs": "[0.02, -0.01, 0.003, 0.0]"}
    chain.write_text(kalibr(**weak))
    table.write_text(tables(1.0, fisheye=True, distortions=[0.02, -0.01, 0.003, 0.0]))
    one, other = load_rig(chain), load_rig(table)
    assert one.left.fisheye and other.right.fisheye
    uv = np.array([[100.0, 80.0], [600.0, 400.0]])
    np.testing.assert_allclose(one.left.rectify(uv), other.left.rectify(uv), atol=1e-6)


def test_a_ros_file_of_a_fisheye(tmp_path: Path) -> None:
    path = tmp_path / "left.yaml"
    path.write_text(
        "image_width: 1280\nimage_height: 720\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
        f"  data: {K.ravel().tolist()}\ndistortion_model: equidistant\n"
        f"distortion_coefficients:\n  rows: 1\n  cols: 4\n  data: {LENSES['fisheye']}\n"
    )
    rig = load_rig(path)
    assert rig.one_camera and rig.left.fisheye
    np.testing.assert_allclose(rig.left.D, LENSES["fisheye"])


def test_impossible_lenses_are_refused(tmp_path: Path) -> None:
    camera = lens("fisheye")
    with raises(ConfigError, "stereo.mixed_lenses"):
        rectified_rig(camera, lens("rational"), R, T)
    folded = replace(camera, D=np.array([-0.9, 0.0, 0.0, 0.0]))
    codes = [p.code for p in rig_problems(extrinsics_of(rig_of_one(folded)))]
    assert "stereo.distortion" in codes
    codes = [p.code for p in rig_problems(extrinsics_of(rig_of_one(camera)))]
    assert "stereo.distortion" not in codes
    path = tmp_path / "rig.yml"
    path.write_text(calibration_text(replace(camera, D=np.zeros(6)), None))
    with raises(FileError, "stereo.coefficients"):
        load_rig(path)
