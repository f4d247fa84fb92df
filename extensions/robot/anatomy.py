"""Finds the palm, fingers and fingertips of a robot hand in the body tree of an MJCF model.

Fingers are recognised by the usual names (Shadow's ff, mf, rf, lf, th; index, middle, …). The palm
is the last body that all fingers share; its axes follow from the knuckles and from the direction in
which the fingers bend.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import mujoco
import numpy as np

from extensions.robot.wearer_hand import FINGERS
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array

NAMES = {
    "thumb": r"thumb|^th",
    "index": r"index|fore|^ff",
    "middle": r"middle|^mid|^mf",
    "ring": r"ring|^rf",
    "little": r"little|pink|^lf",
}
PREFIX = re.compile(r"^([a-z]*\d*[:/]|[rl]h_|left_|right_|robot0_)+", re.IGNORECASE)
JOINTS_OF_A_FINGER = 2  # minimum: a leaf with fewer is not a finger
COUPLED = 0.1  # of the joints' ranges: a tendon with a smaller range couples its joints
SAME_PLACE = 1e-4  # m


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

    couplings (k, nq) and coupled_to (k,): weighted sums of joint angles that tendons keep constant.
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


def plain(name: str) -> str:
    """A name without the model's prefix: ``robot0:FFJ3`` is FFJ3."""
    return PREFIX.sub("", name)


def find_palm(model: mujoco.MjModel) -> tuple[int, int, dict[str, int]]:
    """Rows of the palm, of the root body that carries it, and of each finger's last body.

    Raises ConfigError if the model does not contain a hand.
    """
    leaves = _leaves(model)
    if "thumb" not in leaves or "middle" not in leaves or "index" not in leaves:
        raise ConfigError(notice("robot.no_fingers"))
    paths = [_path(model, body) for body in leaves.values()]
    common = [b for b in paths[0] if all(b in path for path in paths)]
    if len(common) < 2:
        raise ConfigError(notice("robot.no_palm"))
    return common[-1], common[1], leaves


def _leaves(model: mujoco.MjModel) -> dict[str, int]:
    parents = set(model.body_parentid[1:].tolist())
    found: dict[str, int] = {}
    for body in range(1, model.nbody):
        if body in parents or len(_joints(model, body)) < JOINTS_OF_A_FINGER:
            continue
        name = plain(model.body(body).name).lower()
        for finger, pattern in NAMES.items():
            if re.search(pattern, name) and finger not in found:
                found[finger] = body
                break
    return found


def _path(model: mujoco.MjModel, body: int) -> list[int]:
    """Bodies from the world to ``body``."""
    out = [body]
    while out[0] != 0:
        out.insert(0, int(model.body_parentid[out[0]]))
    return out


def _joints(model: mujoco.MjModel, body: int, after: int = 0) -> list[int]:
    """Hinges between the body ``after`` and ``body``."""
    out: list[int] = []
    for b in _path(model, body):
        first = int(model.body_jntadr[b])
        out += range(first, first + int(model.body_jntnum[b])) if first >= 0 else []
        if b == after:
            out = []
    return [j for j in out if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_HINGE]


def read_anatomy(model: mujoco.MjModel) -> RobotAnatomy:
    """Anatomy of a model whose only joints are those of the fingers. Raises ConfigError."""
    palm, base, leaves = find_palm(model)
    data = mujoco.MjData(model)
    data.qpos[:] = np.clip(0.0, *_ranges(model).T)
    mujoco.mj_kinematics(model, data)
    tips = {f: _tip(model, data, f, body) for f, body in leaves.items()}
    chains = {f: _chain(model, data, _joints(model, b, palm)) for f, b in leaves.items()}
    R, p, side = _palm_frame(model, data, leaves, tips, chains)
    fingers = []
    for name in (f for f in FINGERS if f in leaves):
        body = leaves[name]
        chain = np.vstack([chains[name], _at(data, body, tips[name])])
        length = float(np.linalg.norm(np.diff(chain, axis=0), axis=1).sum())
        joints = tuple(_joints(model, body, palm))
        knuckle = R.T @ (chain[0] - p)
        fingers.append(
            RobotFinger(name, body, tips[name], knuckle, length, joints, _radius(model, body))
        )
    couplings, middle = _couplings(model)
    return RobotAnatomy(side, palm, base, R, p, tuple(fingers), couplings, middle)


