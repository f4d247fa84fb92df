"""The mesh of a hand's surface, built from the hand file.

Surface nets (S. Gibson, "Constrained elastic surface nets", 1998) create a closed mesh where a
sampled field is zero: a vertex in each cell of the lattice that the surface crosses, a quad across
each edge on which the sign changes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS
from tracker.hand.skin.field import BlendedSurface, finger_distances, palm_distance
from tracker.hand.skin.form import FABRIC, HandForm, hand_form
from tracker.messages import Array, IntArray

MOST = 4
"""Number of segments that one vertex follows."""
BEND = 0.85  # radii on either side of a joint over which the skin bends
BEND_THUMB = 1.3  # likewise for the thumb's root, which lies deep in the palm
BETWEEN = 0.0025  # m of difference in distance over which two fingers share a vertex
BESIDE = 0.006  # likewise between thumb and palm


def bone_weights(hand: HandModel, form: HandForm, x: Array) -> tuple[IntArray, Array]:
    """Segments (P, `MOST`) and weights (P, `MOST`), which sum to 1, of points x (P, 3)."""
    dense = _dense(hand, form, x)
    bones = np.argsort(-dense, axis=1, kind="stable")[:, :MOST]
    share = np.take_along_axis(dense, bones, axis=1)
    share[share < 1e-3] = 0.0
    return bones, share / share.sum(axis=1, keepdims=True)


def _dense(hand: HandModel, form: HandForm, x: Array) -> Array:
    """(P, S) weight of each segment."""
    out = np.zeros((len(x), len(hand.segments)))
    palm, near = palm_distance(form, x), finger_distances(form, x)
    if near:
        belongs = _shares(np.array(list(near.values())))
        for name, share in zip(near, belongs, strict=True):
            if name == "thumb":
                share = share * _step((palm - near[name]) / BESIDE)
            _hand_out(hand, form, name, share, x, out)
    out[:, hand.root] += np.maximum(1.0 - out.sum(axis=1), 0.0)
    return out


def _shares(distances: Array) -> Array:
    """(F, P) weight of each finger for each point, from distances (F, P) m."""
    nearer = np.clip(1.0 - (distances - distances.min(axis=0)) / BETWEEN, 0.0, 1.0) ** 2
    return np.asarray(nearer / nearer.sum(axis=0))


def _hand_out(
    hand: HandModel, form: HandForm, finger: str, left: Array, x: Array, out: Array
) -> None:
    """Distribute a finger's weight (P,) for each point to its segments, from the palm to the
    tip."""
    chain = [hand.index[s] for s in CHAINS[finger] if s in hand.index]
    for k, i in enumerate(chain):
        radius = hand.segments[i].radius + FABRIC
        width = radius * (BEND_THUMB if finger == "thumb" and k == 0 else BEND)
        beyond = left * _step((x - form.p[i]) @ form.R[i, :, 0] / width)
        if k > 0:
            out[:, chain[k - 1]] += left - beyond
        left = beyond
    out[:, chain[-1]] += left


def _step(x: Array) -> Array:
    """From 0 at -1 to 1 at 1, with zero slope at both ends."""
    t = np.clip(0.5 + 0.5 * x, 0.0, 1.0)
    return np.asarray(t * t * (3 - 2 * t))


BoolArray = NDArray[np.bool_]

_CORNERS = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
_EDGES = [
    (a, b) for a in range(8) for b in range(a) if np.abs(_CORNERS[a] - _CORNERS[b]).sum() == 1
]


def surface_net(values: Array, origin: Array, step: float) -> tuple[Array, IntArray]:
    """Vertices (V, 3) m and triangles (F, 3), counter-clockwise seen from outside, of a field.

    values (X, Y, Z) on a lattice from ``origin`` (3,) with spacing ``step`` m; negative inside, and
    nowhere on the lattice's border.
    """
    inside = values < 0
    cells = _cell_points(values, inside)
    number = np.full(inside.shape, -1, np.int64)
    rows = np.array(list(cells[0]))
    number[tuple(rows.T)] = np.arange(len(rows))
    faces = [_faces(inside, number, axis) for axis in range(3)]
    return origin + step * cells[1], np.concatenate(faces)


def is_closed(faces: IntArray) -> bool:
    """Whether each edge of the triangles (F, 3) is shared by two, which traverse it in opposite
    directions."""
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    many = int(faces.max()) + 1
    there, back = ends[:, 0] * many + ends[:, 1], ends[:, 1] * many + ends[:, 0]
    there.sort()
    back.sort()
    return bool((np.diff(there) > 0).all() and np.array_equal(there, back))


def _cell_points(values: Array, inside: BoolArray) -> tuple[IntArray, Array]:
    """Cells (C, 3) that the surface intersects, and the mean (C, 3) of its intersections with their
    edges, in lattice steps."""
    shape = tuple(n - 1 for n in values.shape)
    count, total = np.zeros(shape), np.zeros((*shape, 3))
    for a, b in _EDGES:
        va, vb = _corner(values, a, shape), _corner(values, b, shape)
        crosses = _corner(inside, a, shape) != _corner(inside, b, shape)
        t = va[crosses] / (va[crosses] - vb[crosses])
        total[crosses] += _CORNERS[a] + t[:, None] * (_CORNERS[b] - _CORNERS[a])
        count += crosses
    rows = np.argwhere(count > 0)
    at = tuple(rows.T)
    return rows, rows + total[at] / count[at][:, None]


def _corner(values: NDArray[Any], corner: int, shape: tuple[int, ...]) -> NDArray[Any]:
    i, j, k = _CORNERS[corner]
    return values[i : i + shape[0], j : j + shape[1], k : k + shape[2]]


def _faces(inside: BoolArray, number: IntArray, axis: int) -> IntArray:
    """Two triangles for each edge along ``axis`` that changes sign, between its four cells."""
    first = np.moveaxis(inside, axis, 0)
    cell = np.moveaxis(number, axis, 0)
    rows = np.argwhere(first[:-1] != first[1:])
    leaves = first[tuple(rows.T)]  # from inside to outside: the face points along the axis
    i, j, k = rows.T
    ring = np.stack([cell[i, j - 1, k - 1], cell[i, j, k - 1], cell[i, j, k], cell[i, j - 1, k]])
    # moving one axis to the front permutes x, y, z cyclically, except for y
    flip = leaves if axis != 1 else ~leaves
    quad = np.where(flip, ring, ring[::-1]).T
    return np.concatenate([quad[:, [0, 1, 2]], quad[:, [0, 2, 3]]])


CELL = 0.0036
"""m of the lattice: on the thinnest finger a facet deviates by 0.25 mm, half a pixel."""
LATTICES = 8  # with different cells, tried for a closed mesh
COARSE = 4
"""Cells along a side of the blocks that are tested first."""
CLOSE = 1.4
"""Sides of a block: if its centre is farther than this from the surface, it contains no part of it.
Half its diagonal is 0.87; an oval's distance is up to 1.35 times too large."""


