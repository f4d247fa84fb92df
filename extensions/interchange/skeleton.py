"""The tracked hand as a tree of keypoints for BVH and glTF."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.hand.names import CHAINS
from tracker.messages import Array
from tracker.session.export.series import EstimateSeries
from tracker.session.holes import gaps

ROOT = "wrist"
STIFF = 1e-5
"""m: smaller changes of a bone's offset are ignored; the sum over five bones is below 0.1 mm."""
_DIGITS = {
    d: ("cmc", "mcp", "ip", "tip") if d == "thumb" else ("mcp", "pip", "dip", "tip") for d in CHAINS
}


@dataclass(frozen=True, eq=False)
class Skeleton:
    """N instants of n nodes, parents first; lost values repeat the last known ones.

    offset (n, 3) m in the parent's axes, the median; translation (N, n, 3) m, of the root in the
    world, of other nodes the offset at each instant; rotation (N, n, 4) xyzw relative to the
    parent; ``stretches`` (n,) whether the offset changes with the calibration; known (N, n).
    """

    names: tuple[str, ...]
    parent: tuple[int, ...]
    offset: Array
    translation: Array
    rotation: Array
    stretches: NDArray[np.bool_]
    known: NDArray[np.bool_]

    def children(self, i: int) -> list[int]:
        return [k for k, p in enumerate(self.parent) if p == i]

    def notes(self, t: Array) -> dict[str, object]:
        """For the JSON file: number of repeated values, and their periods in ``t`` (N,) s."""
        lost = {n: gaps(t, self.known[:, i]) for i, n in enumerate(self.names)}
        return {
            "held": int((~self.known).sum()),
            "holes_s": {
                n: [[round(v, 6) for v in g] for g in found] for n, found in lost.items() if found
            },
        }


def skeleton(m: EstimateSeries) -> Skeleton:
    """The tree of a series. Raises FileError if a keypoint is never known."""
    names, parent = bone_tree(m.keypoint_names)
    columns = [m.keypoint_names.index(n) for n in names]
    p, q = m.keypoints[:, columns], m.q[:, columns]
    known = np.asarray(np.isfinite(np.concatenate([p, q], axis=2)).all(axis=2))
    R = Rotation.from_quat(_held(q, names).reshape(-1, 4)).as_matrix().reshape(*q.shape[:2], 3, 3)
    translation, rotation = np.empty_like(p), np.empty_like(q)
    for i, a in enumerate(parent):
        local = R[:, i] if a < 0 else np.swapaxes(R[:, a], 1, 2) @ R[:, i]
        rotation[:, i] = Rotation.from_matrix(local).as_quat()
        translation[:, i] = (
            p[:, i] if a < 0 else np.einsum("nji,nj->ni", R[:, a], p[:, i] - p[:, a])
        )
        translation[~known[:, i] | ~known[:, max(a, 0)], i] = np.nan
    if not np.isfinite(translation).all(axis=2).any(axis=0).all():
        raise FileError(notice("skeleton.bone_unseen"))
    offset = np.nanmedian(translation, axis=0)
    stretches = np.nanmax(np.abs(translation - offset), axis=(0, 2)) > STIFF
    return Skeleton(names, parent, offset, _held(translation, names), rotation, stretches, known)


def bone_tree(present: tuple[str, ...]) -> tuple[tuple[str, ...], tuple[int, ...]]:
    """Keypoints of the skeleton and the row of each one's parent."""
    if ROOT not in present:
        raise FileError(notice("skeleton.needs_wrist"))
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
    """(N, n, d): lost rows replaced by the last known ones, at the start by the first known
    ones."""
    out = values.copy()
    for k in range(values.shape[1]):
        known = np.asarray(np.isfinite(values[:, k]).all(axis=1))
        if not known.any():
            raise FileError(notice("skeleton.untracked", keypoint=names[k]))
        last = np.maximum.accumulate(np.where(known, np.arange(len(known)), -1))
        out[:, k] = values[np.where(last < 0, np.argmax(known), last), k]
    return out
