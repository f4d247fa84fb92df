"""Exports a URDF model of the calibrated hand and a table of its joint values.

With the joint values of a row of the table (``NAME.joints.csv``), every keypoint has the position
of the same row of the CSV export. `tracker.session.export.urdf` describes the model.
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
from tracker.base.notices import notice
from tracker.hand.model import HandModel
from tracker.messages import Array, Calibration
from tracker.session.export.axes import AXES
from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries, seconds_text, series_of
from tracker.session.export.urdf import robot_links
from tracker.session.export.urdf_joints import UrdfAxis
from tracker.session.reader import SessionReader

_LOOKS = 200  # instants at which a model with only the angles is compared with the estimates


def export_urdf(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries | None:
    """Write model and table. A joint with several axes becomes a chain with links without mass.

    Without estimates the model is the hand at rest and the table is empty. Raises ConfigError for
    left-handed axes.
    """
    if options.axes is not None and AXES[options.axes].left_handed:
        raise ConfigError(notice("urdf.left_handed", axes=options.axes))
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
    """Error in mm of a model in which only the session's angles are set.

    The model has anatomical axes and constant bone lengths, whereas the estimate has a rotation per
    segment and lengths that the calibration refines.
    """
    hand, glove = m.info.hand, m.info.glove
    known = np.isfinite(m.angles).all(axis=1) & np.isfinite(m.keypoints).all(axis=(1, 2))
    rows = np.flatnonzero(known)
    worst_mm = []
    for k in np.flip(np.flip(rows)[:: max(len(rows) // _LOOKS, 1)]):  # includes the last one
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
    """Scale factors (S, 3) of the session's last calibration; ones without a calibration."""
    scale = np.ones((len(hand.segments), 3))
    for m in reader.messages([Calibration]):
        assert isinstance(m, Calibration)
        for name, factors in zip(m.segments, m.scale, strict=True):
            if name in hand.index and np.isfinite(factors).all():
                scale[hand.index[name]] = factors
    return scale


def _write_trajectory(path: Path, m: EstimateSeries, axes: list[UrdfAxis]) -> None:
    """Write a row of values in m and rad for each row of the CSV export; lost values are empty."""
    with path.open("w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(["t", *(axis.name for axis in axes)])
        for k in range(len(m)):
            values = [float(axis.values[k]) for axis in axes]
            cells = ["" if math.isnan(v) else f"{v:.9g}" for v in values]
            writer.writerow([seconds_text(int(m.stamp_ns[k])), *cells])
