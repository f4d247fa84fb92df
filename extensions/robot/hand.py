"""Loads a robot hand: an MJCF model with a fixed palm and moving fingers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from extensions.robot.anatomy import RobotAnatomy, find_palm, plain, read_anatomy
from extensions.robot.library import MODELS, model_path, need_mujoco
from extensions.robot.mirror import mirrored
from extensions.robot.settings import RobotSettings
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array

MOST_BYTES = 20_000_000  # of a hand's MJCF file, without the meshes
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


def load_hand(settings: RobotSettings) -> RobotHand:
    """The hand of the settings, mirrored if necessary to the wearer's side. Raises ConfigError."""
    need_mujoco()
    path = model_path(settings.model)
    try:
        if path.stat().st_size > MOST_BYTES:
            raise ConfigError(notice("robot.too_large", file=path.name, limit_bytes=MOST_BYTES))
        text, torque_of = _prepared(path)
        model = mujoco.MjModel.from_xml_string(text)
        anatomy = read_anatomy(model)
        if anatomy.side != settings.side:
            text = mirrored(text)
            model = mujoco.MjModel.from_xml_string(text)
            anatomy = read_anatomy(model)
    except (ValueError, mujoco.FatalError, mujoco.UnexpectedError) as error:
        why = str(error).strip().splitlines()[0]
        raise ConfigError(notice("robot.not_usable", file=path.name, why=why)) from error
    names = [model.joint(j).name for j in range(model.njnt)]
    limits = np.array(model.jnt_range, float)
    limits[model.jnt_limited == 0] = -np.pi, np.pi
    short = settings.model if settings.model in MODELS else plain(path.stem)
    return RobotHand(
        f"{''.join(c if c.isalnum() else '_' for c in short.lower())}_{settings.side}",
        text,
        model,
        anatomy,
        tuple(plain(n) for n in names),
        limits,
        np.array([torque_of.get(n, USUAL_TORQUE) for n in names]),
    )


def _prepared(path: Path) -> tuple[str, dict[str, float]]:
    """MJCF of the hand without the bodies that carry its palm, and each joint's motor torque."""
    spec = mujoco.MjSpec.from_file(str(path))
    model = spec.compile()
    palm, base, _ = find_palm(model)
    torque = _torques(model)
    root = spec.body(model.body(base).name)
    carrying = {model.joint(j).name for j in range(model.njnt)} - _below(model, palm)
    for listed in (spec.actuators, spec.sensors, spec.keys, spec.equalities):
        for part in list(listed):
            spec.delete(part)
    for tendon in [t for t in spec.tendons if _pulls(model, t.name, carrying)]:
        spec.delete(tendon)
    for joint in [j for j in spec.joints if j.name in carrying]:
        spec.delete(joint)
    for body in [b for b in spec.worldbody.bodies if b.name != root.name]:
        spec.delete(body)
    for part in [*spec.worldbody.geoms, *spec.worldbody.sites, *spec.lights, *spec.cameras]:
        spec.delete(part)
    for part in spec.bodies:
        part.gravcomp = 1.0
    spec.meshdir = str((path.parent / spec.meshdir).resolve())
    spec.texturedir = str((path.parent / spec.texturedir).resolve())
    spec.compile()
    return spec.to_xml(), torque


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
    """Maximum torque in N m per joint, for motors with a limit in the file."""

    out = {}
    for a in range(model.nu):
        if (
            model.actuator_trntype[a] == mujoco.mjtTrn.mjTRN_JOINT
            and model.actuator_forcelimited[a]
        ):
            joint = model.joint(int(model.actuator_trnid[a, 0])).name
            out[joint] = float(np.abs(model.actuator_forcerange[a]).max())
    return out
