"""A closed mesh where a sampled field is zero.

Surface nets (S. Gibson, "Constrained elastic surface nets", 1998): a point in each cell of the
lattice that the surface passes through, a quad across each edge of it that changes sign.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array, IntArray

BoolArray = NDArray[np.bool_]

_CORNERS = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
_EDGES = [
    (a, b) for a in range(8) for b in range(a) if np.abs(_CORNERS[a] - _CORNERS[b]).sum() == 1
]


def surface_net(values: Array, origin: Array, step: float) -> tuple[Array, IntArray]:
    """Points (V, 3) m and triangles (F, 3), counter-clockwise seen from outside, of a field.

    values (X, Y, Z) on a lattice from ``origin`` (3,) ``step`` m apart; less than 0 inside, and
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
    """Whether each edge of the triangles (F, 3) lies between two, which run along it in opposite
    ways."""
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    many = int(faces.max()) + 1
    there, back = ends[:, 0] * many + ends[:, 1], ends[:, 1] * many + ends[:, 0]
    there.sort()
    back.sort()
    return bool((np.diff(there) > 0).all() and np.array_equal(there, back))


def _cell_points(values: Array, inside: BoolArray) -> tuple[IntArray, Array]:
    """Cells (C, 3) that the surface passes through, and the mean (C, 3) of where it crosses their
    edges, in steps of the lattice."""
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
    leaves = first[tuple(rows.T)]  # inside before, outside after: the face looks along the axis
    i, j, k = rows.T
    ring = np.stack([cell[i, j - 1, k - 1], cell[i, j, k - 1], cell[i, j, k], cell[i, j - 1, k]])
    # moving one axis to the front keeps x, y, z in order up to a turn, but for y
    flip = leaves if axis != 1 else ~leaves
    quad = np.where(flip, ring, ring[::-1]).T
    return np.concatenate([quad[:, [0, 1, 2]], quad[:, [0, 2, 3]]])
