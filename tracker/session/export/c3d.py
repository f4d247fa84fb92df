"""C3D: keypoints as points (mm), joint angles as analogue channels (deg)."""

from __future__ import annotations

import struct
from pathlib import Path

import ezc3d
import numpy as np

from tracker.files import DiskError
from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader

_BLOCK = 512  # bytes; a C3D file counts its parts in these
_DATA_START = 16  # byte of the header with the number of the first block of data, from 1


def export_c3d(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """A lost point is invalid in the file (negative residual, NaN); it is never at the origin."""
    m = load_series(reader, options, even=True)
    unit = options.units or "mm"
    points = np.ones((4, len(m.keypoint_names), len(m)))
    points[:3] = m.keypoints.transpose(2, 1, 0) * UNITS[unit]
    lost = ~np.isfinite(points[:3]).all(axis=0)
    file = ezc3d.c3d()
    file["parameters"]["POINT"]["RATE"]["value"] = [m.rate]
    file["parameters"]["POINT"]["LABELS"]["value"] = list(m.keypoint_names)
    file["parameters"]["POINT"]["UNITS"]["value"] = [unit]
    file["parameters"]["ANALOG"]["RATE"]["value"] = [m.rate]
    file["parameters"]["ANALOG"]["LABELS"]["value"] = list(m.joint_names)
    file["parameters"]["ANALOG"]["UNITS"]["value"] = ["deg"] * len(m.joint_names)
    file["data"]["points"] = points
    file["data"]["meta_points"]["residuals"] = np.where(lost, -1.0, 0.0)[None]
    file["data"]["analogs"] = np.rad2deg(m.angles).T[None]
    file.write(str(path))
    _check(path, file)
    return m


def _check(path: Path, written: ezc3d.c3d) -> None:
    """ezc3d tells of no write that failed, and reading a file cut short may end the program.

    Raises DiskError if the file is not as long as it says or not what was written.
    """
    points, analogs = written["data"]["points"], written["data"]["analogs"]
    with path.open("rb") as file:
        head = file.read(_BLOCK)
    if len(head) == _BLOCK:
        (first,) = struct.unpack_from("<H", head, _DATA_START)
        size = (first - 1) * _BLOCK + 4 * (4 * points[0].size + analogs.size)
        if path.stat().st_size >= size and np.array_equal(
            ezc3d.c3d(str(path))["data"]["points"][:3],
            points[:3].astype(np.float32),
            equal_nan=True,
        ):
            return
    raise DiskError(f"{path.name} could not be written as a whole: the disk may be full.")
