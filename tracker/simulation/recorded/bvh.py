"""BVH: joints, and their positions by forward kinematics."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from tracker.base.errors import DataError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import Array


@dataclass
class BvhJoint:
    """``parent`` is a row, -1 for a root; ``offset`` (3,) in the file's unit."""

    name: str
    parent: int
    offset: Array
    channels: list[str] = field(default_factory=list)


def joint_positions(text: str) -> tuple[list[BvhJoint], Array, Array]:
    """Joints, parents first; times (N,) s; positions (N, joints, 3) in the file's unit.

    An end site is named ``<parent>.end``. Raises ValueError or IndexError if the text is not BVH.
    """
    joints, motion = _hierarchy(text)
    t, values = _motion(motion)
    return joints, t, _positions(joints, values)


def _hierarchy(text: str) -> tuple[list[BvhJoint], str]:
    """Joints parents first, End Sites as ``<parent>.end``, and the text of the MOTION part."""
    head, found, motion = text.partition("MOTION")
    if not found or not head.lstrip().startswith("HIERARCHY"):
        raise DataError(notice("data.bvh_parts"))
    words = iter(head.split())
    joints: list[BvhJoint] = []
    stack: list[int] = []
    for word in words:
        if word in ("ROOT", "JOINT"):
            joints.append(BvhJoint(next(words), stack[-1] if stack else -1, np.zeros(3)))
        elif word == "End":
            next(words)
            joints.append(BvhJoint(joints[stack[-1]].name + ".end", stack[-1], np.zeros(3)))
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
        raise DataError(notice("data.bvh_motion"))
    count, period = int(match[1]), float(match[2])
    values: Array = np.array(text[match.end() :].split(), float).reshape(count, -1)
    return period * np.arange(count, dtype=np.float64), values


def _positions(joints: list[BvhJoint], values: Array) -> Array:
    """(n, joints, 3) by forward kinematics; channels apply left to right, in degrees."""
    n, column = len(values), 0
    if values.shape[1] != sum(len(j.channels) for j in joints):
        raise DataError(notice("data.bvh_channels"))
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
