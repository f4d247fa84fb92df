"""Stereo calibrations in other programs' files as a stereo rig.

OpenCV (YAML, XML or JSON by `cv2.FileStorage`): either one file contains everything, or
``intrinsics.yml`` has M1, D1, M2, D2 and ``extrinsics.yml`` next to it R and T, as OpenCV's
stereo_calib sample writes them. T is in the unit of the calibration board's squares, which the file
does not contain; the caller gives it. A file that has K and D of one camera and nothing else is of
a single camera, as OpenCV's calibration sample and ROS write it.

Factory calibration of a ZED camera (``SN<serial>.conf``). Its convention, found on real data:
K = [fx 0 cx; 0 fy cy], distortion k1 k2 p1 p2 k3, R = Rodrigues([RX, CV, RZ]) rad,
T = [-Baseline, TY, TZ] mm and X_right = R X_left + T. Old files lack k3, TY and TZ (zero there);
new ones write TY and TZ without the resolution's suffix.
"""

from __future__ import annotations

import configparser
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.messages import Array, CameraPose
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig, rig_of_one
from tracker.vision.lens_models import FISHEYE, padded
from tracker.vision.rig import StereoRig

MM = 1e-3


@dataclass(frozen=True)
class Resolution:
    """One of the camera's image sizes and its name in the file."""

    suffix: str
    width: int
    height: int


RESOLUTIONS = (
    Resolution("2K", 2208, 1242),
    Resolution("FHD", 1920, 1080),
    Resolution("HD", 1280, 720),
    Resolution("VGA", 672, 376),
)


LINE_TIMES = {30.0: 25.6e-6, 60.0: 15.7e-6}
"""s per row at 720 rows, by images per second, as stated by Stereolabs for the ZED 2. The ZED and
the ZED Mini have the same sensor."""
GLOBAL_SHUTTER = ("LEFT_CAM_FHD1200", "LEFT_CAM_SVGA")
"""Sections that only files of models with a global shutter (ZED X) contain."""


def zed_line_time(height: int, fps: float) -> float:
    """Line time (s per row) of a ZED in a mode; 0 if unknown."""
    nearest = min(LINE_TIMES, key=lambda rate: abs(rate - fps))
    return LINE_TIMES[nearest] if height == 720 and abs(nearest - fps) <= 1.0 else 0.0


def load_zed(
    path: Path, height: int = 720, pose: CameraPose | None = None, fps: float = 60.0
) -> StereoRig:
    """The rig at one of the ZED's image heights; ``pose`` as in `rectified_rig`. The line time is
    that of the mode with ``fps`` images per second.

    Raises FileError if the file is not such a calibration or is truncated.
    """
    sections = _read(path)
    resolution = next((r for r in RESOLUTIONS if r.height == height), None)
    if resolution is None:
        known = ", ".join(str(r.height) for r in RESOLUTIONS)
        raise FileError(notice("zed.height", height_px=height, known=known))
    left = _zed_intrinsics(sections, "LEFT", resolution, path)
    right = _zed_intrinsics(sections, "RIGHT", resolution, path)
    R, T = _extrinsics(sections, resolution, path)
    rig = rectified_rig(left, right, R, T, pose)
    if any(sections.has_section(name) for name in GLOBAL_SHUTTER):
        return rig
    return replace(rig, line_time=zed_line_time(height, fps))


def find_zed_file(serial: int, folders: list[Path]) -> Path | None:
    """The calibration of a camera by its serial number, in the first folder that has it."""
    candidates = (folder / f"SN{serial}.conf" for folder in folders)
    return next((path for path in candidates if path.is_file()), None)


def _read(path: Path) -> configparser.ConfigParser:
    parser = configparser.ConfigParser(interpolation=None)
    try:
        parser.read_string(read_text(path))
    except configparser.Error as error:
        first = str(error).splitlines()[0]
        raise FileError(notice("zed.not_calibration", path=path, why=first)) from error
    return parser


