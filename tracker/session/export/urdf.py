"""URDF of the hand as calibrated; joints have the names of the session's JointState."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.errors import FileError
from tracker.hand.model import HandModel, Segment
from tracker.hand.names import AXES
from tracker.messages import Array, Calibration
from tracker.session.description import SessionInfo
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.reader import SessionReader

_VECTOR = {"abduction": "0 0 1", "flexion": "0 1 0", "twist": "1 0 0"}
_FASTEST = "20"  # rad/s, a generous bound: URDF wants one
_STRONGEST = "10"  # N m
_LOOKS = 200  # instants at which it is compared with the estimates


def export_urdf(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries | None:
    """A joint of several axes becomes a chain (abduction, flexion, twist) with bare links."""
    hand = reader.info.hand
    scale = _calibrated_scale(reader, hand)
    name = "hand" if "hand" in options.anonymous else hand.name
    robot = ET.Element("robot", name=name)
    for i, segment in enumerate(hand.segments):
        _link(robot, segment, segment.length * scale[i, 0])
        if segment.parent is not None:
            origin = segment.origin * scale[hand.index[segment.parent]]
            _joint(robot, hand, segment, origin)
    _keypoints(robot, reader.info, scale)
    ET.indent(robot)
    ET.ElementTree(robot).write(path, encoding="utf-8", xml_declaration=True)
    return _compared(reader, scale)


def _compared(reader: SessionReader, scale: Array) -> EstimateSeries | None:
    """The series that the joints' angles move it through, and how far off that is, mm.

    A joint has the axes of anatomy and a bone one size, where the estimate has a rotation for each
    segment and a size that the calibration goes on finding. None without estimates.
    """
    try:
        series = recorded_series(reader)
    except FileError:
        return None
    hand, glove = reader.info.hand, reader.info.glove
    known = np.isfinite(series.angles).all(axis=1) & np.isfinite(series.keypoints).all(axis=(1, 2))
    rows = np.flatnonzero(known)
    worst_mm = []
    for k in np.flip(np.flip(rows)[:: max(len(rows) // _LOOKS, 1)]):  # the last one is among them
        R_GB = Rotation.from_quat(series.q[k, 0]).as_matrix()
        R, p = hand.forward(series.angles[k], R_GB, series.keypoints[k, 0], scale)
        away = glove.keypoint_positions(hand, R, p, scale) - series.keypoints[k]
        worst_mm.append(round(1e3 * float(np.linalg.norm(away, axis=1).max()), 3))
    notes: dict[str, object] = {}
    if worst_mm:
        median = float(np.median(worst_mm))
        notes["differs_mm"] = {"median": median, "largest": max(worst_mm), "at_end": worst_mm[-1]}
    return replace(series, notes=notes)


def _calibrated_scale(reader: SessionReader, hand: HandModel) -> Array:
    """(S, 3) factors of the session's last calibration; ones where there is none."""
    scale = np.ones((len(hand.segments), 3))
    for m in reader.messages([Calibration]):
        assert isinstance(m, Calibration)
        for name, factors in zip(m.segments, m.scale, strict=True):
            if name in hand.index and np.isfinite(factors).all():
                scale[hand.index[name]] = factors
    return scale


def _keypoints(robot: ET.Element, info: SessionInfo, scale: Array) -> None:
    """A bare link ``<keypoint>_keypoint`` for each, fixed where the other exports have it."""
    hand, glove = info.hand, info.glove
    n = len(hand.segments)
    at_rest = np.tile(np.eye(3), (n, 1, 1)), np.zeros((n, 3))
    segments = glove.keypoint_segments(hand)
    offsets = glove.keypoint_positions(hand, *at_rest, scale)
    for name, i, offset in zip(info.keypoint_names, segments, offsets, strict=True):
        link, parent = f"{name}_keypoint", hand.segments[i].name
        ET.SubElement(robot, "link", name=link)
        _element(robot, f"{name}_at", "fixed", parent, link, _numbers(offset), "0 0 0")


def _link(robot: ET.Element, segment: Segment, length: float) -> None:
    """A box for the back of the hand, else a cylinder along the bone."""
    link = ET.SubElement(robot, "link", name=segment.name)
    visual = ET.SubElement(link, "visual")
    middle = f"{length / 2:.9g} 0 0"
    geometry = ET.Element("geometry")
    if segment.width:
        ET.SubElement(visual, "origin", xyz=middle, rpy="0 0 0")
        size = f"{length:.9g} {segment.width:.9g} {2 * segment.radius:.9g}"
        ET.SubElement(geometry, "box", size=size)
    else:
        ET.SubElement(visual, "origin", xyz=middle, rpy=f"0 {np.pi / 2:.9g} 0")
        ET.SubElement(geometry, "cylinder", radius=f"{segment.radius:.9g}", length=f"{length:.9g}")
    visual.append(geometry)


def _joint(robot: ET.Element, hand: HandModel, segment: Segment, origin: Array) -> None:
    assert segment.parent is not None
    rest = Rotation.from_matrix(segment.R_rest).as_euler("xyz")  # URDF: fixed axes x, y, z
    xyz, rpy = _numbers(origin), _numbers(rest)
    joint = hand.joint_of.get(segment.name)
    axes = [a for a in AXES if joint is not None and a in joint.axes]
    if joint is None or not axes:
        _element(robot, f"{segment.name}_fixed", "fixed", segment.parent, segment.name, xyz, rpy)
        return
    parent = segment.parent
    for axis in axes:
        name = f"{joint.name}_{axis}"
        child = segment.name if axis == axes[-1] else f"{name}_link"
        if child != segment.name:
            ET.SubElement(robot, "link", name=child)
        element = _element(robot, name, "revolute", parent, child, xyz, rpy)
        ET.SubElement(element, "axis", xyz=_VECTOR[axis])
        low, high = joint.limits[axis]
        bounds = {"lower": f"{low:.9g}", "upper": f"{high:.9g}"}
        ET.SubElement(element, "limit", bounds, effort=_STRONGEST, velocity=_FASTEST)
        parent, xyz, rpy = child, "0 0 0", "0 0 0"


def _element(
    robot: ET.Element, name: str, kind: str, parent: str, child: str, xyz: str, rpy: str
) -> ET.Element:
    element = ET.SubElement(robot, "joint", name=name, type=kind)
    ET.SubElement(element, "origin", xyz=xyz, rpy=rpy)
    ET.SubElement(element, "parent", link=parent)
    ET.SubElement(element, "child", link=child)
    return element


def _numbers(values: Array) -> str:
    return " ".join(f"{v:.9g}" for v in values)
