"""Loads a robot hand: an MJCF or URDF model with a fixed palm and moving fingers."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from extensions.robot.anatomy import RobotAnatomy, read_anatomy
from extensions.robot.finger_map import FingerMap, map_from_text
from extensions.robot.fingers import Found, find_fingers, path_to, plain
from extensions.robot.library import MODELS, model_path, need_mujoco
from extensions.robot.model_file import effort, read_model
from extensions.robot.settings import RobotSettings
from tracker.base.errors import ConfigError
from tracker.base.frozen_dict import FrozenDict
from tracker.base.notices import notice
from tracker.messages import Array

MANY_ANGLES = (mujoco.mjtJoint.mjJNT_FREE, mujoco.mjtJoint.mjJNT_BALL)
SIDE_AT_END = re.compile(r"_(right|left)$")
USUAL_TORQUE = 1.0  # N m, for a joint without one in the file


@dataclass(frozen=True, eq=False)
class RobotHand:
    """``mjcf`` is the text of ``model``: the hand alone with a fixed palm.

    limits (n, 2) rad and maximum torque (n,) N m of the n joints, all of which are finger joints.
    """

    name: str
    mjcf: str
    model: mujoco.MjModel
    anatomy: RobotAnatomy
    joint_names: tuple[str, ...]
    limits: Array
    torque: Array


@dataclass(frozen=True, eq=False)
class HandFile:
    """A file's hand alone with a fixed palm, of the file's own side: ``mjcf`` is the text of
    ``model``; ``torque`` N m by joint; ``found`` are rows of the whole file's model ``whole``."""

    mjcf: str
    model: mujoco.MjModel
    anatomy: RobotAnatomy
    torque: dict[str, float]
    whole: mujoco.MjModel
    found: Found

    @property
    def fingers(self) -> FingerMap:
        """The links that were found."""
        return FingerMap(FrozenDict(self.found.names(self.whole)))


def read_hand(path: Path, given: FingerMap) -> HandFile:
    """The hand in a file with the links of ``given``. Raises ConfigError."""
    with usable(path):
        spec = read_model(path)
        whole = spec.compile()
        found = find_fingers(whole, given)
        text = _alone(spec, whole, found)
        model = mujoco.MjModel.from_xml_string(text)
        anatomy = read_anatomy(model, FingerMap(FrozenDict(found.names(whole))))
        return HandFile(text, model, anatomy, _torques(whole), whole, found)
    raise AssertionError


@contextmanager
def usable(path: Path) -> Iterator[None]:
    """Raises ConfigError where MuJoCo refuses the file."""
    try:
        yield
    except (ValueError, mujoco.FatalError, mujoco.UnexpectedError) as error:
        why = str(error).strip().splitlines()[0]
        raise ConfigError(notice("robot.not_usable", file=path.name, why=why)) from error


def load_hand(settings: RobotSettings) -> RobotHand:
    """The hand of the settings, mirrored if necessary to the wearer's side. Raises ConfigError."""
    need_mujoco()
    path = model_path(settings.model)
    file = read_hand(path, map_from_text(settings.fingers))
    text, model, anatomy = file.mjcf, file.model, file.anatomy
    if anatomy.side != settings.side:
        with usable(path):
            text = mirrored(text)
            model = mujoco.MjModel.from_xml_string(text)
            anatomy = read_anatomy(model, file.fingers)
    names = [model.joint(j).name for j in range(model.njnt)]
    if model.nq != model.njnt:
        kind = next(n for j, n in enumerate(names) if model.jnt_type[j] in MANY_ANGLES)
        raise ConfigError(notice("robot.joint_kind", joint=kind))
    limits = np.array(model.jnt_range, float)
    limits[model.jnt_limited == 0] = -np.pi, np.pi
    return RobotHand(
        _name(settings, path),
        text,
        model,
        anatomy,
        tuple(plain(n) for n in names),
        limits,
        np.array([file.torque.get(n, USUAL_TORQUE) for n in names]),
    )


def _name(settings: RobotSettings, path: Path) -> str:
    """Name of the hand in recordings, with its side."""
    short = settings.model if settings.model in MODELS else plain(path.stem)
    plain_name = "".join(c if c.isalnum() else "_" for c in short.lower())
    return f"{SIDE_AT_END.sub('', plain_name)}_{settings.side}"


