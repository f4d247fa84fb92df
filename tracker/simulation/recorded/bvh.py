"""Biovision hierarchy files: joints by name, positions by their own kinematics, y up."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from tracker.base.errors import FileError
from tracker.geometry import so3
from tracker.messages import Array
from tracker.simulation.recorded.track import PointTrack

_FINGER = {"thumb": "thumb", "index": "index", "middle": "middle", "mid": "middle",
           "ring": "ring", "little": "little", "pinky": "little"}  # fmt: skip
_PARTS = {"thumb": ("cmc", "mcp", "ip", "tip"), "": ("mcp", "pip", "dip", "tip")}


@dataclass
class _Joint:
    name: str
    parent: int
    offset: Array
    channels: list[str] = field(default_factory=list)


def read_bvh(path: Path, text: str) -> PointTrack:
    """All joints of one hand's fingers. The side comes from the names, else right."""
    try:
        joints, motion = _hierarchy(text)
        t, values = _motion(motion)
        positions = _positions(joints, values)
    except (ValueError, IndexError) as error:
        raise FileError(f"{path} is not a BVH file that can be read: {error}.") from error
    side, rows = _hand_rows(joints)
    if len(rows) < 6:
        raise FileError(f"{path} names fewer than six joints of a hand's fingers.")
    up = np.array([0.0, 1.0, 0.0])
    return PointTrack(t, positions[:, list(rows.values())], tuple(rows), up, side, None)


def _hierarchy(text: str) -> tuple[list[_Joint], str]:
    """Joints parents first, End Sites as ``<parent>.end``, and the text of the MOTION part."""
    head, found, motion = text.partition("MOTION")
    if not found or not head.lstrip().startswith("HIERARCHY"):
        raise ValueError("it has no HIERARCHY and MOTION")
    words = iter(head.split())
    joints: list[_Joint] = []
    stack: list[int] = []
    for word in words:
        if word in ("ROOT", "JOINT"):
            joints.append(_Joint(next(words), stack[-1] if stack else -1, np.zeros(3)))
        elif word == "End":
            next(words)
            joints.append(_Joint(joints[stack[-1]].name + ".end", stack[-1], np.zeros(3)))
        elif word == "{":
            stack.append(len(joints) - 1)
        elif word == "}":
            stack.pop()
        elif word == "OFFSET":
            joints[stack[-1]].offset = np.array([float(next(words)) for _ in range(3)])
        elif word == "CHANNELS":
            joints[stack[-1]].channels = [next(words) for _ in range(int(next(words)))]
    return joints, motion


def _motion(text: str) -> tuple[Array, Array]:
    match = re.match(r"\s*Frames:\s*(\d+)\s*Frame Time:\s*(\S+)\s", text)
    if match is None:
        raise ValueError("its MOTION part does not begin with Frames and Frame Time")
    count, period = int(match[1]), float(match[2])
    values: Array = np.array(text[match.end() :].split(), float).reshape(count, -1)
    return period * np.arange(count, dtype=np.float64), values


def _positions(joints: list[_Joint], values: Array) -> Array:
    """(n, joints, 3) by forward kinematics; channels apply left to right, in degrees."""
    n, column = len(values), 0
    if values.shape[1] != sum(len(j.channels) for j in joints):
        raise ValueError("it has not one number for each channel")
    R = np.tile(np.eye(3), (len(joints), n, 1, 1))
    p = np.zeros((len(joints), n, 3))
    for i, joint in enumerate(joints):
        shift, turn = np.tile(joint.offset, (n, 1)), np.tile(np.eye(3), (n, 1, 1))
        moved = False
        for channel in joint.channels:
            axis, value = "XYZ".index(channel[0]), values[:, column]
            column += 1
            if channel.endswith("position"):
                shift = shift if moved else np.zeros((n, 3))
                moved, shift[:, axis] = True, value
            else:
                turn = turn @ so3.exp(np.outer(np.deg2rad(value), np.eye(3)[axis]))
        if joint.parent < 0:
            p[i], R[i] = shift, turn
        else:
            p[i] = p[joint.parent] + np.einsum("nij,nj->ni", R[joint.parent], shift)
            R[i] = R[joint.parent] @ turn
    return np.swapaxes(p, 0, 1)


def _hand_rows(joints: list[_Joint]) -> tuple[str, dict[str, int]]:
    """The side, and keypoint name to joint row; the right hand where a file has both."""
    sides = [_side(j.name) for j in joints]
    side = "left" if "left" in sides and "right" not in sides else "right"
    chains: dict[str, list[int]] = {}
    for i, joint in enumerate(joints):
        finger = next((f for word, f in _FINGER.items() if word in joint.name.lower()), None)
        if finger and sides[i] in (side, ""):
            chains.setdefault(finger, []).append(i)
    rows: dict[str, int] = {}
    for finger, chain in chains.items():
        parts = _PARTS.get(finger, _PARTS[""])
        for part, row in zip(parts[::-1], chain[::-1], strict=False):
            rows[f"{finger}_{part}"] = row
    return side, rows


def _side(name: str) -> str:
    low = name.lower()
    if "right" in low or re.search(r"(^r_|_r$|_r_|\.r$|\.r\.)", low):
        return "right"
    if "left" in low or re.search(r"(^l_|_l$|_l_|\.l$|\.l\.)", low):
        return "left"
    return ""
