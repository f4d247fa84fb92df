"""Mirrors an MJCF hand for the other side.

The mirror is the plane x = 0 of every frame. A point (x, y, z) maps to (-x, y, z), a rotation about
n by a to one about M n by -a, so a quaternion (w, x, y, z) to (w, x, -y, -z), and a joint's axis n,
at the same angle, to -M n. Expects the form that MuJoCo saves: quaternions, no Euler angles.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping

from tracker.base.errors import ConfigError
from tracker.base.notices import notice

Signs = tuple[int, ...]
_POINT: Signs = (-1, 1, 1)
_CHANGES: Mapping[str, Signs] = {
    "pos": _POINT,
    "quat": (1, 1, -1, -1),
    "axis": (1, -1, -1),
    "fromto": (*_POINT, *_POINT),
    "fullinertia": (1, 1, 1, -1, -1, 1),  # xx, yy, zz, xy, xz, yz
    "refpos": _POINT,
    "refquat": (1, 1, -1, -1),
    "dir": _POINT,
}
_Z = "0 0 1"
_SLIDE_AXIS: Signs = _POINT
_UNREAD = ("euler", "axisangle", "xyaxes", "zaxis")


def mirrored(mjcf: str) -> str:
    """The mirrored MJCF. Raises ConfigError for what cannot be mirrored."""
    root = ET.fromstring(mjcf)
    _write_default_axes(root)
    for element in root.iter():
        for name in _UNREAD:
            if name in element.attrib:
                raise ConfigError(notice("robot.not_mirrorable", what=name))
        for name, signs in _CHANGES.items():
            if name in element.attrib:
                slides = name == "axis" and element.get("type") == "slide"
                _sign(element, name, _SLIDE_AXIS if slides else signs)
        if element.tag == "mesh" and ("file" in element.attrib or "vertex" in element.attrib):
            element.set("scale", element.get("scale", "1 1 1"))
            _sign(element, "scale", _POINT)
    return ET.tostring(root, encoding="unicode")


def _write_default_axes(root: ET.Element) -> None:
    """MuJoCo does not write the axis of a joint that turns about z: it is the default."""
    defaults = root.find("default")
    if defaults is None:
        defaults = ET.SubElement(root, "default")
    joint = defaults.find("joint")
    if joint is None:
        joint = ET.SubElement(defaults, "joint")
    if "axis" in joint.attrib:
        return
    if not any("axis" in other.attrib for other in defaults.iter("joint")):
        for slide in (j for body in root.iter("body") for j in body.findall("joint")):
            if slide.get("type") == "slide":
                slide.attrib.setdefault("axis", _Z)
    joint.set("axis", _Z)


def _sign(element: ET.Element, name: str, signs: Signs) -> None:
    values = [float(v) for v in element.attrib[name].split()]
    element.set(name, " ".join(repr(s * v) for v, s in zip(values, signs, strict=True)))
