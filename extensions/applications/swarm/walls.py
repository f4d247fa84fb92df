"""Virtual walls drawn by a flat hand, as triangles."""

from __future__ import annotations

import numpy as np

from tracker.messages import Array

SPACING = 0.012  # m of movement between two edges of a wall
FLATTEST = 0.3  # sine between the hand's step and its length, below which it sweeps nothing
MOST = 400  # edges of all walls


class Walls:
    """Walls built edge by edge; an edge is the line from the wrist to the fingertips."""

    def __init__(self) -> None:
        self.strips: list[list[Array]] = []  # each: edges (2, 3) m
        self.triangles: Array = np.empty((0, 3, 3))
        self._drawing = False

    @property
    def edges(self) -> int:
        return sum(len(s) for s in self.strips)

    def sweep(self, edge: Array) -> None:
        """Add the hand's current edge (2, 3) m."""
        if not self._drawing:
            self.strips.append([edge])
            self._drawing = True
            return
        last = self.strips[-1][-1]
        step = edge.mean(axis=0) - last.mean(axis=0)
        length = float(np.linalg.norm(step))
        if length < SPACING or self.edges >= MOST:
            return
        along = last[1] - last[0]
        across = np.linalg.norm(np.cross(step, along)) / (length * np.linalg.norm(along))
        if across < FLATTEST:
            return
        self.strips[-1].append(edge)
        quad = np.array([[last[0], last[1], edge[1]], [last[0], edge[1], edge[0]]])
        self.triangles = np.concatenate([self.triangles, quad])

    def finish(self) -> float:
        """Finish the wall and return its area in m², 0 if there is none."""
        if not self._drawing:
            return 0.0
        self._drawing = False
        quads = len(self.strips[-1]) - 1
        if quads == 0:
            self.strips.pop()
            return 0.0
        a, b, c = np.moveaxis(self.triangles[-2 * quads :], 1, 0)
        return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())

    def clear(self) -> None:
        """Remove all walls."""
        self.strips.clear()
        self.triangles = np.empty((0, 3, 3))
        self._drawing = False
