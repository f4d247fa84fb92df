"""The printed board: its image and the positions of its inner corners.

Inner corners are numbered row by row from the top left; x goes right and y down on the paper, as
OpenCV numbers them. Both kinds of board have a black square in the top left corner.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array, IntArray

KINDS = ("charuco", "chessboard")
DICTIONARY = cv2.aruco.DICT_5X5_250
MARKER_SHARE = 0.75
LEAST_SQUARES, MOST_SQUARES = 4, 20
LEAST_SQUARE, LARGEST_SQUARE = 0.004, 0.2  # m
RULER = 0.1  # m, printed below the board to check the printer's scale
MARGIN, FOOT = 0.010, 0.016  # m of white margin: the default board fits A4 and Letter


@dataclass(frozen=True)
class BoardSpec:
    """``columns`` and ``rows`` count squares, not inner corners; ``square`` is a side in m.

    Raises ConfigError for an unusable board.
    """

    kind: str = "charuco"
    columns: int = 10
    rows: int = 7
    square: float = 0.025

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ConfigError(notice("board.unknown_kind", kinds=KINDS, kind=self.kind))
        if not all(LEAST_SQUARES <= n <= MOST_SQUARES for n in (self.columns, self.rows)):
            raise ConfigError(
                notice(
                    "board.square_count",
                    least=LEAST_SQUARES,
                    most=MOST_SQUARES,
                    columns=self.columns,
                    rows=self.rows,
                )
            )
        if not LEAST_SQUARE <= self.square <= LARGEST_SQUARE:
            raise ConfigError(notice("board.square_size", square_mm=self.square * 1000))
        if self.kind == "chessboard" and (self.columns + self.rows) % 2 == 0:
            raise ConfigError(notice("board.symmetric", columns=self.columns, rows=self.rows))

    @property
    def corner_columns(self) -> int:
        return self.columns - 1

    @property
    def corner_rows(self) -> int:
        return self.rows - 1

    @property
    def corner_count(self) -> int:
        return self.corner_columns * self.corner_rows

    @property
    def width(self) -> float:
        """m"""
        return self.columns * self.square

    @property
    def height(self) -> float:
        """m"""
        return self.rows * self.square

    @cached_property
    def points(self) -> Array:
        """(corners, 3) m: all inner corners on the paper, z = 0."""
        x, y = np.meshgrid(
            np.arange(1, self.columns) * self.square, np.arange(1, self.rows) * self.square
        )
        return np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])

    def points_of(self, ids: IntArray) -> Array:
        """(n, 3) m."""
        return self.points[ids]

    @cached_property
    def charuco(self) -> cv2.aruco.CharucoBoard:
        """OpenCV's board object; only for a ChArUco board."""
        dictionary = cv2.aruco.getPredefinedDictionary(DICTIONARY)
        side = self.square * MARKER_SHARE
        return cv2.aruco.CharucoBoard((self.columns, self.rows), self.square, side, dictionary)


def board_image(spec: BoardSpec, square_px: int = 60) -> NDArray[np.uint8]:
    """(rows, columns) · square_px grey pixels of the board alone, without a margin."""
    if spec.kind == "charuco":
        size = (spec.columns * square_px, spec.rows * square_px)
        return np.asarray(spec.charuco.generateImage(size), np.uint8)
    row, column = np.indices((spec.rows, spec.columns))
    squares = np.where((row + column) % 2 == 0, 0, 255).astype(np.uint8)
    return np.kron(squares, np.ones((square_px, square_px), np.uint8))


def page_size(spec: BoardSpec) -> tuple[float, float]:
    """Width and height of the printed page, m."""
    return spec.width + 2 * MARGIN, spec.height + MARGIN + FOOT


def print_image(spec: BoardSpec, dpi: int = 300) -> tuple[NDArray[np.uint8], float]:
    """The page to print: the board, a white margin, a ruler of 100 mm below.

    Returns grey pixels and their number per metre; printed at that scale the squares have the size
    in ``spec``.
    """
    square_px = max(12, round(spec.square * dpi / 0.0254))
    per_metre = square_px / spec.square
    board = board_image(spec, square_px)
    margin, foot = round(MARGIN * per_metre), round(FOOT * per_metre)
    page = cv2.copyMakeBorder(board, margin, foot, margin, margin, cv2.BORDER_CONSTANT, value=255)
    _draw_ruler(page, margin, board.shape[0] + margin + round(0.6 * foot), per_metre)
    return np.asarray(page, np.uint8), per_metre


def _draw_ruler(page: NDArray[np.uint8], x: int, y: int, per_metre: float) -> None:
    end = x + round(RULER * per_metre)
    thick = max(2, round(0.0004 * per_metre))
    cv2.line(page, (x, y), (end, y), 0, thick)
    for at in (x, end):
        cv2.line(page, (at, y - 6 * thick), (at, y + 6 * thick), 0, thick)
    scale = per_metre / 6000
    words = "100 mm: measure it on the paper"
    cv2.putText(page, words, (x, y - 10 * thick), cv2.FONT_HERSHEY_SIMPLEX, scale, 0, thick)