def _zed_intrinsics(
    sections: configparser.ConfigParser, side: str, resolution: Resolution, path: Path
) -> Intrinsics:
    section = f"{side}_CAM_{resolution.suffix}"
    fx, fy, cx, cy = (_number(sections, section, key, path) for key in ("fx", "fy", "cx", "cy"))
    D = [_number(sections, section, key, path) for key in ("k1", "k2")]
    D += [_number(sections, section, key, path, 0.0) for key in ("p1", "p2", "k3")]
    K = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
    return Intrinsics(resolution.width, resolution.height, K, np.array(D))


def _extrinsics(
    sections: configparser.ConfigParser, resolution: Resolution, path: Path
) -> tuple[Array, Array]:
    """R (3, 3), T (3,) m with X_right = R X_left + T."""

    def value(key: str, default: float | None = None) -> float:
        suffixed = f"{key}_{resolution.suffix}"
        name = suffixed if sections.has_option("STEREO", suffixed) else key
        return _number(sections, "STEREO", name, path, default)

    turn = np.array([value("RX"), value("CV"), value("RZ")])
    T = np.array([-value("Baseline"), value("TY", 0.0), value("TZ", 0.0)]) * MM
    return cv2.Rodrigues(turn)[0], T


def _number(
    sections: configparser.ConfigParser,
    section: str,
    key: str,
    path: Path,
    default: float | None = None,
) -> float:
    text = sections.get(section, key, fallback=None)
    if text is None:
        if default is not None and sections.has_section(section):
            return default
        raise FileError(notice("zed.missing_key", path=path, key=key, section=section))
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not np.isfinite(value):
        raise FileError(notice("zed.not_number", path=path, key=key, section=section, text=text))
    return value


NAMES = {
    "K of the left camera": ("M1", "K1", "cameraMatrix1", "camera_matrix_left", "camera_matrix"),
    "D of the left camera": (
        "D1",
        "distCoeffs1",
        "dist_coeffs_left",
        "distortion_coefficients",
    ),
    "K of the right camera": ("M2", "K2", "cameraMatrix2", "camera_matrix_right"),
    "D of the right camera": ("D2", "distCoeffs2", "dist_coeffs_right"),
    "the rotation R": ("R",),
    "the translation T": ("T",),
}
OF_ONE = frozenset(("K of the left camera", "D of the left camera"))
MOST_NUMBERS = 100  # of a matrix
FISHEYE_MODELS = ("equidistant", "fisheye")  # as ROS calls them


def load_opencv_stereo(
    paths: list[Path],
    width: int,
    height: int,
    unit: float = 1.0,
    pose: CameraPose | None = None,
    right_size: tuple[int, int] | None = None,
) -> StereoRig:
    """The rig of one or two files; ``unit`` is the length of T's unit, m.

    ``right_size`` (px) is where the right images have another size.

    Raises FileError where something is missing or the lens model is unknown.
    """
    found: dict[str, Array] = {}
    for path in paths:
        found |= _matrices(path)
    where = " and ".join(str(p) for p in paths)
    fisheye = any(_is_fisheye(path) for path in paths)
    if found.keys() == OF_ONE:
        return rig_of_one(_intrinsics(found, "left", (width, height), where, fisheye), pose)
    for what in NAMES:
        if what not in found:
            raise FileError(
                notice("stereo.matrix_missing", path=where, key=what, names=NAMES[what])
            )
    sizes = {"left": (width, height), "right": right_size or (width, height)}
    left, right = (_intrinsics(found, side, size, where, fisheye) for side, size in sizes.items())
    R = _shaped(found["the rotation R"], (3, 3), "the rotation R", where)
    T = _shaped(found["the translation T"].reshape(-1), (3,), "the translation T", where)
    if not np.allclose(R @ R.T, np.eye(3), atol=1e-3):
        raise FileError(notice("stereo.no_rotation", path=where))
    return rectified_rig(left, right, R, T * unit, pose)


