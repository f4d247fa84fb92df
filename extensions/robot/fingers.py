"""Finds the fingers of a robot hand in the body tree of a model: by name, then by position.

A finger is the chain of hinges from the palm to the last body with a hinge. Names are those of its
bodies, joints and sites (Shadow's ff, mf, rf, lf, th; index, middle, …). Chains without such a name
are identified by geometry: the thumb is the one without which the others are most nearly parallel,
and the index finger is next to the thumb.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import mujoco
import numpy as np

from extensions.robot.finger_map import PALM, FingerMap
from extensions.robot.wearer_hand import FINGERS
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array

PREFIX = re.compile(r"^([a-z]*\d*[:/]|[rl]h_|left_|right_|robot0_)+", re.IGNORECASE)
_START = r"(?<![a-z])"
NAMES = (
    ("thumb", rf"thumb|pollex|{_START}th(?!e|ir|r)"),
    ("index", rf"index|fore(?!arm)|pointer|{_START}ff"),
    ("middle", rf"{_START}mf"),
    ("ring", rf"{_START}ring|ring_?finger|{_START}rf"),
    ("little", rf"little|pink[yi]|{_START}lf"),
    ("middle", rf"{_START}mid"),
)
"""In this order: a middle phalanx is called middle, too."""
CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])")
BY_USER, BY_NAME, BY_POSITION = "user", "name", "position"
FEWEST, MOST = 3, 6  # fingers of a palm; the sixth may be a joint of the palm itself
CENTRAL = 0.1  # of the distance between the outer fingers
JOINTS_OF_A_FINGER = (2, 1)  # hinges between palm and tip, at least; the second if nothing is found


@dataclass(frozen=True)
class Found:
    """``links``: row of the body whose end is the tip, by finger; ``how``: `BY_USER`, … by finger.

    ``palm`` is the last body that all fingers share, ``base`` the child of the world that carries
    it."""

    palm: int
    base: int
    links: dict[str, int]
    how: dict[str, str]

    def names(self, model: mujoco.MjModel) -> dict[str, str]:
        """Names of the links by finger, and of the palm, as a `FingerMap` contains them."""
        links = {f: model.body(b).name for f, b in self.links.items()}
        return {**{f: links.get(f, "") for f in FINGERS}, PALM: model.body(self.palm).name}


def plain(name: str) -> str:
    """A name without the model's prefix: ``robot0:FFJ3`` is FFJ3."""
    return PREFIX.sub("", name)


def find_fingers(model: mujoco.MjModel, given: FingerMap) -> Found:
    """The fingers of a model; ``given`` are the user's choices. Raises ConfigError."""
    chosen = {f: _body(model, link) for f, link in given.links.items() if link}
    chosen_palm = chosen.pop(PALM, 0)
    ends = last_links(model)
    palm = chosen_palm or _palm(model, ends, list(chosen.values()))
    taken = {distal_of(model, body) for body in chosen.values()}
    free = [e for e in ends if e not in taken and palm in path_to(model, e)[:-1]]
    absent = {f for f, link in given.links.items() if not link}
    links, how = dict(chosen), dict.fromkeys(chosen, BY_USER)
    for finger, end in _named(model, palm, free).items():
        if finger not in links and finger not in absent:
            links[finger], how[finger] = tip_link(model, end), BY_NAME
    rest = [e for e in free if e not in {distal_of(model, b) for b in links.values()}]
    for finger, end in _by_position(model, palm, rest, links, absent).items():
        links[finger], how[finger] = tip_link(model, end), BY_POSITION
    others = [f for f in links if f != "thumb"]
    if "thumb" not in links or len(others) < FEWEST - 1:
        raise ConfigError(notice("robot.no_fingers"))
    paths = [path_to(model, body) for body in links.values()]
    common = [b for b in paths[0] if all(b in path for path in paths)]
    if len(common) < 2 or any(not hinges(model, b, common[-1]) for b in links.values()):
        raise ConfigError(notice("robot.no_palm"))
    shared = chosen_palm if chosen_palm in common[1:] else common[-1]
    return Found(shared, common[1], links, how)


def _body(model: mujoco.MjModel, name: str) -> int:
    row = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name)
    if row < 1:
        raise ConfigError(notice("robot.no_link", link=name))
    return int(row)


def path_to(model: mujoco.MjModel, body: int) -> list[int]:
    """Bodies from the world to ``body``."""
    out = [body]
    while out[0] != 0:
        out.insert(0, int(model.body_parentid[out[0]]))
    return out


def hinges(model: mujoco.MjModel, body: int, after: int = 0) -> list[int]:
    """Hinges between the body ``after`` and ``body``."""
    out: list[int] = []
    for b in path_to(model, body):
        first = int(model.body_jntadr[b])
        out += range(first, first + int(model.body_jntnum[b])) if first >= 0 else []
        if b == after:
            out = []
    return [j for j in out if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_HINGE]


def last_links(model: mujoco.MjModel) -> list[int]:
    """Bodies with a hinge that carry no other body with one."""
    moving = [b for b in range(1, model.nbody) if _has_hinge(model, b)]
    inner = {a for b in moving for a in path_to(model, b)[:-1]}
    return [b for b in moving if b not in inner]


def _has_hinge(model: mujoco.MjModel, body: int) -> bool:
    first, number = int(model.body_jntadr[body]), int(model.body_jntnum[body])
    kinds = model.jnt_type[first : first + number] if first >= 0 else []
    return any(kind == mujoco.mjtJoint.mjJNT_HINGE for kind in kinds)


def distal_of(model: mujoco.MjModel, body: int) -> int:
    """The body with a hinge to which ``body`` is fixed, or itself."""
    return next((b for b in reversed(path_to(model, body)) if _has_hinge(model, b)), body)


