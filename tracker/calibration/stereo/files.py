"""Stereo calibration files: ours are OpenCV's YAML with the image's size, in metres.

`load_rig` reads ours, other OpenCV files, a ZED's factory file, and those of Kalibr, Anipose,
FreeMoCap and Caliscope, and rejects implausible ones.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from tracker.base.errors import ConfigError, FileError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.calibration.stereo.checks import extrinsics_of, require_plausible
from tracker.messages import Array
from tracker.sensors.rig_files import load_opencv_stereo, load_zed, opencv_text
from tracker.sensors.rig_other_files import is_kalibr, load_camera_tables, load_kalibr
from tracker.sensors.stereo_calibration import Intrinsics
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
