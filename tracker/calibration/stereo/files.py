"""Stereo calibration files: ours are OpenCV's YAML with the image's size, in metres.

`load_rig` reads ours, other OpenCV files, a ZED's factory file, and those of Kalibr, Anipose,
FreeMoCap and Caliscope, and rejects implausible ones.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from tracker.base.errors import ConfigError, FileError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice
from tracker.base.toml_reader import parse_toml, read_text
from tracker.calibration.stereo.checks import extrinsics_of, require_plausible
from tracker.messages import Array, CameraPose
from tracker.sensors.rig_files import load_opencv_stereo, load_zed, opencv_text
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig, rig_of_one
from tracker.vision.lens_models import FISHEYE, padded
from tracker.vision.rig import StereoRig

ZED_SUFFIX = ".conf"
TABLES_SUFFIX = ".toml"
SUFFIXES = (ZED_SUFFIX, ".yml", ".yaml", ".xml", ".json")


@dataclass(frozen=True)
class MissingFacts:
    """Information missing in other programs' files: the images' size and the unit of T in m."""

    width: int = 1280
    height: int = 720
    unit: float = 1.0
    fps: float = 60.0


def save_calibration(
    path: Path,
    left: Intrinsics,
    right: Intrinsics | None = None,
    R: Array | None = None,
    T: Array | None = None,
    note: str = "",
    line_time: float = 0.0,
) -> None:
    """Writes `calibration_text`, replacing the file atomically.

    Raises FileError if the file cannot be written.
    """
    write_with_folder(path, calibration_text(left, right, R, T, note, line_time))


def calibration_text(
    left: Intrinsics,
    right: Intrinsics | None = None,
    R: Array | None = None,
    T: Array | None = None,
    note: str = "",
    line_time: float = 0.0,
) -> str:
    """X_right = R X_left + T (m), or a single camera, as YAML that OpenCV can read."""
    storage = cv2.FileStorage(".yml", cv2.FILE_STORAGE_WRITE | cv2.FILE_STORAGE_MEMORY)
    storage.write("image_width", left.width)
    storage.write("image_height", left.height)
    storage.write("note", note)
    if line_time:
        storage.write("line_time", line_time)
    if left.fisheye:
        storage.write("fisheye", 1)
    matrices = {"M1": left.K, "D1": left.D}
    if right is not None and R is not None and T is not None:
        matrices |= {"M2": right.K, "D2": right.D, "R": R, "T": T}
        if (right.width, right.height) != (left.width, left.height):
            storage.write("image_width_right", right.width)
            storage.write("image_height_right", right.height)
    for name, matrix in matrices.items():
        rows = matrix if matrix.ndim == 2 else matrix.reshape(-1, 1)
        storage.write(name, np.ascontiguousarray(rows, float))
    return storage.releaseAndGetString()


def rig_text(rig: StereoRig, note: str = "", line_time: float | None = None) -> str:
    """`calibration_text` of a rig, with its own line time (s) or another one."""
    cameras = extrinsics_of(rig)
    line_time = rig.line_time if line_time is None else line_time
    return calibration_text(cameras.left, cameras.right, cameras.R, cameras.T, note, line_time)


def load_rig(path: Path, form: MissingFacts | None = None) -> StereoRig:
    """The rig of a calibration file, checked.

    Raises FileError if it cannot be read and ConfigError if it is implausible.
    """
    form = form or MissingFacts()
    suffix = path.suffix.lower()
    if suffix == ZED_SUFFIX:
        rig = load_zed(path, form.height, fps=form.fps)
    elif suffix == TABLES_SUFFIX:
        rig = _refused_by_path(path, lambda: load_camera_tables(path, form.unit))
    elif suffix in (".yml", ".yaml") and is_kalibr(read_text(path)):
        rig = _refused_by_path(path, lambda: load_kalibr(path))
    elif suffix in SUFFIXES:
        rig = _load_opencv(path, form)
    else:
        raise FileError(notice("stereo.unknown_file", path=path))
    require_plausible(rig, str(path))
    return rig


def _load_opencv(path: Path, form: MissingFacts) -> StereoRig:
    size, right_size = _size(path), _size(path, "_right")
    width, height = size or (form.width, form.height)
    beside = path.with_name("extrinsics" + path.suffix)
    paths = [path, beside] if path.stem == "intrinsics" and beside.is_file() else [path]
    # our own files are in metres, whatever ``form`` is for others
    unit = 1.0 if size else form.unit

    def load() -> StereoRig:
        rig = load_opencv_stereo(paths, width, height, unit, right_size=right_size)
        return replace(rig, line_time=_number(path, "line_time"))

    return _refused_by_path(path, load)


def _refused_by_path(path: Path, load: Callable[[], StereoRig]) -> StereoRig:
    """What ``load`` returns; a ConfigError names the file."""
    try:
        return load()
    except ConfigError as error:
        raise ConfigError(notice("stereo.file_refused", path=path, why=error)) from error


def _number(path: Path, name: str) -> float:
    """A number that the file contains, 0 where it does not."""
    flags = cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY
    storage = cv2.FileStorage(opencv_text(path), flags)
    try:
        node = storage.getNode(name)
        return float(node.real()) if node.isReal() or node.isInt() else 0.0
    finally:
        storage.release()


def _size(path: Path, side: str = "") -> tuple[int, int] | None:
    """The size of the images in the file, or of those of one side; None if missing."""
    try:
        flags = cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY
        storage = cv2.FileStorage(opencv_text(path), flags)
    except (cv2.error, SystemError) as error:
        raise FileError(notice("stereo.not_opencv", path=path)) from error
    try:
        names = (f"image_width{side}", f"image_height{side}")
        width, height = (storage.getNode(n) for n in names)
        if width.empty() or height.empty():
            return None
        return int(width.real()), int(height.real())
    finally:
        storage.release()


# ---- calibrations of Kalibr, Anipose, FreeMoCap and Caliscope as a stereo rig
#
# Kalibr's ``camchain.yaml``: cameras ``cam0`` and ``cam1`` with ``intrinsics`` fx fy cx cy,
# ``distortion_coeffs`` (radtan: k1 k2 p1 p2) and ``resolution``; ``T_cn_cnm1`` is the pose of
# cam0 in cam1, X_1 = T X_0, in m.
#
# Anipose's ``calibration.toml``, which FreeMoCap writes too, and Caliscope's
# ``camera_array.toml`` or ``config.toml``: a table for each camera with ``size``, ``matrix``,
# ``distortions`` and the pose of the world in the camera as ``rotation`` (Rodrigues vector) and
# ``translation``, X_c = R X + t. The unit of translations is that of the board that was entered;
# the caller gives it. The first two cameras with a pose, in the order of the file, are the left
# and the right one.

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
