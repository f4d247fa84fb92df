"""The robot hand above a table with objects to grasp, as one MuJoCo model."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from extensions.robot.hand import RobotHand
from extensions.robot.wearer_hand import FINGERS
from tracker.messages import Array

TIMESTEP = 0.002  # s
STIFF_AT = 0.2  # rad of error at which a motor reaches its full torque
PREFIX = "hand/"
MOUNT = "palm_mount"
FRICTION = (1.2, 0.01, 0.0005)
TABLE = np.array([0.6, 0.6, 0.02])  # m, half

PLACES = {"cube": (0.05, -0.10), "cylinder": (0.10, 0.0), "ball": (0.05, 0.10)}
"""x, y in m, in the robot's world."""
COLOURS = {"cube": "#D55E00", "cylinder": "#0072B2", "ball": "#009E73"}
CUBE = 0.025  # m, half its edge
CYLINDER = (0.022, 0.045)  # m, radius and half its height
BALL = 0.03  # m
DENSITY = 400.0  # kg/m³: wood


@dataclass(frozen=True, eq=False)
class RobotScene:
    """``model`` and rows in it: qpos of finger joints (n,) and of objects (7 each), motors (n,),
    bodies of objects and of fingertips (5,), -1 for a finger that the hand does not have."""

    model: mujoco.MjModel
    joint_rows: Array
    motors: Array
    objects: tuple[str, ...]
    object_rows: tuple[int, ...]
    object_bodies: tuple[int, ...]
    tip_bodies: Array
    mount: int


def build_scene(hand: RobotHand, objects: Sequence[str]) -> RobotScene:
    """The scene with the hand at the origin, carried by a mocap body."""
    spec = mujoco.MjSpec()
    _set_options(spec)
    spec.worldbody.add_geom(
        name="table", type=mujoco.mjtGeom.mjGEOM_BOX, size=TABLE, pos=[0, 0, -TABLE[2]],
        friction=FRICTION,
    )  # fmt: skip
    for name in objects:
        _add_object(spec, name)
    names = _add_hand(spec, hand)
    model = spec.compile()
    return _rows(model, hand, tuple(objects), names)


def _set_options(spec: Any) -> None:
    spec.option.timestep = TIMESTEP
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10.0
    spec.option.iterations = 30
    spec.compiler.degree = False


def _add_object(spec: Any, name: str) -> None:
    x, y = PLACES[name]
    kind, size, height = {
        "cube": (mujoco.mjtGeom.mjGEOM_BOX, [CUBE, CUBE, CUBE], CUBE),
        "cylinder": (mujoco.mjtGeom.mjGEOM_CYLINDER, [*CYLINDER, 0.0], CYLINDER[1]),
        "ball": (mujoco.mjtGeom.mjGEOM_SPHERE, [BALL, 0.0, 0.0], BALL),
    }[name]
    body = spec.worldbody.add_body(name=name, pos=[x, y, height])
    body.add_freejoint(name=name)
    friction = (FRICTION[0], FRICTION[1], 0.003)  # a ball comes to rest
    body.add_geom(name=name, type=kind, size=size, density=DENSITY, friction=friction, condim=6)


def _add_hand(spec: Any, hand: RobotHand) -> list[str]:
    """Attach the hand by its palm; returns the names of its joints in the scene."""
    part = _without_options(hand.mjcf)
    anatomy = hand.anatomy
    spec.worldbody.add_body(name="carried", mocap=True)
    mount = spec.worldbody.add_body(name=MOUNT, gravcomp=1.0)
    mount.add_freejoint(name=MOUNT)
    mount.mass, mount.inertia, mount.explicitinertial = 0.1, [1e-3] * 3, True
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(anatomy.R_WP.T).ravel())
    frame = mount.add_frame(pos=-anatomy.R_WP.T @ anatomy.p_WP, quat=quat)
    frame.attach_body(part.body(hand.model.body(anatomy.base).name), PREFIX, "")
    weld = spec.add_equality(
        type=mujoco.mjtEq.mjEQ_WELD, objtype=mujoco.mjtObj.mjOBJ_BODY, name1="carried", name2=MOUNT
    )
    weld.data = np.array([0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1.0, 0])
    weld.solref, weld.solimp = [0.01, 1.0], [0.98, 0.995, 1e-3, 0.5, 2]
    _free_forearm(spec, hand)
    names = [PREFIX + hand.model.joint(j).name for j in range(hand.model.njnt)]
    for name, torque, limits in zip(names, hand.torque, hand.limits, strict=True):
        _add_motor(spec, name, float(torque), limits)
    return names


def _without_options(mjcf: str) -> Any:
    """The hand's specification without its options, which would replace those of the scene."""
    root = ET.fromstring(mjcf)
    for name in ("option", "size", "statistic", "visual"):
        for element in root.findall(name):
            root.remove(element)
    for element in root.iter():
        element.attrib.pop("user", None)
    return mujoco.MjSpec.from_string(ET.tostring(root, encoding="unicode"))


def _add_motor(spec: Any, joint: str, torque: float, limits: Array) -> None:
    """Add a position servo that reaches its full torque at an error of `STIFF_AT`."""
    stiffness = torque / STIFF_AT
    motor = spec.add_actuator(name=joint, target=joint, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    motor.gaintype, motor.biastype = mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtBias.mjBIAS_AFFINE
    motor.gainprm[0], motor.biasprm[1] = stiffness, -stiffness
    motor.ctrllimited, motor.ctrlrange = True, limits
    motor.forcelimited, motor.forcerange = True, [-torque, torque]


def _free_forearm(spec: Any, hand: RobotHand) -> None:
    """Disable collisions of the bodies behind the palm, so that the table does not block them."""
    body = hand.model.body(hand.anatomy.palm).parentid[0]
    while body > 0:
        for geom in spec.body(PREFIX + hand.model.body(body).name).geoms:
            geom.contype = geom.conaffinity = 0
        body = hand.model.body(body).parentid[0]


def _rows(
    model: mujoco.MjModel, hand: RobotHand, objects: tuple[str, ...], joints: list[str]
) -> RobotScene:
    tips = np.full(len(FINGERS), -1)
    for finger in hand.anatomy.fingers:
        name = PREFIX + hand.model.body(finger.body).name
        tips[FINGERS.index(finger.name)] = model.body(name).id
    return RobotScene(
        model,
        np.array([int(model.joint(n).qposadr[0]) for n in joints]),
        np.array([model.actuator(n).id for n in joints]),
        objects,
        tuple(int(model.joint(n).qposadr[0]) for n in objects),
        tuple(int(model.body(n).id) for n in objects),
        tips,
        int(model.joint(MOUNT).qposadr[0]),
    )
