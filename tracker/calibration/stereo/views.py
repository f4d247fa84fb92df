"""The board in one image, in both images of an exposure, or in that of a single camera."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import Notice, warning
from tracker.calibration.stereo.board import BoardSpec
from tracker.messages import Array, IntArray

LEAST_CORNERS = 12
"""Fewer corners do not determine a pose well enough."""
Image = NDArray[np.uint8]
Size = tuple[int, int]
"""Width and height of an image, px."""


@dataclass(frozen=True, eq=False)
class Corners:
    """Inner corners found in one image: ids (n,) in ascending order, uv (n, 2) px."""

    ids: IntArray
    uv: Array

    def __len__(self) -> int:
        return len(self.ids)


@dataclass(frozen=True, eq=False)
class StereoView:
    """Corners found in all images: ids (n,), points (n, 3) m on the board, uv (n, 2) px each.

    ``right`` is None for a single camera.
    """

    ids: IntArray
    points: Array
    left: Array
    right: Array | None

    @property
    def sides(self) -> tuple[Array, ...]:
        """uv (n, 2) px of each image."""
        return (self.left,) if self.right is None else (self.left, self.right)


@dataclass(frozen=True, eq=False)
class BoardLook:
    """The result for one exposure. ``view`` is None if it cannot be used, and ``problem`` the
    reason."""

    left: Corners | None
    right: Corners | None
    view: StereoView | None
    problem: Notice | None = None


class BoardFinder:
    """Finds a board's corners."""

    def __init__(self, spec: BoardSpec) -> None:
        self.spec = spec
        self._charuco = cv2.aruco.CharucoDetector(spec.charuco) if spec.kind == "charuco" else None

    def look(self, left: Image, right: Image | None = None) -> BoardLook:
        """Searches both images of an exposure, BGR or grey, or that of a single camera."""
        if right is None:
            return self._look_alone(_grey(left))
        pair = [_grey(p) for p in (left, right)]
        found = [self.find(grey) for grey in pair]
        for side, corners, grey in zip(("left", "right"), found, pair, strict=True):
            if corners is None:
                return BoardLook(found[0], found[1], None, self._absence(side, grey))
        assert found[0] is not None and found[1] is not None
        view = self._common(found[0], found[1])
        if len(view.ids) < LEAST_CORNERS:
            return BoardLook(found[0], found[1], None, warning("board.parts_differ"))
        return BoardLook(found[0], found[1], view)

    def _look_alone(self, grey: Image) -> BoardLook:
        found = self.find(grey)
        if found is None:
            return BoardLook(None, None, None, self._absence("", grey))
        view = StereoView(found.ids, self.spec.points_of(found.ids), found.uv, None)
        return BoardLook(found, None, view)

    def find(self, image: Image) -> Corners | None:
        """The board's corners in one image; None unless they are clearly visible."""
        grey = _grey(image)
        return self._find_charuco(grey) if self._charuco is not None else self._find_chess(grey)

    def _find_charuco(self, grey: Image) -> Corners | None:
        assert self._charuco is not None
        uv, ids, _, _ = self._charuco.detectBoard(grey)
        if ids is None or len(ids) < LEAST_CORNERS:
            return None
        ids, uv = ids.reshape(-1).astype(np.int64), uv.reshape(-1, 2).astype(float)
        order = np.argsort(ids)
        return Corners(ids[order], uv[order])

    def _find_chess(self, grey: Image) -> Corners | None:
        size = (self.spec.corner_columns, self.spec.corner_rows)
        # Most images of a waving hand do not show a whole board: this test detects that ten times
        # faster.
        if not cv2.checkChessboard(grey, size):
            return None
        found, uv = cv2.findChessboardCornersSB(grey, size, flags=cv2.CALIB_CB_NORMALIZE_IMAGE)
        if not found:
            return None
        grid = uv.reshape(self.spec.corner_rows, self.spec.corner_columns, 2).astype(float)
        grid = _upright(grid, grey)
        return Corners(np.arange(self.spec.corner_count), grid.reshape(-1, 2))

    def _absence(self, side: str, grey: Image) -> Notice:
        if self._charuco is not None and self.find(np.ascontiguousarray(grey[:, ::-1])):
            return warning("board.mirrored_side", side=side) if side else warning("board.mirrored")
        if self._charuco is not None:
            return warning("board.not_seen_side", side=side) if side else warning("board.not_seen")
        return warning("board.not_whole_side", side=side) if side else warning("board.not_whole")

    def _common(self, left: Corners, right: Corners) -> StereoView:
        ids, i, j = np.intersect1d(left.ids, right.ids, return_indices=True)
        return StereoView(ids, self.spec.points_of(ids), left.uv[i], right.uv[j])


def sizes_of(images: Iterable[Image | None]) -> tuple[Size, ...]:
    """The sizes of the images that exist."""
    return tuple((image.shape[1], image.shape[0]) for image in images if image is not None)


def _upright(grid: Array, grey: Image) -> Array:
    """The corner grid (rows, columns, 2) in the board's own order.

    OpenCV may start at either end of the board. x must go to the right of y, and the square to the
    lower right of the first corner is black.
    """
    right, down = grid[0, -1] - grid[0, 0], grid[-1, 0] - grid[0, 0]
    if right[0] * down[1] - right[1] * down[0] < 0:
        grid = grid[:, ::-1]
    centres = (grid[:-1, :-1] + grid[1:, :-1] + grid[:-1, 1:] + grid[1:, 1:]) / 4
    u, v = np.round(centres).astype(int).reshape(-1, 2).T
    inside = grey[np.clip(v, 0, grey.shape[0] - 1), np.clip(u, 0, grey.shape[1] - 1)]
    row, column = np.indices(centres.shape[:2])
    black = (row + column).ravel() % 2 == 0
    if inside[black].mean() > inside[~black].mean():
        grid = grid[::-1, ::-1]
    return grid


def _grey(image: Image) -> Image:
    if image.ndim == 2:
        return image
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), np.uint8)
