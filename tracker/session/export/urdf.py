"""URDF of the hand as calibrated, and beside it what its joints did.

Joints of anatomy have the names of the session's JointState; the others are those of
`urdf_joints`. The root's six joints hang on ``world``, the origin of the session. With the values
of a row of the trajectory (``NAME.joints.csv``) every keypoint stands where that row of the CSV has
it.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.base.errors import ConfigError, FileError
from tracker.hand.model import HandModel, Segment
from tracker.messages import Array, Calibration
from tracker.session.description import SessionInfo
from tracker.session.export.axes import AXES
from tracker.session.export.load import load_series
from tracker.session.export.options import TRAJECTORY, ExportOptions
from tracker.session.export.series import EstimateSeries, series_of
from tracker.session.export.urdf_joints import (
    LinkAxes,
    UrdfAxis,
    hand_axes,
    write_trajectory,
)
from tracker.session.reader import SessionReader

WORLD = "world"
_VECTOR = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}
_NOUGHT = "0 0 0"
_FASTEST = "20"  # rad/s or m/s, a generous bound: URDF wants one
_STRONGEST = "10"  # N m or N
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
        series = load_series(reader, options)
    except FileError:
        series = None
    m = series_of(reader.info, []) if series is None else series
    robot = ET.Element("robot", name="hand" if "hand" in options.anonymous else hand.name)
    axes = _links(robot, m, scale)
    ET.indent(robot)
    ET.ElementTree(robot).write(path, encoding="utf-8", xml_declaration=True)
    write_trajectory(path.with_suffix(TRAJECTORY), m, axes)
    return None if series is None else replace(m, notes=m.notes | _angles_alone(m, scale))


def robot_description(info: SessionInfo) -> str:
    """The hand at the size of its file, as ROS has it on the topic ``robot_description``.

    Links have the names of the session's frames, joints those of its JointState.
    """
    robot = ET.Element("robot", name=info.hand.name)
    _links(robot, series_of(info, []), np.ones((len(info.hand.segments), 3)))
    for element, key in [
        *((link, "name") for link in robot.iter("link")),
        *((end, "link") for joint in robot.iter("joint") for end in joint if end.get("link")),
    ]:
        if element.get(key) != WORLD:
            element.set(key, f"{info.side}_{element.get(key)}")
    ET.indent(robot)
    return ET.tostring(robot, "unicode", xml_declaration=True) + "\n"


def _links(robot: ET.Element, m: EstimateSeries, scale: Array) -> list[UrdfAxis]:
    """All links and joints; returns the joints that move."""
    hand = m.info.hand
    origins = np.array(
        [
            np.zeros(3) if a < 0 else s.origin * scale[a]
            for s, a in zip(hand.segments, hand.parent, strict=True)
        ]
    )
    tips = _tips(m.info, scale)
    axes = hand_axes(m, origins, tips)
    ET.SubElement(robot, "link", name=WORLD)
    for i, segment in enumerate(hand.segments):
        _link(robot, segment, segment.length * scale[i, 0])
        rest = np.eye(3) if segment.parent is None else segment.R_rest
        names = segment.parent or WORLD, segment.name
        _chain(robot, names, axes.segments[i], (origins[i], rest))
    parents = m.info.glove.keypoint_segments(hand)
    for k, (name, i) in enumerate(zip(m.keypoint_names, parents, strict=True)):
        ET.SubElement(robot, "link", name=f"{name}_keypoint")
        names = hand.segments[i].name, f"{name}_keypoint"
        _chain(robot, names, axes.keypoints[k], (tips[k], np.eye(3)))
    return axes.joints()


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


def _tips(info: SessionInfo, scale: Array) -> Array:
    """(K, 3) m of the keypoints in the B of their segments."""
    n = len(info.hand.segments)
    at_rest = np.tile(np.eye(3), (n, 1, 1)), np.zeros((n, 3))
    return info.glove.keypoint_positions(info.hand, *at_rest, scale)


def _link(robot: ET.Element, segment: Segment, length: float) -> None:
    """A box for the back of the hand, else a cylinder along the bone."""
    link = ET.SubElement(robot, "link", name=segment.name)
    visual = ET.SubElement(link, "visual")
    middle = f"{length / 2:.9g} 0 0"
    geometry = ET.Element("geometry")
    if segment.width:
        ET.SubElement(visual, "origin", xyz=middle, rpy=_NOUGHT)
        size = f"{length:.9g} {segment.width:.9g} {2 * segment.radius:.9g}"
        ET.SubElement(geometry, "box", size=size)
    else:
        ET.SubElement(visual, "origin", xyz=middle, rpy=f"0 {np.pi / 2:.9g} 0")
        ET.SubElement(geometry, "cylinder", radius=f"{segment.radius:.9g}", length=f"{length:.9g}")
    visual.append(geometry)


def _chain(
    robot: ET.Element,
    names: tuple[str, str],
    axes: LinkAxes,
    place: tuple[Array, Array],
) -> None:
    """From a parent to a child: first its place (3,) m with the shifts, then its rest (3, 3) with
    the turns; links between them are bare."""
    parent, child = names
    xyz, rest = _numbers(place[0]), _numbers(Rotation.from_matrix(place[1]).as_euler("xyz"))
    steps: list[UrdfAxis | None] = [*axes.shifts, *axes.turns]
    if not axes.turns and (rest != _NOUGHT or not steps):
        steps.append(None)  # no axis: what is left of place and rest
    for k, axis in enumerate(steps):
        end = child if k == len(steps) - 1 else f"{child}_link_{k + 1}"
        if end != child:
            ET.SubElement(robot, "link", name=end)
        rpy = rest if k == len(axes.shifts) else _NOUGHT
        origin = {"xyz": xyz if k == 0 else _NOUGHT, "rpy": rpy}
        if axis is None:
            _joint(robot, f"{child}_fixed", "fixed", (parent, end), origin)
        else:
            joint = _joint(robot, axis.name, axis.kind, (parent, end), origin)
            _moves(joint, axis)
        parent = end


def _joint(
    robot: ET.Element, name: str, kind: str, links: tuple[str, str], origin: dict[str, str]
) -> ET.Element:
    element = ET.SubElement(robot, "joint", name=name, type=kind)
    ET.SubElement(element, "origin", origin)
    ET.SubElement(element, "parent", link=links[0])
    ET.SubElement(element, "child", link=links[1])
    return element


def _moves(joint: ET.Element, axis: UrdfAxis) -> None:
    """Its axis, and limits that what was tracked keeps."""
    ET.SubElement(joint, "axis", xyz=_VECTOR[axis.letter])
    rates = {"effort": _STRONGEST, "velocity": _FASTEST}
    if axis.kind == "continuous":
        ET.SubElement(joint, "limit", rates)
        return
    low = np.nanmin(axis.values, initial=axis.limits[0])
    high = np.nanmax(axis.values, initial=axis.limits[1])
    ET.SubElement(joint, "limit", {"lower": f"{low:.9g}", "upper": f"{high:.9g}"}, **rates)


def _numbers(values: Array) -> str:
    return " ".join(f"{v + 0.0:.9g}" for v in values)