@dataclass(frozen=True, eq=False)
class Skin:
    """Vertices that follow a hand's segments, and the triangles between them.

    points, normals (V, 3) m in the root's B in the bind pose; faces (F, 3), counter-clockwise seen
    from outside; bones (V, 4) rows of segments with weights shares (V, 4); along (V,) m from the
    wrist along the finger; arm (V,) m behind the wrist; bind_R (S, 3, 3), bind_p (S, 3) the
    segments' poses in the root.
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
    """Creates the skin of one hand, and patches on it.

    ``fixed``: rows of segments (M,) and points (M, 3) m in their B that the surface passes through,
    such as a glove's markers; their distance from it is then below 0.5 mm.
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
        """The complete, closed surface.

        Where two sheets cross one cell, their vertices merge; a different lattice spacing avoids
        that.
        """
        for k in range(LATTICES):
            points, faces = self._net(cell * (1.0 - 0.03 * k))
            if is_closed(faces) and 2 * len(points) == len(faces) + 4:  # Euler: a sphere
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
        """Distance in the middle of each block of `COARSE` cells per side, repeated for its
        points."""
        axes = [low[k] + cell * (COARSE * np.arange(count[k]) + 0.5 * COARSE) for k in range(3)]
        blocks = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
        out = self._surface.distance(blocks.reshape(-1, 3)).reshape(blocks.shape[:3])
        for k in range(3):
            out = np.repeat(out, COARSE, axis=k)
        return np.asarray(out)

    def patch(self, points: Array, faces: IntArray, proud: float) -> Skin:
        """Vertices (V, 3) m near the surface, in the bind pose, placed ``proud`` m above it."""
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
    """Corners of a box that contains all cones."""
    every = [*form.fingers.values(), form.palm, form.thenar, form.forearm]
    ends = [(end, cones.radius.max(axis=1)) for cones in every for end in (cones.a, cones.b)]
    low = np.concatenate([end - r[:, None] for end, r in ends]).min(axis=0)
    high = np.concatenate([end + r[:, None] for end, r in ends]).max(axis=0)
    low[0] = form.forearm.b[:, 0].min()
    return low, high


def _along(hand: HandModel, form: HandForm, points: Array, bone: IntArray) -> Array:
    """(V,) m along x of the root, continued on a finger along its segments."""
    start = np.zeros(len(hand.segments))
    for chain in CHAINS.values():
        rows = [hand.index[s] for s in chain if s in hand.index]
        for k, i in enumerate(rows):
            before = rows[k - 1]
            start[i] = start[before] + hand.segments[before].length if k else form.p[i][0]
    local = np.einsum("vi,vi->v", points - form.p[bone], form.R[bone][:, :, 0])
    return np.asarray(start[bone] + local)
