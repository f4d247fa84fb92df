"""Reads the palm, fingers and fingertips of a robot hand from the bodies of a model.

The palm's axes follow from the knuckles and from the direction in which the fingers bend.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from extensions.robot.finger_map import FingerMap
from extensions.robot.fingers import (
    distal_of,
    find_fingers,
    fixed_to,
    hinges,
    joint_ranges,
    plain,
)
from extensions.robot.wearer_hand import FINGERS
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array

COUPLED = 0.1  # of the joints' ranges: a tendon with a smaller range couples its joints
SAME_PLACE = 1e-4  # m
FIXED_BELOW = 1e-3  # m from the last joint: a fixed link nearer than that is not a fingertip's
SHORTER, SHORT_BONE = 0.8, 0.02  # of the bone before it, and m: a last bone of unknown length


@dataclass(frozen=True, eq=False)
class RobotFinger:
    """``body`` is the finger's last body; tip (3,) m in its frame; knuckle (3,) m in the palm's
    frame P, where the bones begin; ``length`` m from the knuckle to the tip; ``joints`` are rows of
    the model; ``radius`` m."""

    name: str
    body: int
    tip: Array
    knuckle: Array
    length: float
    joints: tuple[int, ...]
    radius: float


@dataclass(frozen=True, eq=False)
class RobotAnatomy:
    """Anatomy of a model whose palm is fixed: R_WP (3, 3), p_WP (3,) m of the palm's frame P (x to
    the fingertips, z out of its back, origin at the middle knuckle), rows of bodies and joints.

    couplings (k, nq) and coupled_to (k,): weighted sums of joint angles that tendons and
    joints that mimic others keep constant.
    """

    side: str
    palm: int
    base: int
    R_WP: Array
    p_WP: Array
    fingers: tuple[RobotFinger, ...]
    couplings: Array
    coupled_to: Array

    @property
    def joints(self) -> tuple[int, ...]:
        """Joints of all fingers, in the model's order, shared ones included."""
        return tuple(sorted({j for finger in self.fingers for j in finger.joints}))


def read_anatomy(model: mujoco.MjModel, given: FingerMap | None = None) -> RobotAnatomy:
    """Anatomy of a model whose only joints are those of the fingers. Raises ConfigError."""
    found = find_fingers(model, given or FingerMap())
    palm, links = found.palm, found.links
    data = mujoco.MjData(model)
    data.qpos[:] = np.clip(0.0, *joint_ranges(model).T)
    mujoco.mj_kinematics(model, data)
    ends = {f: distal_of(model, link) for f, link in links.items()}
    chains = {f: _chain(data, hinges(model, end, palm)) for f, end in ends.items()}
    tips = {f: _tip(model, data, link, chains[f]) for f, link in links.items()}
    R, p, side = _palm_frame(model, ends, tips, chains)
    fingers = []
    for name in (f for f in FINGERS if f in links):
        end = ends[name]
        chain = np.vstack([chains[name], _at(data, end, tips[name])])
        length = float(np.linalg.norm(np.diff(chain, axis=0), axis=1).sum())
        joints = tuple(hinges(model, end, palm))
        knuckle = R.T @ (chain[0] - p)
        fingers.append(
            RobotFinger(name, end, tips[name], knuckle, length, joints, _radius(model, end))
        )
    couplings, middle = _couplings(model)
    return RobotAnatomy(side, palm, found.base, R, p, tuple(fingers), couplings, middle)


def _chain(data: mujoco.MjData, joints: list[int]) -> Array:
    """(≤ 3, 3) m: positions of a finger's last three joints; coincident joints count once."""
    out: list[Array] = []
    for j in joints:
        at = np.array(data.xanchor[j])
        if not out or np.linalg.norm(at - out[-1]) > SAME_PLACE:
            out.append(at)
    return np.array(out[-3:])


def _tip(model: mujoco.MjModel, data: mujoco.MjData, link: int, chain: Array) -> Array:
    """(3,) m in the last moving link: the origin of a link that is fixed to it, its site named
    tip, the end of its geoms, or, without any, the last bone again."""
    end = distal_of(model, link)
    here = np.array(data.xpos[link] - data.xpos[end]) @ data.xmat[end].reshape(3, 3)
    if link != end and np.linalg.norm(here) > FIXED_BELOW:
        return here
    for site in range(model.nsite):
        name = plain(model.site(site).name).lower()
        if model.site_bodyid[site] == end and "tip" in name and "tch" not in name:
            return np.array(model.site_pos[site])
    geoms = [g for g in range(model.ngeom) if model.geom_bodyid[g] in (end, link)]
    geoms = [g for g in geoms if model.geom_bodyid[g] == end] or geoms
    solid = [g for g in geoms if model.geom_contype[g] or model.geom_conaffinity[g]] or geoms
    fixed = fixed_to(model, end)
    if not solid and not fixed:
        bone = chain[-1] - chain[-2] if len(chain) > 1 else np.array([0.0, 0.0, SHORT_BONE])
        return np.asarray(SHORTER * bone @ data.xmat[end].reshape(3, 3))
    if not solid:
        return np.asarray((data.xpos[fixed[-1]] - data.xpos[end]) @ data.xmat[end].reshape(3, 3))
    far = max(solid, key=lambda g: float(np.linalg.norm(model.geom_pos[g])))
    at = np.array(model.geom_pos[far])
    reach = float(np.linalg.norm(at))
    inside = 0.6 * float(model.geom_rbound[far])
    return at if reach < SAME_PLACE else np.asarray(at * (1.0 + inside / reach))


