"""Writes a robot hand as URDF for ROS: links and joints without meshes."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from extensions.robot.anatomy import RobotFinger
from extensions.robot.fingers import plain
from extensions.robot.hand import RobotHand
from tracker.messages import Array

ROOT = "palm_frame"
SPEED = 10.0  # rad/s: URDF requires a limit


def robot_urdf(hand: RobotHand, tips: bool = False) -> str:
    """URDF text. The root link is the palm's frame P; successive joints of a body get links, and
    with ``tips`` each fingertip a link called FINGER_tip_end."""
    model, anatomy = hand.model, hand.anatomy
    robot = ET.Element("robot", name=hand.name)
    ET.SubElement(robot, "link", name=ROOT)
    R, p = anatomy.R_WP.T, -anatomy.R_WP.T @ anatomy.p_WP
    for body in range(1, model.nbody):
        if not _belongs(model, body, anatomy.base):
            continue
        parent = int(model.body_parentid[body])
        at, turned = np.array(model.body_pos[body]), _matrix(model.body_quat[body])
        if body == anatomy.base:
            start, at, turned = ROOT, p + R @ at, R @ turned
        else:
            start = plain(model.body(parent).name)
        _body(robot, hand, body, start, (at, turned))
    for finger in anatomy.fingers if tips else ():
        name = tip_link(finger)
        fixed = _joint(robot, "fixed", f"{name}_fixed", plain(model.body(finger.body).name), name)
        _origin(fixed, finger.tip, np.eye(3))
        ET.SubElement(robot, "link", name=name)
    ET.indent(robot)
    return ET.tostring(robot, encoding="unicode")


def tip_link(finger: RobotFinger) -> str:
    """Name of a fingertip's link."""
    return f"{finger.name}_tip_end"


def joint_link(model: mujoco.MjModel, joint: int) -> str:
    """Name of the link that a joint turns and whose origin is on its axis."""
    body = int(model.jnt_bodyid[joint])
    return f"{plain(model.body(body).name)}_{joint - int(model.body_jntadr[body])}"


def _belongs(model: mujoco.MjModel, body: int, base: int) -> bool:
    while body > base:
        body = int(model.body_parentid[body])
    return body == base


def _matrix(quat: Array) -> Array:
    """Rotation (3, 3) of MuJoCo's quaternion wxyz."""
    return np.asarray(Rotation.from_quat(np.roll(quat, -1)).as_matrix())


def _body(
    robot: ET.Element, hand: RobotHand, body: int, parent: str, pose: tuple[Array, Array]
) -> None:
    """Add the link of a body and its joints. A joint is at its anchor, so the link's frame is
    shifted to the anchor and back."""
    model, name = hand.model, plain(hand.model.body(body).name)
    first, number = int(model.body_jntadr[body]), int(model.body_jntnum[body])
    at, turned = pose
    for k, j in enumerate(range(first, first + number)):
        anchor = np.array(model.jnt_pos[j])
        link = f"{name}_{k}"
        joint = _joint(robot, "revolute", hand.joint_names[j], parent, link)
        _origin(joint, at + turned @ anchor, turned)
        ET.SubElement(joint, "axis", xyz=_words(model.jnt_axis[j]))
        low, high = hand.limits[j]
        ET.SubElement(
            joint, "limit", lower=f"{low:.6g}", upper=f"{high:.6g}",
            effort=f"{hand.torque[j]:.6g}", velocity=f"{SPEED:g}",
        )  # fmt: skip
        ET.SubElement(robot, "link", name=link)
        parent, at, turned = link, -anchor, np.eye(3)
    _origin(_joint(robot, "fixed", f"{name}_fixed", parent, name), at, turned)
    ET.SubElement(robot, "link", name=name)


def _joint(robot: ET.Element, kind: str, name: str, parent: str, child: str) -> ET.Element:
    joint = ET.SubElement(robot, "joint", name=name, type=kind)
    ET.SubElement(joint, "parent", link=parent)
    ET.SubElement(joint, "child", link=child)
    return joint


def _origin(joint: ET.Element, at: Array, turned: Array) -> None:
    rpy = Rotation.from_matrix(turned).as_euler("xyz")
    ET.SubElement(joint, "origin", xyz=_words(at), rpy=_words(rpy))


def _words(values: Array) -> str:
    return " ".join(f"{v:.9g}" for v in values)
