"""Cache of hand meshes at the size of the hand file; generating one takes a second."""

from __future__ import annotations

import hashlib
import threading
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from tracker.glove.model import GloveModel, Marker
from tracker.hand.model import HandModel
from tracker.hand.skin.mesh import Skin, SkinMaker
from tracker.messages import Array, IntArray

PROUD = 0.0004  # m by which a patch is above the skin
RINGS = (0.45, 0.7, 0.8, 1.0)  # relative to a patch's half size
SPOKES = 16
KEPT = 6  # meshes, of 0.6 MB each


@dataclass(frozen=True, eq=False)
class MadeSkin:
    """A hand's mesh, the patches of the glove on it, and the ring (F,) of each face of the
    patches."""

    skin: Skin
    patches: Skin
    ring: IntArray


class MadeSkins:
    """The newest few meshes by hand and glove; thread-safe."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._made: dict[bytes, MadeSkin] = {}

    def has(self, hand: HandModel, glove: GloveModel) -> bool:
        """Whether `get` returns immediately."""
        return _key(hand, glove) in self._made

    def get(self, hand: HandModel, glove: GloveModel) -> MadeSkin:
        """The mesh, generated if necessary; concurrent calls wait for it."""
        key = _key(hand, glove)
        made = self._made.get(key)
        if made is not None:
            return made
        with self._lock:
            made = self._made.get(key) or _make(hand, glove)
            self._made[key] = made
            while len(self._made) > KEPT:
                del self._made[next(iter(self._made))]
        return made


MADE = MadeSkins()


@lru_cache(maxsize=2 * KEPT)
def _key(hand: HandModel, glove: GloveModel) -> bytes:
    """A key of all numbers in both, rounded to eight digits; computed once per pair of objects."""
    return hashlib.sha256(repr((hand, glove)).encode()).digest()


def _make(hand: HandModel, glove: GloveModel) -> MadeSkin:
    maker = SkinMaker(hand, (glove.marker_segment(hand), glove.marker_position))
    return MadeSkin(maker.skin(), *_patches(maker, hand, glove))


PATCH_POINTS = 1 + len(RINGS) * SPOKES
PATCH_FACES = SPOKES * (2 * len(RINGS) - 1)


def _patches(maker: SkinMaker, hand: HandModel, glove: GloveModel) -> tuple[Skin, IntArray]:
    """All patches in one mesh, and the outer ring (F,) of each face."""
    faces, ring = _patch_faces()
    points = [_patch_points(maker, hand, m) for m in glove.markers]
    every = [faces + PATCH_POINTS * k for k in range(len(points))]
    empty = np.empty((0, 3))
    skin = maker.patch(
        np.concatenate([empty, *points]), np.concatenate([empty, *every]).astype(np.int64), PROUD
    )
    return skin, np.tile(ring, len(points))


def _patch_points(maker: SkinMaker, hand: HandModel, marker: Marker) -> Array:
    """(`PATCH_POINTS`, 3) m around a marker, in its tangential plane, in the bind pose."""
    other = np.eye(3)[np.abs(marker.normal).argmin()]
    a = np.cross(marker.normal, other)
    a /= np.linalg.norm(a)
    b = np.cross(marker.normal, a)
    angle = 2 * np.pi * (np.arange(SPOKES) + 0.5) / SPOKES
    around = np.cos(angle)[:, None] * a + np.sin(angle)[:, None] * b
    if marker.shape == "square":
        around /= np.maximum(np.abs(np.cos(angle)), np.abs(np.sin(angle)))[:, None]
    rings = [np.zeros((1, 3)), *(0.5 * marker.size * share * around for share in RINGS)]
    segment = np.full(PATCH_POINTS, hand.index[marker.segment])
    return maker.in_bind_pose(segment, marker.position + np.concatenate(rings))


def _patch_faces() -> tuple[IntArray, IntArray]:
    """(F, 3) triangles of a patch, counter-clockwise about its normal; (F,) the ring of each."""
    here = np.arange(SPOKES)
    after = (here + 1) % SPOKES
    faces = [np.stack([0 * here, 1 + here, 1 + after], axis=1)]
    rings = [np.zeros(SPOKES)]
    for k in range(1, len(RINGS)):
        inner, outer = 1 + (k - 1) * SPOKES, 1 + k * SPOKES
        faces += [
            np.stack([inner + here, outer + here, outer + after], axis=1),
            np.stack([inner + here, outer + after, inner + after], axis=1),
        ]
        rings.append(np.full(2 * SPOKES, k))
    return np.concatenate(faces), np.concatenate(rings).astype(np.int64)
