"""Calibrations of Kalibr, Anipose and Caliscope, as these programs write them.

The files have the form of the programs' own documentation. The rig must agree with the lenses as
OpenCV projects with them.
"""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
import tomli_w

from tests.notices import raises
from tests.sensors.test_stereo_files import assert_triangulates
from tracker.base.errors import ConfigError, FileError
from tracker.calibration.stereo.files import MissingFacts, load_rig
from tracker.messages import Array
from tracker.vision.rig import StereoRig

TURN, T = np.array([0.004, -0.011, 0.002]), np.array([-0.11, 0.0004, -0.0008])
R = cv2.Rodrigues(TURN)[0]
LEFT = {"K": (458.654, 457.296, 367.215, 248.375), "D": (-0.2834, 0.0739, 0.00019, 1.76e-05)}
RIGHT = {"K": (457.587, 456.134, 379.999, 255.238), "D": (-0.2836, 0.0745, -0.0001, -3.5e-05)}


def kalibr(right: bool = True, **changed: str) -> str:
    """As ``kalibr_calibrate_cameras`` writes it; lists may span lines."""

    def camera(name: str, values: dict[str, tuple[float, ...]], pose: str) -> str:
        fields = {
            "camera_model": "pinhole",
            "distortion_coeffs": str(list(values["D"])).replace(", ", ",\n    ", 1),
            "distortion_model": "radtan",
            "intrinsics": str(list(values["K"])),
            "resolution": "[752, 480]",
            "rostopic": f"/{name}/image_raw",
        }
        lines = "".join(f"  {k}: {v}\n" for k, v in {**fields, **changed}.items())
        return f"{name}:\n{pose}  cam_overlaps: [1]\n{lines}"

    rows = np.vstack([np.column_stack([R, T]), [0.0, 0.0, 0.0, 1.0]])
    pose = "  T_cn_cnm1:\n" + "".join(f"  - {row}\n" for row in rows.tolist())
    return camera("cam0", LEFT, "") + (camera("cam1", RIGHT, pose) if right else "")


def tables(unit: float, nested: bool = False, **changed: object) -> str:
    """Anipose's and FreeMoCap's file; ``nested`` Caliscope's. World and cameras as anywhere."""
    R0 = cv2.Rodrigues(np.array([0.3, -2.0, 0.4]))[0]
    t0 = np.array([0.5, -0.2, 1.4])
    poses = ((R0, t0), (R @ R0, R @ t0 + T))
    cameras = {}
    for k, (values, (R_k, t_k)) in enumerate(zip((LEFT, RIGHT), poses, strict=True)):
        fx, fy, cx, cy = values["K"]
        cameras[str(k) if nested else f"cam_{k}"] = {
            "name": f"cam{k}",
            "size": [752, 480],
            "matrix": [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]],
            "distortions": [*values["D"], 0.0],
            "rotation": cv2.Rodrigues(R_k)[0].reshape(-1).tolist(),
            "translation": (t_k / unit).tolist(),
            **changed,
        }
    other = {"metadata": {"adjusted": False, "error": 0.3}}
    return tomli_w.dumps({"cameras": cameras, **other} if nested else {**cameras, **other})


def loaded(path: Path, text: str, unit: float = 1.0) -> StereoRig:
    path.write_text(text)
    return load_rig(path, MissingFacts(unit=unit))


def assert_is_the_rig(rig: StereoRig, R: Array = R) -> None:
    assert (rig.left.width, rig.left.height) == (752, 480)
    assert rig.baseline == pytest.approx(float(np.linalg.norm(T)), abs=1e-9)
    assert_triangulates(rig, R, T)


def test_a_camera_chain_of_kalibr(tmp_path: Path) -> None:
    rig = loaded(tmp_path / "camchain.yaml", kalibr())
    assert_is_the_rig(rig)
    np.testing.assert_allclose(rig.right.D[:4], RIGHT["D"])
    alone = loaded(tmp_path / "alone.yaml", kalibr(right=False))
    assert alone.one_camera
    np.testing.assert_allclose(alone.left.K[0], [LEFT["K"][0], 0.0, LEFT["K"][2]])


@pytest.mark.parametrize("nested", [False, True])
def test_a_file_of_anipose_or_caliscope_in_its_unit(tmp_path: Path, nested: bool) -> None:
    rig = loaded(tmp_path / "calibration.toml", tables(0.001, nested), 0.001)
    assert_is_the_rig(rig)


def test_a_camera_that_caliscope_ignores_is_left_out(tmp_path: Path) -> None:
    text = tables(1.0, True).replace("[cameras.0]\n", "[cameras.0]\nignore = true\n")
    rig = loaded(tmp_path / "camera_array.toml", text)
    assert rig.one_camera
    np.testing.assert_allclose(rig.left.K[0], [RIGHT["K"][0], 0.0, RIGHT["K"][2]])


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (kalibr(distortion_model="fov"), "stereo.lens_model"),
        (kalibr(camera_model="omni"), "stereo.lens_model"),
        (kalibr(intrinsics="[1.0, 2.0]"), "stereo.matrix_shape"),
        (kalibr().replace("T_cn_cnm1", "T_other"), "stereo.matrix_missing"),
        (kalibr().replace("cam0:", "cam7:"), "stereo.matrix_missing"),
        (kalibr().replace(str(R[0, 0]), "0.5"), "stereo.no_rotation"),
    ],
)
def test_other_chains_of_kalibr_are_refused(tmp_path: Path, text: str, code: str) -> None:
    with raises(FileError, code):
        loaded(tmp_path / "camchain.yaml", text)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (tables(1.0, fisheye=True), "stereo.matrix_shape"),
        (tables(1.0, distortions=[0.0] * 14 + [0.1]), "stereo.lens_model"),
        (tables(1.0, rotation=[0.1]), "stereo.matrix_shape"),
        (tables(1.0, size=["a", "b"]), "stereo.matrix_shape"),
        ("[metadata]\nerror = 0.3\n", "stereo.matrix_missing"),
    ],
)
def test_other_tables_are_refused(tmp_path: Path, text: str, code: str) -> None:
    with raises(FileError, code):
        loaded(tmp_path / "calibration.toml", text)


def test_a_wrong_unit_is_implausible(tmp_path: Path) -> None:
    path = tmp_path / "calibration.toml"
    path.write_text(tables(0.001))
    with pytest.raises(ConfigError):
        load_rig(path)
