"""URDF of the hand as calibrated, and a table of the values of its joints.

With the values of a row of the table (``NAME.joints.csv``) every keypoint is where that row of the
CSV has it. See `tracker.session.export.urdf` for the model.
"""

from __future__ import annotations

import csv
import math
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
from scipy.spatial.transform import Rotation

from extensions.interchange.extension import TRAJECTORY
from tracker.base.errors import ConfigError, FileError
from tracker.hand.model import HandModel
from tracker.messages import Array, Calibration
from tracker.session.export.axes import AXES
from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries, seconds_text, series_of
from tracker.session.export.urdf import robot_links
from tracker.session.export.urdf_joints import UrdfAxis
from tracker.session.reader import SessionReader

_LOOKS = 200  # instants at which the angles alone are compared with the estimates


def export_urdf(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries | None:
    """A joint of several axes becomes a chain with bare links. ConfigError for left-handed axes.

    Without estimates it is the hand at rest, and a trajectory without rows.
    """
    if options.axes is not None and AXES[options.axes].left_handed:
        raise ConfigError(f"A URDF has right-handed axes; {options.axes} has left-handed ones.")
    hand = reader.info.hand
    scale = _calibrated_scale(reader, hand)
    try:
        series = load_series(reader, options, segments=True)
    except FileError:
        series = None
    m = series_of(reader.info, []) if series is None else series
    robot = ET.Element("robot", name="hand" if "hand" in options.anonymous else hand.name)
    axes = robot_links(robot, m, scale)
    ET.indent(robot)
    ET.ElementTree(robot).write(path, encoding="utf-8", xml_declaration=True)
    _write_trajectory(path.with_suffix(TRAJECTORY), m, axes)
    return None if series is None else replace(m, notes=m.notes | _angles_alone(m, scale))


def _angles_alone(m: EstimateSeries, scale: Array) -> dict[str, object]:
    """How far off, mm, it is for one who sets the angles of the session and nothing else.

    A joint has the axes of anatomy and a bone one size, where the estimate has a rotation for each
    segment and a size that the calibration goes on finding.
    """
    hand, glove = m.info.hand, m.info.glove
    known = np.isfinite(m.angles).all(axis=1) & np.isfinite(m.keypoints).all(axis=(1, 2))
    rows = np.flatnonzero(known)
    worst_mm = []
    for k in np.flip(np.flip(rows)[:: max(len(rows) // _LOOKS, 1)]):  # the last one is among them
        R_GB = Rotation.from_quat(m.q[k, 0]).as_matrix()
        R, p = hand.forward(m.angles[k], R_GB, m.keypoints[k, 0], scale)
        away = glove.keypoint_positions(hand, R, p, scale) - m.keypoints[k]
        worst_mm.append(round(1e3 * float(np.linalg.norm(away, axis=1).max()), 3))
    if not worst_mm:
        return {}
    median = float(np.median(worst_mm))
    differs = {"median": median, "largest": max(worst_mm), "at_end": worst_mm[-1]}
    return {"angles_alone_differ_mm": differs}


def _calibrated_scale(reader: SessionReader, hand: HandModel) -> Array:
    """(S, 3) factors of the session's last calibration; ones where there is none."""
    scale = np.ones((len(hand.segments), 3))
    for m in reader.messages([Calibration]):
        assert isinstance(m, Calibration)
        for name, factors in zip(m.segments, m.scale, strict=True):
            if name in hand.index and np.isfinite(factors).all():
                scale[hand.index[name]] = factors
    return scale


def _write_trajectory(path: Path, m: EstimateSeries, axes: list[UrdfAxis]) -> None:
    """A row of values, m and rad, for each row of the CSV; empty where lost."""
    with path.open("w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(["t", *(axis.name for axis in axes)])
        for k in range(len(m)):
            values = [float(axis.values[k]) for axis in axes]
            cells = ["" if math.isnan(v) else f"{v:.9g}" for v in values]
            writer.writerow([seconds_text(int(m.stamp_ns[k])), *cells])
