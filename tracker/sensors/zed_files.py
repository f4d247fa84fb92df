"""Factory calibration of a ZED camera (``SN<serial>.conf``) as a stereo rig.

The convention, found on real data: K = [fx 0 cx; 0 fy cy], distortion k1 k2 p1 p2 k3,
R = Rodrigues([RX, CV, RZ]) rad, T = [-Baseline, TY, TZ] mm and X_right = R X_left + T. Old files
lack k3, TY and TZ (zero there); new ones write TY and TZ without the resolution's suffix.
"""

from __future__ import annotations

import configparser
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.messages import Array, CameraPose
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig
from tracker.vision.rig import StereoRig

MM = 1e-3


@dataclass(frozen=True)
class Resolution:
    """One of the camera's image sizes and how the file calls it."""

    suffix: str
    width: int
    height: int


RESOLUTIONS = (
    Resolution("2K", 2208, 1242),
    Resolution("FHD", 1920, 1080),
    Resolution("HD", 1280, 720),
    Resolution("VGA", 672, 376),
)


def load_zed(path: Path, height: int = 720, pose: CameraPose | None = None) -> StereoRig:
    """The rig at one of the ZED's image heights; ``pose`` as in `rectified_rig`.

    Raises FileError where the file is no such calibration or ends too early.
    """
    sections = _read(path)
    resolution = next((r for r in RESOLUTIONS if r.height == height), None)
    if resolution is None:
        known = ", ".join(str(r.height) for r in RESOLUTIONS)
        raise FileError(notice("zed.height", height_px=height, known=known))
    left = _intrinsics(sections, "LEFT", resolution, path)
    right = _intrinsics(sections, "RIGHT", resolution, path)
    R, T = _extrinsics(sections, resolution, path)
    return rectified_rig(left, right, R, T, pose)


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


def _intrinsics(
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