def _ranges(model: mujoco.MjModel) -> Array:
    """(nq, 2) rad; ±π for a joint without limits."""
    out = np.array(model.jnt_range, float)
    out[model.jnt_limited == 0] = -np.pi, np.pi
    return out


def _chain(model: mujoco.MjModel, data: mujoco.MjData, joints: list[int]) -> Array:
    """(≤ 3, 3) m: positions of a finger's last three joints; coincident joints count once."""
    out: list[Array] = []
    for j in joints:
        at = np.array(data.xanchor[j])
        if not out or np.linalg.norm(at - out[-1]) > SAME_PLACE:
            out.append(at)
    return np.array(out[-3:])


def _tip(model: mujoco.MjModel, data: mujoco.MjData, finger: str, body: int) -> Array:
    """(3,) m in the last body's frame: its site named tip, or the end of its collision geoms."""
    for site in range(model.nsite):
        name = plain(model.site(site).name).lower()
        if model.site_bodyid[site] == body and "tip" in name and "tch" not in name:
            return np.array(model.site_pos[site])
    start = int(model.body_geomadr[body])
    geoms = [g for g in range(start, start + int(model.body_geomnum[body])) if start >= 0]
    solid = [g for g in geoms if model.geom_contype[g] or model.geom_conaffinity[g]] or geoms
    if not solid:
        raise ConfigError(notice("robot.no_tip", finger=finger))
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
    data: mujoco.MjData,
    leaves: dict[str, int],
    tips: dict[str, Array],
    chains: dict[str, Array],
) -> tuple[Array, Array, str]:
    """R_WP, p_WP and the side."""
    others = [f for f in leaves if f != "thumb"]
    straight = {f: _at(data, leaves[f], tips[f]) for f in others}
    x = np.mean([straight[f] - chains[f][0] for f in others], axis=0)
    x /= np.linalg.norm(x)
    last = [f for f in FINGERS if f in others][-1]
    to_index = chains["index"][0] - chains[last][0]
    to_index -= x * (x @ to_index)
    ranges = _ranges(model)
    bent = mujoco.MjData(model)
    bent.qpos[:] = ranges.mean(axis=1)
    mujoco.mj_kinematics(model, bent)
    bending = np.mean([_at(bent, leaves[f], tips[f]) - straight[f] for f in others], axis=0)
    z = np.cross(x, to_index / np.linalg.norm(to_index))
    z = -z if z @ bending > 0 else z
    y = np.cross(z, x)
    side = "right" if y @ to_index > 0 else "left"
    return np.stack([x, y, z], axis=1), chains["middle"][0].copy(), side


def _radius(model: mujoco.MjModel, body: int) -> float:
    """Radius in m of the last body's thinnest collision geom."""
    first = int(model.body_geomadr[body])
    geoms = range(first, first + int(model.body_geomnum[body])) if first >= 0 else range(0)
    sizes = [
        float(model.geom_size[g, 0])
        for g in geoms
        if model.geom_contype[g] and model.geom_type[g] != mujoco.mjtGeom.mjGEOM_MESH
    ]
    return min(sizes, default=0.008)


def _couplings(model: mujoco.MjModel) -> tuple[Array, Array]:
    """Couplings by tendons over several joints whose length is nearly constant."""
    rows, middle = [], []
    ranges = _ranges(model)
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
    return np.array(rows).reshape(-1, model.nq), np.array(middle)
