"""C3D: keypoints as points (mm), joint angles as analogue channels (deg)."""

from __future__ import annotations

from pathlib import Path

import ezc3d
import numpy as np

from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader


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
    return m
