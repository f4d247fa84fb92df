"""BVH: positions of joints and end sites by forward kinematics."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from extensions.reference.recording import Recording, numbers
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array

CENTIMETRE = 0.01  # m: BVH does not name its unit; most programs write centimetres
_DEEPEST = 200  # nested joints


@dataclass
class _Joint:
    """``parent`` is a row, -1 for a root; ``channels`` in the order of the file."""

    name: str
    parent: int
    offset: Array = field(default_factory=lambda: np.zeros(3))
    channels: list[str] = field(default_factory=list)


def read_bvh(path: Path, lines: list[str], unit: float = CENTIMETRE) -> Recording:
    """``unit`` in m. An end site has the name of its joint with `` end``. Raises FileError."""
    try:
        joints, begin = _hierarchy(lines)
        frames = int(lines[begin].split(":")[1])
        step = float(lines[begin + 1].split(":")[1])
        rows = [line.split() for line in lines[begin + 2 :] if line.strip()][:frames]
        table = numbers(rows, sum(len(j.channels) for j in joints))
        points = _positions(joints, table) * unit
    except (ValueError, IndexError, KeyError) as error:
        raise FileError(notice("reference.not_readable", file=path, why=str(error))) from error
    names = tuple(j.name for j in joints)
    return Recording("BVH", names, step * np.arange(len(table), dtype=float), points).checked(path)


def _hierarchy(lines: list[str]) -> tuple[list[_Joint], int]:
    """Joints, parents first, and the number of the line with the count of frames."""
    joints: list[_Joint] = []
    open_joints: list[int] = [-1]
    pending = -1
    for n, line in enumerate(lines):
        words = line.split()
        if not words or words[0] == "HIERARCHY":
            continue
        if words[0] in ("ROOT", "JOINT", "End"):
            parent = open_joints[-1]
            name = " ".join(words[1:]) if words[0] != "End" else f"{joints[parent].name} end"
            joints.append(_Joint(name, parent))
            pending = len(joints) - 1
        elif words[0] == "{":
            open_joints.append(pending)
            if len(open_joints) > _DEEPEST:
                raise ValueError("its joints are nested too deep")
        elif words[0] == "}":
            open_joints.pop()
        elif words[0] == "OFFSET":
            joints[open_joints[-1]].offset = np.array([float(w) for w in words[1:4]])
        elif words[0] == "CHANNELS":
            joints[open_joints[-1]].channels = words[2 : 2 + int(words[1])]
        elif words[0] == "MOTION":
            return joints, next(i for i in range(n, len(lines)) if "Frames:" in lines[i])
    raise ValueError("it contains no motion")


def _positions(joints: list[_Joint], table: Array) -> Array:
    """(N, J, 3) in the file's unit."""
    n, column = len(table), 0
    p, R = np.zeros((n, len(joints), 3)), np.zeros((n, len(joints), 3, 3))
    for i, joint in enumerate(joints):
        values = table[:, column : column + len(joint.channels)]
        column += len(joint.channels)
        local_p, local_R = _local(joint, values)
        if joint.parent < 0:
            p[:, i], R[:, i] = local_p, local_R
        else:
            a = joint.parent
            p[:, i] = p[:, a] + np.einsum("nij,nj->ni", R[:, a], local_p)
            R[:, i] = R[:, a] @ local_R
    return p


def _local(joint: _Joint, values: Array) -> tuple[Array, Array]:
    """Translation (N, 3), which replaces the offset where the file has one, and rotation."""
    n = len(values)
    p = np.tile(joint.offset, (n, 1))
    turns: list[str] = []
    degrees: list[Array] = []
    for k, channel in enumerate(joint.channels):
        axis, what = channel[0].upper(), channel[1:].lower()
        if what == "position":
            p[:, "XYZ".index(axis)] = values[:, k]
        elif what == "rotation":
            turns.append(axis)
            degrees.append(values[:, k])
        else:
            raise ValueError(f"{channel} is not a channel")
    R = np.tile(np.eye(3), (n, 1, 1))
    for axis, angle in zip(turns, degrees, strict=True):
        known = np.nan_to_num(angle)[:, None]
        R = R @ Rotation.from_euler(axis, known, degrees=True).as_matrix()
    return p, R
