"""Optimal assignment with a cost for unmatched rows (the Hungarian method, compiled)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntVector, Matrix, Vector, Written


class _Prices(NamedTuple):
    """Dual variables that reduce the costs: u (n,) of rows, v (m + n,) of columns."""

    u: Written[Vector]
    v: Written[Vector]


class _Paths(NamedTuple):
    """Shortest paths to all columns (m + n,): their cost, the preceding column (-1: none), and
    whether a column is final."""

    distance: Written[Vector]
    previous: Written[IntVector]
    done: BoolVector


@kernel
def assign(cost: Matrix, alone: float) -> IntVector:
    """(m,) row of cost (n, m) for each column, -1 for none, with the minimum total cost.

    A row without a column costs ``alone``, as if it had a column of its own: rows are added one at
    a time along shortest augmenting paths in reduced costs (Jonker and Volgenant 1987,
    doi:10.1007/BF02278710). Column m + i represents an unmatched row i.
    """
    n, m = cost.shape
    row_of = np.full(m + n, -1, np.int64)
    prices = _Prices(np.zeros(n), np.zeros(m + n))
    paths = _Paths(np.empty(m + n), np.empty(m + n, np.int64), np.empty(m + n, np.bool_))
    for first in range(n):
        paths.distance[:] = np.inf
        paths.done[:] = False
        row, reached, at = first, 0.0, -1
        while True:
            at = _relax(cost, alone, prices, paths, row, reached, at)
            reached = paths.distance[at]
            paths.done[at] = True
            if row_of[at] < 0:
                break
            row = row_of[at]
        _reprice(first, reached, row_of, prices, paths)
        while at >= 0:  # reassign the columns along the path
            before = paths.previous[at]
            row_of[at] = first if before < 0 else row_of[before]
            at = before
    return row_of[:m]


@kernel
def _relax(
    cost: Matrix,
    alone: float,
    prices: _Prices,
    paths: _Paths,
    row: int,
    reached: float,
    came_by: int,
) -> int:
    """Shorten the paths to all columns through ``row``; returns the nearest column not yet
    final."""
    m, u, v = cost.shape[1], prices.u, prices.v
    distance, previous, done = paths.distance, paths.previous, paths.done
    nearest, least = -1, np.inf
    for j in range(len(distance)):
        if done[j]:
            continue
        if j < m or j == m + row:
            way = reached + (cost[row, j] if j < m else alone) - u[row] - v[j]
            if way < distance[j]:
                distance[j], previous[j] = way, came_by
        if distance[j] < least:
            nearest, least = j, distance[j]
    return nearest


@kernel
def _reprice(first: int, reached: float, row_of: IntVector, prices: _Prices, paths: _Paths) -> None:
    """Dual variables for which the shortest path costs 0 and no pair has a negative cost."""
    u, v, distance, done = prices.u, prices.v, paths.distance, paths.done
    u[first] += reached
    for j in range(len(v)):
        if done[j]:
            v[j] += distance[j] - reached
            if row_of[j] >= 0:
                u[row_of[j]] += reached - distance[j]