def _at(data: mujoco.MjData, body: int, point: Array) -> Array:
    """(3,) m in the world."""
    return np.asarray(data.xpos[body] + data.xmat[body].reshape(3, 3) @ point)


def _palm_frame(
    model: mujoco.MjModel,
    ends: dict[str, int],
    tips: dict[str, Array],
    chains: dict[str, Array],
) -> tuple[Array, Array, str]:
    """R_WP, p_WP and the side."""
    others = [f for f in FINGERS[1:] if f in ends]
    ranges = joint_ranges(model)
    straight = _tips_at(model, np.clip(0.0, *ranges.T), ends, tips)
    x = np.mean([straight[f] - chains[f][0] for f in others], axis=0)
    x /= np.linalg.norm(x)
    to_first = chains[others[0]][0] - chains[others[-1]][0]
    to_first -= x * (x @ to_first)
    if np.linalg.norm(to_first) < SAME_PLACE:
        raise ConfigError(notice("robot.no_palm"))
    bent = _tips_at(model, ranges.mean(axis=1), ends, tips)
    bending = np.mean([bent[f] - straight[f] for f in others], axis=0)
    z = np.cross(x, to_first / np.linalg.norm(to_first))
    z = -z if z @ bending > 0 else z
    y = np.cross(z, x)
    side = "right" if y @ to_first > 0 else "left"
    origin = chains.get("middle", chains[others[0]])[0]
    return np.stack([x, y, z], axis=1), origin.copy(), side


def _tips_at(
    model: mujoco.MjModel, q: Array, ends: dict[str, int], tips: dict[str, Array]
) -> dict[str, Array]:
    """(3,) m of each tip in the world with joints at q (nq,)."""
    data = mujoco.MjData(model)
    data.qpos[:] = q
    mujoco.mj_kinematics(model, data)
    return {f: _at(data, end, tips[f]) for f, end in ends.items()}


def _radius(model: mujoco.MjModel, body: int) -> float:
    """Radius in m of the last link's thinnest collision geom."""
    bodies = [body, *fixed_to(model, body)]
    geoms = [g for g in range(model.ngeom) if model.geom_bodyid[g] in bodies]
    sizes = [
        float(model.geom_size[g, 0])
        for g in geoms
        if model.geom_contype[g] and model.geom_type[g] != mujoco.mjtGeom.mjGEOM_MESH
    ]
    return min(sizes, default=0.008)


def _couplings(model: mujoco.MjModel) -> tuple[Array, Array]:
    """Couplings by joints that mimic others (of first order), and by tendons over several joints
    whose length is nearly constant."""
    rows, middle = [], []
    ranges = joint_ranges(model)
    for t in range(model.ntendon):
        first, number = int(model.tendon_adr[t]), int(model.tendon_num[t])
        wraps = range(first, first + number)
        if number < 2 or not model.tendon_limited[t]:
            continue
        if any(model.wrap_type[w] != mujoco.mjtWrap.mjWRAP_JOINT for w in wraps):
            continue
        row = np.zeros(model.nq)
        for w in wraps:
            row[model.jnt_qposadr[model.wrap_objid[w]]] = model.wrap_prm[w]
        low, high = model.tendon_range[t]
        if high - low < COUPLED * float(np.abs(row) @ np.diff(ranges, axis=1).ravel()):
            size = np.abs(row).max()
            rows.append(row / size)
            middle.append(0.5 * (low + high) / size)
    for e in np.flatnonzero(model.eq_type == mujoco.mjtEq.mjEQ_JOINT):
        row = np.zeros(model.nq)
        row[model.jnt_qposadr[model.eq_obj1id[e]]] = 1.0
        if model.eq_obj2id[e] >= 0:
            row[model.jnt_qposadr[model.eq_obj2id[e]]] = -model.eq_data[e, 1]
        rows.append(row)
        middle.append(float(model.eq_data[e, 0]))
    return np.array(rows).reshape(-1, model.nq), np.array(middle)
