"""Stereo calibrations of other programs: the rectified rig must agree with the original lenses."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.sensors.rig_files import find_zed_file, load_opencv_stereo, load_zed
from tracker.vision.rig import StereoRig

ZED = """
[LEFT_CAM_HD]
fx = 700.8
fy = 700.8
cx = 665.4
cy = 371.9
k1 = -0.174
k2 = 0.026
k3 = 0.001
[RIGHT_CAM_HD]
fx=698.7
fy=698.7
cx=640.1
cy=375.1
k1=-0.172
k2=0.025
[STEREO]
Baseline=62.8
TY=-0.08
TZ=-0.03
CV_HD=0.0099
RX_HD=0.005
RZ_HD=-0.002
"""
TURN = np.array([0.005, 0.0099, -0.002])
T = np.array([-62.8, -0.08, -0.03]) / 1000


def assert_triangulates(rig: StereoRig, R: np.ndarray, T: np.ndarray) -> None:
    """Points seen by both raw lenses are recovered: X_right = R X_left + T, projected by OpenCV."""
    p = np.random.default_rng(3).uniform([-0.1, -0.1, 0.3], [0.1, 0.1, 0.6], (20, 3))
    none = np.zeros(3)
    left, _ = cv2.projectPoints(p, none, none, rig.left.K, rig.left.D)
    right, _ = cv2.projectPoints(p, cv2.Rodrigues(R)[0], T, rig.right.K, rig.right.D)
    found = rig.triangulate(
        rig.left.rectify(left.reshape(-1, 2)), rig.right.rectify(right.reshape(-1, 2))
    )
    assert found @ rig.left.R == pytest.approx(p, abs=2e-5)  # C is the left lens rotated by R1


def test_zed_convention(tmp_path: Path) -> None:
    path = tmp_path / "SN12.conf"
    path.write_text(ZED)
    rig = load_zed(path)
    assert rig.baseline == pytest.approx(np.linalg.norm(T), abs=1e-9)
    assert (rig.left.width, rig.left.height) == (1280, 720)
    assert np.allclose(rig.left.D, [-0.174, 0.026, 0, 0, 0.001])
    assert_triangulates(rig, cv2.Rodrigues(TURN)[0], T)
    assert find_zed_file(12, [tmp_path / "none", tmp_path]) == path
    assert find_zed_file(13, [tmp_path]) is None


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("RX_HD=0.005\n", "", "zed.missing_key"),
        ("fx=698.7\n", "fx=wide\n", "zed.not_number"),
        ("[STEREO]", "[OTHER]", "zed.missing_key"),
        ("[LEFT_CAM_HD]", "", "zed.not_calibration"),
        ("Baseline=62.8", "Baseline=nan", "zed.not_number"),
    ],
)
def test_zed_damage_is_reported(tmp_path: Path, old: str, new: str, words: str) -> None:
    path = tmp_path / "SN12.conf"
    path.write_text(ZED.replace(old, new))
    with raises(FileError, words):
        load_zed(path)


def test_zed_swapped_sides(tmp_path: Path) -> None:
    path = tmp_path / "SN12.conf"
    path.write_text(ZED.replace("Baseline=62.8", "Baseline=-62.8"))
    with raises(ConfigError, "stereo.baseline_negative"):
        load_zed(path)


@pytest.mark.data
def test_real_zed_files(data_folder: Path) -> None:
    folder = data_folder / "zed_calibration"
    for height in (1242, 1080, 720, 376):
        rig = load_zed(folder / "SN1010_zed1_factory.conf", height)
        assert rig.baseline == pytest.approx(0.120, abs=1e-9)
        turn = cv2.Rodrigues(np.array([0.00497864, 0.00958521, -0.00185401]))[0]
        assert_triangulates(rig, turn, np.array([-0.120, 0, 0]))
    with raises(FileError, "zed.missing_key"):
        load_zed(folder / "zed1_orbslam2ros6_spaced_partial.conf")
    with raises(FileError, "zed.height"):
        load_zed(folder / "SN1010_zed1_factory.conf", 480)


def write_opencv(path: Path, **matrices: np.ndarray) -> Path:
    storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_WRITE)
    for name, matrix in matrices.items():
        storage.write(name, matrix)
    storage.release()
    return path


def test_opencv_pair_of_files(tmp_path: Path) -> None:
    K = np.array([[700.0, 0, 640], [0, 701, 360], [0, 0, 1]])
    R = cv2.Rodrigues(TURN)[0]
    D = np.array([[-0.1, 0.02, 0.001, -0.001, 0.0]])
    first = write_opencv(tmp_path / "intrinsics.yml", M1=K, D1=D, M2=K + 0, D2=D)
    second = write_opencv(tmp_path / "extrinsics.yml", R=R, T=(T * 1000).reshape(3, 1))
    rig = load_opencv_stereo([first, second], 1280, 720, unit=1e-3)
    assert rig.baseline == pytest.approx(np.linalg.norm(T), abs=1e-9)
    assert_triangulates(rig, R, T)
    with raises(FileError, "stereo.matrix_missing"):
        load_opencv_stereo([first], 1280, 720)


def test_opencv_damage_is_reported(tmp_path: Path) -> None:
    K, D = np.eye(3), np.zeros((1, 5))
    good = {"M1": K, "D1": D, "M2": K, "D2": D, "R": np.eye(3), "T": np.array([[-0.1], [0], [0]])}
    bad = [
        ({"R": 2 * np.eye(3)}, "stereo.no_rotation"),
        ({"D1": np.full((1, 15), 0.1)}, "stereo.coefficients"),
        ({"T": np.zeros((2, 1))}, "stereo.matrix_shape"),
    ]
    for n, (change, code) in enumerate(bad):
        path = write_opencv(tmp_path / f"{n}.yml", **{**good, **change})
        with raises(FileError, code):
            load_opencv_stereo([path], 640, 480)
    path = tmp_path / "text.yml"
    path.write_text("%YAML:1.0\n---\nM1: [broken")
    with pytest.raises(FileError):
        load_opencv_stereo([path], 640, 480)