def _alone(spec: Any, model: mujoco.MjModel, found: Found) -> str:
    """MJCF of the hand without the bodies and joints that carry its palm."""
    root = spec.body(model.body(found.base).name)
    fingers = _below(model, found.palm)
    carrying = {model.joint(j).name for j in range(model.njnt)} - fingers
    _delete_rest(spec, fingers)
    for tendon in [t for t in spec.tendons if _pulls(model, t.name, carrying)]:
        spec.delete(tendon)
    for joint in [j for j in spec.joints if j.name in carrying]:
        spec.delete(joint)
    for body in [b for b in spec.worldbody.bodies if b.name != root.name]:
        spec.delete(body)
    for name in _siblings(model, found):
        spec.delete(spec.body(name))
    for part in [*spec.worldbody.geoms, *spec.worldbody.sites, *spec.lights, *spec.cameras]:
        spec.delete(part)
    for part in spec.bodies:
        part.gravcomp = 1.0
    spec.compile()
    return str(spec.to_xml())


def _delete_rest(spec: Any, fingers: set[str]) -> None:
    """Delete motors, sensors, key frames, and constraints unless a joint mimics another."""
    kept = [e for e in spec.equalities if e.type == mujoco.mjtEq.mjEQ_JOINT and e.name1 in fingers]
    for listed in (spec.actuators, spec.sensors, spec.keys, spec.equalities):
        for part in [p for p in listed if not any(p is k for k in kept)]:
            spec.delete(part)


def _siblings(model: mujoco.MjModel, found: Found) -> list[str]:
    """Bodies of the same root that neither carry the palm nor are carried by it."""
    way = path_to(model, found.palm)
    parents = [int(model.body_parentid[b]) for b in range(model.nbody)]
    return [
        model.body(b).name for b in range(1, model.nbody)
        if parents[b] in way[1:-1] and b not in way
    ]  # fmt: skip


def _below(model: mujoco.MjModel, palm: int) -> set[str]:
    """Joints of the bodies that the palm carries."""
    inside = {palm}
    out = set()
    for body in range(palm + 1, model.nbody):
        if int(model.body_parentid[body]) in inside:
            inside.add(body)
            first = int(model.body_jntadr[body])
            for j in range(first, first + int(model.body_jntnum[body])):
                out.add(model.joint(j).name)
    return out


def _pulls(model: mujoco.MjModel, tendon: str, joints: set[str]) -> bool:
    """Whether a tendon acts on one of the joints."""
    t = model.tendon(tendon).id
    wraps = range(int(model.tendon_adr[t]), int(model.tendon_adr[t] + model.tendon_num[t]))
    return any(
        model.wrap_type[w] == mujoco.mjtWrap.mjWRAP_JOINT
        and model.joint(int(model.wrap_objid[w])).name in joints
        for w in wraps
    )


def _torques(model: mujoco.MjModel) -> dict[str, float]:
    """Maximum torque in N m per joint, for motors or joints with a limit in the file."""

    out: dict[str, float] = {}
    for a in range(model.nu):
        if (
            model.actuator_trntype[a] == mujoco.mjtTrn.mjTRN_JOINT
            and model.actuator_forcelimited[a]
        ):
            joint = model.joint(int(model.actuator_trnid[a, 0])).name
            out[joint] = float(np.abs(model.actuator_forcerange[a]).max())
    for j in range(model.njnt):
        if model.jnt_actfrclimited[j]:
            out.setdefault(model.joint(j).name, effort(model.jnt_actfrcrange[j]))
    return out


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
    """Mirrors an MJCF hand for the other side. Raises ConfigError for what cannot be mirrored.

    The mirror is the plane x = 0 of every frame. A point (x, y, z) maps to (-x, y, z), a rotation
    about n by a to one about M n by -a, so a quaternion (w, x, y, z) to (w, x, -y, -z), and a
    joint's axis n, at the same angle, to -M n. Expects the form that MuJoCo saves: quaternions, no
    Euler angles.
    """
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
