"""Calibrations of Kalibr, Anipose, FreeMoCap and Caliscope as a stereo rig.

Kalibr's ``camchain.yaml``: cameras ``cam0`` and ``cam1`` with ``intrinsics`` fx fy cx cy,
``distortion_coeffs`` (radtan: k1 k2 p1 p2) and ``resolution``; ``T_cn_cnm1`` is the pose of cam0 in
cam1, X_1 = T X_0, in m.

Anipose's ``calibration.toml``, which FreeMoCap writes too, and Caliscope's ``camera_array.toml`` or
``config.toml``: a table for each camera with ``size``, ``matrix``, ``distortions`` and the pose of
the world in the camera as ``rotation`` (Rodrigues vector) and ``translation``, X_c = R X + t. The
unit of translations is that of the board that was entered; the caller gives it. The first two
cameras with a pose, in the order of the file, are the left and the right one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import parse_toml, read_text
from tracker.messages import Array, CameraPose
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig, rig_of_one
from tracker.vision.lens_models import FISHEYE, padded
from tracker.vision.rig import StereoRig

MOST_TEXT = 100_000  # characters of a Kalibr file; a real one has 2000
_CAMERA = re.compile(r"^(cam\d+):\s*$")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def is_kalibr(text: str) -> bool:
    """Whether a YAML text has Kalibr's cameras."""
    lines = text.splitlines()
    return any(_CAMERA.match(line) for line in lines) and "distortion_model" in text


def load_kalibr(path: Path, pose: CameraPose | None = None) -> StereoRig:
    """The rig of a camera chain of two, or of one camera; ``pose`` as in `rectified_rig`.

    Raises FileError where something is missing, or the lenses are not *pinhole* with *radtan*.
    """
    cameras = _kalibr_cameras(read_text(path))
    if "cam0" not in cameras:
        raise _missing(path, "cam0")
    left = _kalibr_intrinsics(path, "cam0", cameras["cam0"])
    if "cam1" not in cameras:
        return rig_of_one(left, pose)
    right = _kalibr_intrinsics(path, "cam1", cameras["cam1"])
    T = _numbers(path, "cam1", "T_cn_cnm1", cameras["cam1"].get("T_cn_cnm1"), 16).reshape(4, 4)
    return rectified_rig(left, right, _rotation(path, T[:3, :3]), T[:3, 3], pose)


def load_camera_tables(path: Path, unit: float = 1.0, pose: CameraPose | None = None) -> StereoRig:
    """The rig of the first two cameras with a pose, or of one camera, of Anipose, FreeMoCap or
    Caliscope; ``unit`` is the length of the translations' unit, m.

    Raises FileError where something is missing or is not a plumb-bob calibration.
    """
    found = dict(_camera_tables(parse_toml(read_text(path), str(path))))
    posed = {name: camera for name, camera in found.items() if "rotation" in camera}
    chosen = list((posed if len(posed) > 1 else found).items())[:2]
    if not chosen:
        raise _missing(path, "matrix")
    left, *others = [_table_intrinsics(path, name, camera) for name, camera in chosen]
    if not others:
        return rig_of_one(left, pose)
    (R0, t0), (R1, t1) = (_table_pose(path, name, camera) for name, camera in chosen)
    R = R1 @ R0.T
    return rectified_rig(left, others[0], R, (t1 - R @ t0) * unit, pose)


# --- Kalibr


def _kalibr_cameras(text: str) -> dict[str, dict[str, str]]:
    """The text of each value, by camera and key; lists span several lines."""
    cameras: dict[str, dict[str, str]] = {}
    camera: dict[str, str] | None = None
    key = ""
    for line in text[:MOST_TEXT].splitlines():
        start = _CAMERA.match(line)
        if start is not None:
            camera, key = cameras.setdefault(start[1], {}), ""
        elif camera is not None:
            name, colon, value = line.strip().partition(":")
            if colon and name.isidentifier():
                key = name
                camera[key] = value.strip()
            elif key:
                camera[key] += " " + line.strip().removeprefix("- ")
    return cameras