def fixed_to(model: mujoco.MjModel, distal: int) -> list[int]:
    """Bodies that are fixed to ``distal``, without it."""
    return [
        b for b in range(distal + 1, model.nbody)
        if int(model.body_weldid[b]) == int(model.body_weldid[distal])
    ]  # fmt: skip


def tip_link(model: mujoco.MjModel, distal: int) -> int:
    """The link of a fingertip: a link called tip that is fixed to the last moving one, or that."""
    tips = [b for b in fixed_to(model, distal) if "tip" in model.body(b).name.lower()]
    return tips[-1] if tips else distal


def _palm(model: mujoco.MjModel, ends: list[int], chosen: list[int]) -> int:
    """The body with most fingers, the last of those that share them."""
    paths = {e: path_to(model, e) for e in ends}
    for least in JOINTS_OF_A_FINGER:
        best, rank = 0, (0, 0)
        for body in range(1, model.nbody):
            carried = [
                e for e, path in paths.items()
                if body in path[:-1] and len(hinges(model, e, body)) >= least
            ]  # fmt: skip
            holds_all = all(body in path_to(model, c) for c in chosen)
            here = len(carried), len(path_to(model, body))
            if FEWEST <= len(carried) <= MOST and holds_all and here > rank:
                best, rank = body, here
        if best:
            return best
    raise ConfigError(notice("robot.no_fingers"))


def _named(model: mujoco.MjModel, palm: int, ends: list[int]) -> dict[str, int]:
    """Chains with a finger's name that no other chain has."""
    found: dict[str, list[int]] = {}
    for end in ends:
        finger = _name_of(model, palm, end)
        if finger is not None:
            found.setdefault(finger, []).append(end)
    return {finger: chains[0] for finger, chains in found.items() if len(chains) == 1}


def _name_of(model: mujoco.MjModel, palm: int, end: int) -> str | None:
    bodies = path_to(model, end)
    bodies = [*reversed(bodies[bodies.index(palm) + 1 :]), *fixed_to(model, end)]
    words = [model.body(b).name for b in bodies]
    words += [model.joint(j).name for j in hinges(model, end, palm)]
    words += [model.site(s).name for s in range(model.nsite) if model.site_bodyid[s] in bodies]
    plain_words = [CAMEL.sub("_", plain(w)).lower() for w in words]
    for finger, pattern in NAMES:
        if any(re.search(pattern, word) for word in plain_words):
            return finger
    return None


def _by_position(
    model: mujoco.MjModel, palm: int, ends: list[int], named: dict[str, int], absent: set[str]
) -> dict[str, int]:
    """Fingers of the chains without a name."""
    if not ends:
        return {}
    out: dict[str, int] = {}
    known = {f: distal_of(model, b) for f, b in named.items()}
    bones = _bones(model, palm, [*ends, *known.values()])
    rest = list(ends)
    if "thumb" not in named and "thumb" not in absent:
        out["thumb"] = _thumb(bones, rest)
        rest.remove(out["thumb"])
    free = [f for f in FINGERS[1:] if f not in named and f not in absent]
    order = _from_the_thumb(bones, rest, {**known, **out}.get("thumb"))
    out.update(zip(free, order, strict=False))
    return out


def joint_ranges(model: mujoco.MjModel) -> Array:
    """(nq, 2) rad; ±π for a joint without limits."""
    out = np.array(model.jnt_range, float)
    out[model.jnt_limited == 0] = -np.pi, np.pi
    return out


def _bones(model: mujoco.MjModel, palm: int, ends: list[int]) -> dict[int, tuple[Array, Array]]:
    """Where each finger begins (3,) m, and its direction (3,), with all joints at 0 if possible."""
    data = mujoco.MjData(model)
    rows = model.jnt_qposadr[model.jnt_type == mujoco.mjtJoint.mjJNT_HINGE]
    low, high = joint_ranges(model)[model.jnt_type == mujoco.mjtJoint.mjJNT_HINGE].T
    data.qpos[rows] = np.clip(0.0, low, high)
    mujoco.mj_kinematics(model, data)
    out = {}
    for end in ends:
        start = np.array(data.xanchor[hinges(model, end, palm)[-3:][0]])
        tips = fixed_to(model, end)
        reach = np.array(data.xpos[tips[-1] if tips else end]) - start
        length = float(np.linalg.norm(reach))
        out[end] = start, reach / length if length > 1e-6 else np.zeros(3)
    return out


def _thumb(bones: dict[int, tuple[Array, Array]], ends: list[int]) -> int:
    """The chain without which the others are most alike."""

    def spread(thumb: int) -> float:
        others = [bone for end, bone in bones.items() if end != thumb]
        starts = np.array([start for start, _ in others])
        along = np.array([direction for _, direction in others])
        uneven = np.linalg.svd(starts - starts.mean(axis=0), compute_uv=False)
        return float(1.0 - np.linalg.norm(along.mean(axis=0)) + uneven[1] / max(uneven[0], 1e-6))

    return min(ends, key=spread)


def _from_the_thumb(
    bones: dict[int, tuple[Array, Array]], ends: list[int], thumb: int | None
) -> list[int]:
    """Chains in the order in which they are next to each other, from the thumb on."""
    if len(ends) < 2:
        return list(ends)
    starts = np.array([bones[e][0] for e in ends])
    middle = starts.mean(axis=0)
    across = np.linalg.svd(starts - middle)[2][0]
    at = (starts - middle) @ across
    if thumb is not None:
        start, direction = bones[thumb]
        near = float((start - middle) @ across)
        if abs(near) < CENTRAL * np.ptp(at):  # the thumb begins below the palm's centre
            near = float(direction @ across)
        at = -at if near > 0 else at
    return [ends[i] for i in np.argsort(at)]
