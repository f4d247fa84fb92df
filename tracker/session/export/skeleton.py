"""The tracked hand as a tree of keypoints with bones of fixed length, for BVH and glTF."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.errors import FileError
from tracker.hand.names import CHAINS
from tracker.messages import Array
from tracker.session.export.series import EstimateSeries

ROOT = "wrist"
_DIGITS = {
    d: ("cmc", "mcp", "ip", "tip") if d == "thumb" else ("mcp", "pip", "dip", "tip") for d in CHAINS
}


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Nodes parents first. offset (n, 3) m in the parent's axes; rotation (N, n, 4) xyzw against
    the parent's; root (N, 3) m. ``held`` counts the numbers that were lost and repeat the last.
    """

    names: tuple[str, ...]
    parent: tuple[int, ...]
    offset: Array
    rotation: Array
    root: Array
    held: int

    def children(self, i: int) -> list[int]:
        return [k for k, p in enumerate(self.parent) if p == i]


def skeleton(m: EstimateSeries) -> Skeleton:
    """The tree of a motion. Raises FileError where a keypoint was never seen."""
    names, parent = bone_tree(m.keypoint_names)
    columns = [m.keypoint_names.index(n) for n in names]
    p, q = m.keypoints[:, columns], m.q[:, columns]
    held = int((~np.isfinite(p).all(axis=2) | ~np.isfinite(q).all(axis=2)).sum())
    R = Rotation.from_quat(_held(q, names).reshape(-1, 4)).as_matrix().reshape(*q.shape[:2], 3, 3)
    offset = np.zeros((len(names), 3))
    rotation = np.empty_like(q)
    for i, a in enumerate(parent):
        local = R[:, i] if a < 0 else np.swapaxes(R[:, a], 1, 2) @ R[:, i]
        rotation[:, i] = Rotation.from_matrix(local).as_quat()
        if a >= 0:
            # Bones do not stretch: the median is their length as calibrated.
            bone = np.einsum("nji,nj->ni", R[:, a], p[:, i] - p[:, a])
            offset[i] = np.nanmedian(bone, axis=0)
    if not np.isfinite(offset).all():
        raise FileError("A bone was never seen with both its ends, so there is no skeleton.")
    return Skeleton(names, parent, offset, rotation, _held(p[:, :1], names)[:, 0], held)


def bone_tree(present: tuple[str, ...]) -> tuple[tuple[str, ...], tuple[int, ...]]:
    """Keypoints of the skeleton and the row of each one's parent."""
    if ROOT not in present:
        raise FileError("A skeleton needs the wrist; export all joints.")
    names, parent = [ROOT], [-1]
    for digit, parts in _DIGITS.items():
        before = 0
        for part in parts:
            if f"{digit}_{part}" in present:
                names.append(f"{digit}_{part}")
                parent.append(before)
                before = len(names) - 1
    return tuple(names), tuple(parent)


def _held(values: Array, names: tuple[str, ...]) -> Array:
    """Lost rows replaced by the last known ones (N, n, d); the first known ones at the start."""
    out = values.copy()
    for k in range(values.shape[1]):
        known = np.asarray(np.isfinite(values[:, k]).all(axis=1))
        if not known.any():
            raise FileError(f"{names[k]} was never tracked, so there is no skeleton.")
        last = np.maximum.accumulate(np.where(known, np.arange(len(known)), -1))
        out[:, k] = values[np.where(last < 0, np.argmax(known), last), k]
    return out
