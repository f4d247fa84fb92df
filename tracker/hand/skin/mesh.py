"""The mesh of a hand's surface, made of its file."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS
from tracker.hand.skin.field import BlendedSurface
from tracker.hand.skin.form import HandForm, hand_form
from tracker.hand.skin.polygons import is_closed, surface_net
from tracker.hand.skin.weights import bone_weights
from tracker.messages import Array, IntArray

CELL = 0.0036
"""m of the lattice: on the thinnest finger a facet is then 0.25 mm from the round, half a pixel."""
LATTICES = 8  # of different cells that are tried for a closed mesh
COARSE = 4
"""Cells along a side of the blocks that are looked at first."""
CLOSE = 1.4
"""Sides of a block: what is farther from the surface than this in its middle is far all over. Half
its diagonal is 0.87; an oval's distance is up to 1.35 times too large."""


@dataclass(frozen=True, eq=False)
class Skin:
    """Points that follow a hand's segments, and the triangles between them.

    points, normals (V, 3) m in the root's B in the bind pose; faces (F, 3), counter-clockwise seen
    from outside; bones (V, 4) rows of segments with shares (V, 4); along (V,) m from the wrist
    along the finger; arm (V,) m behind the wrist; bind_R (S, 3, 3), bind_p (S, 3) the segments'
    poses in the root.
    """

    points: Array
    normals: Array
    faces: IntArray
    bones: IntArray
    shares: Array
    along: Array
    bind_R: Array
    bind_p: Array

    @property
    def arm(self) -> Array:
        """(V,) m behind the wrist; 0 on the hand."""
        return np.maximum(-self.points[:, 0], 0.0)


class SkinMaker:
    """Makes the skin of one hand, and patches that lie on it.

    ``fixed``: rows of segments (M,) and points (M, 3) m in their B that the surface shall pass
    through, as a glove's markers do; their distance from it is then below 0.5 mm.
    """

    def __init__(self, hand: HandModel, fixed: tuple[IntArray, Array] | None = None) -> None:
        self._hand, self._form = hand, hand_form(hand)
        points = np.empty((0, 3)) if fixed is None else self.in_bind_pose(*fixed)
        self._surface = BlendedSurface(self._form, points)

    def in_bind_pose(self, segment: IntArray, points: Array) -> Array:
        """(M, 3) m in the root's B, of points (M, 3) in the B of segments (M,)."""
        R, p = self._form.R[segment], self._form.p[segment]
        return np.asarray(p + np.einsum("mij,mj->mi", R, points))

    def skin(self, cell: float = CELL) -> Skin:
        """The whole surface, closed.

        Two sheets that cross one cell get one point there; another lattice does not cut them so.
        """
        for k in range(LATTICES):
            points, faces = self._net(cell * (1.0 - 0.03 * k))
            if is_closed(faces) and 2 * len(points) == len(faces) + 4:  # as a ball's (Euler)
                break
        return self._clad(self._surface.project(points), faces)

    def _net(self, cell: float) -> tuple[Array, IntArray]:
        """Points (V, 3) near the surface and triangles (F, 3)."""
        low, high = _bounds(self._form)
        low = low - 2 * cell
        count = np.ceil((high - low) / (COARSE * cell)).astype(int) + 1
        near = self._near(low, count, cell)
        axes = [low[k] + cell * np.arange(COARSE * count[k]) for k in range(3)]
        lattice = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
        values = np.where(near < 0, -cell, cell)
        close = np.abs(near) < CLOSE * COARSE * cell
        values[close] = self._surface.distance(lattice[close])
        return surface_net(values, low, cell)

    def _near(self, low: Array, count: IntArray, cell: float) -> Array:
        """Distance in the middle of each block of `COARSE` cells a side, for each point in it."""
        axes = [low[k] + cell * (COARSE * np.arange(count[k]) + 0.5 * COARSE) for k in range(3)]
        blocks = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
        out = self._surface.distance(blocks.reshape(-1, 3)).reshape(blocks.shape[:3])
        for k in range(3):
            out = np.repeat(out, COARSE, axis=k)
        return np.asarray(out)

    def patch(self, points: Array, faces: IntArray, proud: float) -> Skin:
        """Points (V, 3) m near the surface, in the bind pose, laid ``proud`` m above it."""
        made = self._clad(self._surface.project(points), faces)
        return Skin(
            made.points + proud * made.normals, made.normals, faces, made.bones, made.shares,
            made.along, made.bind_R, made.bind_p,
        )  # fmt: skip

    def _clad(self, points: Array, faces: IntArray) -> Skin:
        normals = self._surface.gradient(points)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        bones, shares = bone_weights(self._hand, self._form, points)
        along = _along(self._hand, self._form, points, bones[:, 0])
        return Skin(points, normals, faces, bones, shares, along, self._form.R, self._form.p)


def _bounds(form: HandForm) -> tuple[Array, Array]:
    """Corners of a box that holds all cones."""
    every = [*form.fingers.values(), form.palm, form.thenar, form.forearm]
    ends = [(end, cones.radius.max(axis=1)) for cones in every for end in (cones.a, cones.b)]
    low = np.concatenate([end - r[:, None] for end, r in ends]).min(axis=0)
    high = np.concatenate([end + r[:, None] for end, r in ends]).max(axis=0)
    low[0] = form.forearm.b[:, 0].min()
    return low, high


def _along(hand: HandModel, form: HandForm, points: Array, bone: IntArray) -> Array:
    """(V,) m along x of the root, and on a finger along its segments, which goes on from there."""
    start = np.zeros(len(hand.segments))
    for chain in CHAINS.values():
        rows = [hand.index[s] for s in chain if s in hand.index]
        for k, i in enumerate(rows):
            before = rows[k - 1]
            start[i] = start[before] + hand.segments[before].length if k else form.p[i][0]
    local = np.einsum("vi,vi->v", points - form.p[bone], form.R[bone][:, :, 0])
    return np.asarray(start[bone] + local)