def _kalibr_intrinsics(path: Path, name: str, camera: Mapping[str, str]) -> Intrinsics:
    known = {"camera_model": ("pinhole",), "distortion_model": ("radtan", "equidistant")}
    for key, models in known.items():
        model = camera.get(key, models[0])
        if model not in models:
            raise FileError(notice("stereo.lens_model", path=path, camera=name, model=model))
    fisheye = camera.get("distortion_model") == "equidistant"
    fx, fy, cx, cy = _numbers(path, name, "intrinsics", camera.get("intrinsics"), 4)
    D = _numbers(path, name, "distortion_coeffs", camera.get("distortion_coeffs"), 4)
    width, height = _numbers(path, name, "resolution", camera.get("resolution"), 2)
    K = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
    return Intrinsics(int(width), int(height), K, D if fisheye else np.append(D, 0.0), fisheye)


# --- Anipose, FreeMoCap, Caliscope


def _camera_tables(table: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Tables that have a matrix, also one level deeper (``[cameras.1]``), but for ignored ones."""
    for name, value in table.items():
        if not isinstance(value, Mapping):
            continue
        if "matrix" in value:
            if not value.get("ignore"):
                yield name, value
        else:
            inner = ((k, v) for k, v in value.items() if isinstance(v, Mapping) and "matrix" in v)
            yield from ((f"{name}.{k}", v) for k, v in inner if not v.get("ignore"))


def _table_intrinsics(path: Path, name: str, camera: Mapping[str, Any]) -> Intrinsics:
    width, height = _numbers(path, name, "size", camera.get("size"), 2)
    K = _numbers(path, name, "matrix", camera.get("matrix"), 9).reshape(3, 3)
    fisheye = bool(camera.get("fisheye"))
    count = FISHEYE if fisheye else None
    given = _numbers(path, name, "distortions", camera.get("distortions"), count)
    D = given if fisheye else padded(given)
    if D is None:
        model = f"one with {len(given)} coefficients"
        raise FileError(notice("stereo.lens_model", path=path, camera=name, model=model))
    return Intrinsics(int(width), int(height), K, D, fisheye)


def _table_pose(path: Path, name: str, camera: Mapping[str, Any]) -> tuple[Array, Array]:
    """R (3, 3) and t (3,), X_c = R X + t."""
    turn = _numbers(path, name, "rotation", camera.get("rotation"))
    R = _rotation(path, turn.reshape(3, 3)) if len(turn) == 9 else None
    if R is None:
        R = cv2.Rodrigues(_numbers(path, name, "rotation", camera.get("rotation"), 3))[0]
    return R, _numbers(path, name, "translation", camera.get("translation"), 3)


# --- numbers


def _numbers(path: Path, camera: str, key: str, value: object, count: int | None = None) -> Array:
    """The numbers of a list, nested or as text. Raises FileError."""
    if value is None:
        raise _missing(path, f"{camera}.{key}")
    if isinstance(value, str):
        found = np.array([float(n) for n in _NUMBER.findall(value)])
    else:
        try:
            found = np.asarray(value, float).reshape(-1)
        except (TypeError, ValueError) as error:
            raise _bad(path, f"{camera}.{key}", count) from error
    if (count is not None and len(found) != count) or not np.isfinite(found).all():
        raise _bad(path, f"{camera}.{key}", count)
    return found


def _rotation(path: Path, R: Array) -> Array:
    if not np.allclose(R @ R.T, np.eye(3), atol=1e-3) or np.linalg.det(R) < 0:
        raise FileError(notice("stereo.no_rotation", path=path))
    return R


def _missing(path: Path, key: str) -> FileError:
    return FileError(notice("stereo.matrix_missing", path=path, key=key, names=(key,)))


def _bad(path: Path, key: str, count: int | None) -> FileError:
    return FileError(notice("stereo.matrix_shape", path=path, key=key, shape=str(count or "")))