def _intrinsics(
    found: dict[str, Array], side: str, size: tuple[int, int], where: str, fisheye: bool
) -> Intrinsics:
    K = _shaped(found[f"K of the {side} camera"], (3, 3), f"K of the {side} camera", where)
    D = _distortion(found[f"D of the {side} camera"], side, where, fisheye)
    return Intrinsics(*size, K, D, fisheye)


def _is_fisheye(path: Path) -> bool:
    """Whether a file declares its lenses to be fisheyes: ours by a number, ROS by the model."""
    storage = cv2.FileStorage(opencv_text(path), cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY)
    try:
        ours, model = storage.getNode("fisheye"), storage.getNode("distortion_model")
        stated = model.string() if model.isString() else ""
        return stated in FISHEYE_MODELS or (ours.isInt() and ours.real() != 0)
    finally:
        storage.release()


def opencv_text(path: Path) -> str:
    """A file's text with the first line that OpenCV requires and ROS omits. Raises FileError."""
    text = read_text(path)
    is_ros = path.suffix.lower() in (".yml", ".yaml") and not text.lstrip().startswith("%")
    return f"%YAML:1.0\n---\n{text}" if is_ros else text


def _matrices(path: Path) -> dict[str, Array]:
    try:
        storage = cv2.FileStorage(
            opencv_text(path), cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY
        )
    except (cv2.error, SystemError) as error:
        raise FileError(notice("stereo.not_opencv", path=path)) from error
    try:
        return {
            what: m for what, names in NAMES.items() if (m := _first(storage, names)) is not None
        }
    except cv2.error as error:
        raise FileError(notice("stereo.not_matrix", path=path)) from error
    finally:
        storage.release()


def _first(storage: cv2.FileStorage, names: tuple[str, ...]) -> Array | None:
    for name in names:
        node = storage.getNode(name)
        if not node.empty():
            return _matrix(node)
    return None


def _matrix(node: cv2.FileNode) -> Array | None:
    """Reads the numbers one by one: `FileNode.mat` relies on rows and columns, and writes past its
    memory if the file has more or fewer numbers."""
    if not node.isMap():
        return None
    shape, data = _shape(node), node.getNode("data")
    if shape is None or not data.isSeq():
        return None
    numbers = [data.at(k) for k in range(min(data.size(), MOST_NUMBERS))]
    if min(shape) < 1 or shape[0] * shape[1] != len(numbers):
        return None
    if not all(n.isReal() or n.isInt() for n in numbers):
        return None
    return np.array([n.real() for n in numbers]).reshape(shape)


def _shape(node: cv2.FileNode) -> tuple[int, int] | None:
    """Rows and columns; OpenCV 5 writes ``sizes``, with a single value for a vector."""
    sizes = node.getNode("sizes")
    if sizes.isSeq() and sizes.size() in (1, 2):
        counts = [sizes.at(k) for k in range(sizes.size())]
    else:
        counts = [node.getNode(name) for name in ("rows", "cols")]
    if not all(count.isInt() for count in counts):
        return None
    rows, *columns = (int(count.real()) for count in counts)
    return rows, columns[0] if columns else 1


def _shaped(matrix: Array, shape: tuple[int, ...], what: str, where: str) -> Array:
    if matrix.shape != shape or not np.all(np.isfinite(matrix)):
        raise FileError(
            notice("stereo.matrix_shape", path=where, key=what, shape="x".join(map(str, shape)))
        )
    return matrix


def _distortion(matrix: Array, side: str, where: str, fisheye: bool) -> Array:
    given = matrix.reshape(-1)
    D = padded(given)
    if fisheye:
        D = given if len(given) == FISHEYE else None
    if D is None or not np.all(np.isfinite(D)):
        raise FileError(notice("stereo.coefficients", path=where, side=side, count=len(given)))
    return D
