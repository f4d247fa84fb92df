"""The hand as a robot model (URDF), which every recording contains.

Anatomical joints have the names of the session's JointState; the others are those of
`urdf_joints`. The parent of the root's six joints is ``world``, the origin of the session.
"""

from __future__ import annotations

from xml.etree import ElementTree as ET

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.hand.model import Segment
from tracker.messages import Array
from tracker.session.description import SessionInfo
from tracker.session.export.series import EstimateSeries, series_of
from tracker.session.export.urdf_joints import LinkAxes, UrdfAxis, hand_axes

WORLD = "world"
_VECTOR = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}
_ZEROS = "0 0 0"
_MAX_VELOCITY = "20"  # rad/s or m/s, an upper bound: URDF requires one
_MAX_EFFORT = "10"  # N m or N


def robot_description(info: SessionInfo) -> str:
    """The hand at the size of its file, as on ROS's topic ``robot_description``.

    Links have the names of the session's frames, joints those of its JointState.
    """
    robot = ET.Element("robot", name=info.hand.name)
    robot_links(robot, series_of(info, []), np.ones((len(info.hand.segments), 3)))
    for element, key in [
        *((link, "name") for link in robot.iter("link")),
        *((end, "link") for joint in robot.iter("joint") for end in joint if end.get("link")),
    ]:
        if element.get(key) != WORLD:
            element.set(key, f"{info.side}_{element.get(key)}")
    ET.indent(robot)
    return ET.tostring(robot, "unicode", xml_declaration=True) + "\n"


def robot_links(robot: ET.Element, m: EstimateSeries, scale: Array) -> list[UrdfAxis]:
    """Adds all links and joints; returns the movable joints."""
    hand = m.info.hand
    origins = np.array(
        [
            np.zeros(3) if a < 0 else s.origin * scale[a]
            for s, a in zip(hand.segments, hand.parent, strict=True)
        ]
    )
    tips = keypoint_tips(m.info, scale)
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


def keypoint_tips(info: SessionInfo, scale: Array) -> Array:
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
        ET.SubElement(visual, "origin", xyz=middle, rpy=_ZEROS)
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
    at: tuple[Array, Array],
) -> None:
    """Adds the joints from a parent to a child: first the position (3,) m with the shifts, then the
    rest rotation (3, 3) with the rotations; the links between them are empty."""
    parent, child = names
    xyz, rest = _numbers(at[0]), _numbers(Rotation.from_matrix(at[1]).as_euler("xyz"))
    steps: list[UrdfAxis | None] = [*axes.shifts, *axes.turns]
    if not axes.turns and (rest != _ZEROS or not steps):
        steps.append(None)  # without an axis: a fixed joint with the remaining position and rest
    for k, axis in enumerate(steps):
        end = child if k == len(steps) - 1 else f"{child}_link_{k + 1}"
        if end != child:
            ET.SubElement(robot, "link", name=end)
        rpy = rest if k == len(axes.shifts) else _ZEROS
        origin = {"xyz": xyz if k == 0 else _ZEROS, "rpy": rpy}
        if axis is None:
            _joint(robot, f"{child}_fixed", "fixed", (parent, end), origin)
        else:
            joint = _joint(robot, axis.name, axis.kind, (parent, end), origin)
            _set_axis(joint, axis)
        parent = end


def _joint(
    robot: ET.Element, name: str, kind: str, links: tuple[str, str], origin: dict[str, str]
) -> ET.Element:
    element = ET.SubElement(robot, "joint", name=name, type=kind)
    ET.SubElement(element, "origin", origin)
    ET.SubElement(element, "parent", link=links[0])
    ET.SubElement(element, "child", link=links[1])
    return element


def _set_axis(joint: ET.Element, axis: UrdfAxis) -> None:
    """Adds a joint's axis, and limits that include the tracked values."""
    ET.SubElement(joint, "axis", xyz=_VECTOR[axis.letter])
    rates = {"effort": _MAX_EFFORT, "velocity": _MAX_VELOCITY}
    if axis.kind == "continuous":
        ET.SubElement(joint, "limit", rates)
        return
    low = np.nanmin(axis.values, initial=axis.limits[0])
    high = np.nanmax(axis.values, initial=axis.limits[1])
    ET.SubElement(joint, "limit", {"lower": f"{low:.9g}", "upper": f"{high:.9g}"}, **rates)


def _numbers(values: Array) -> str:
    return " ".join(f"{v + 0.0:.9g}" for v in values)
