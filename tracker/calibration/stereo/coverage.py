"""The parts of the images, tilts and distances covered by the views, and what is missing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracker.base.notices import Notice, notice
from tracker.calibration.stereo.views import Size, StereoView
from tracker.messages import Array, IntArray

GRID = (4, 6)
"""Rows and columns of the coverage map."""


@dataclass(frozen=True)
class CoverageParams:
    """Requirements on a set of views; shares are of the cells of all images."""

    views: int = 15
    area: float = 0.7
    tilted: int = 6
    tilt_deg: float = 18.0
    distances: float = 1.3  # ratio of largest to smallest


@dataclass(frozen=True, eq=False)
class Coverage:
    """``maps`` (rows, columns), of each camera: number of views with corners in each cell.

    ``area`` share of cells with any; ``tilted`` number of tilted views, ``distances`` ratio of the
    farthest to the nearest.
    """

    views: int
    maps: tuple[IntArray, ...]
    area: float
    tilted: int
    distances: float


def coverage(
    views: Sequence[StereoView], sizes: Sequence[Size], params: CoverageParams | None = None
) -> Coverage:
    """For views in images of these sizes, of each camera."""
    p = params or CoverageParams()
    maps = tuple(
        sum((_cells(v.sides[k], *size) for v in views), np.zeros(GRID, np.int64))
        for k, size in enumerate(sizes)
    )
    shapes = [shape_of(v) for v in views]
    scales = [s.size_px for s in shapes]
    return Coverage(
        views=len(views),
        maps=maps,
        area=float(np.mean(np.stack(maps) > 0)),
        tilted=sum(s.tilt >= np.deg2rad(p.tilt_deg) for s in shapes),
        distances=max(scales) / min(scales) if scales else 1.0,
    )


def advice(cover: Coverage, params: CoverageParams | None = None) -> Notice | None:
    """How to hold the board next; None when the views are complete."""
    p = params or CoverageParams()
    if cover.area < p.area:
        return notice("stereo.cover_empty", regions=_emptiest(cover))
    if cover.tilted < p.tilted:
        return notice("stereo.cover_tilt")
    if cover.distances < p.distances:
        return notice("stereo.cover_distance")
    if cover.views < p.views:
        return notice("stereo.cover_more")
    return None


@dataclass(frozen=True)
class Shape:
    """The affine map of a view: its size (px per m of board) and tilt (rad, ≥ 0)."""

    size_px: float
    tilt: float


def shape_of(view: StereoView) -> Shape:
    """From the foreshortening in the left image: independent of the lens."""
    s = np.linalg.svd(_affine(view.points[:, :2], view.left)[:2], compute_uv=False)
    return Shape(float(s[0]), float(np.arccos(min(1.0, s[1] / s[0]))))


def novelty(view: StereoView, other: StereoView, width: int) -> float:
    """0 for the same view; 1 for one that is sufficiently different.

    A shift by 8 % of the image's width, or a change of size or shape by 15 %, is sufficient.
    """
    a, b = (_affine(v.points[:, :2], v.left) for v in (view, other))
    centre = np.append(view.points[:, :2].mean(axis=0), 1.0)
    shift = float(np.linalg.norm(centre @ a - centre @ b)) / (0.08 * width)
    change = np.linalg.norm(a[:2] @ np.linalg.pinv(b[:2]) - np.eye(2)) / (0.15 * np.sqrt(2))
    return shift + float(change)


def _affine(points: Array, uv: Array) -> Array:
    """(3, 2) least-squares matrix A with [x y 1] @ A = pixel."""
    design = np.column_stack([points, np.ones(len(points))])
    solution, *_ = np.linalg.lstsq(design, uv, rcond=None)
    return np.asarray(solution, float)


def _cells(uv: Array, width: int, height: int) -> IntArray:
    """1 in each cell of the grid that contains a corner."""
    row = np.clip(uv[:, 1] / height * GRID[0], 0, GRID[0] - 1).astype(int)
    column = np.clip(uv[:, 0] / width * GRID[1], 0, GRID[1] - 1).astype(int)
    cells = np.zeros(GRID, np.int64)
    cells[row, column] = 1
    return cells


def _emptiest(cover: Coverage) -> str:
    """Text for the ninth of the images with the fewest views."""
    both = np.sum([counts > 0 for counts in cover.maps], axis=0, dtype=float)
    rows = np.array_split(np.arange(GRID[0]), 3)
    columns = np.array_split(np.arange(GRID[1]), 3)
    filled = np.array([[both[np.ix_(r, c)].mean() for c in columns] for r in rows])
    i, j = np.unravel_index(int(np.argmin(filled)), filled.shape)
    if (i, j) == (1, 1):
        return "the middle"
    vertical, horizontal = ("top", "", "bottom")[i], ("left", "", "right")[j]
    return " ".join(w for w in (vertical, horizontal) if w)
