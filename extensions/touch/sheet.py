"""The sheet of the touch test: a ChArUco frame, numbered crosses inside, a folded ridge.

Frame S of the sheet: origin at the top left corner of the frame, x to the right, y down the paper,
z into the paper, as OpenCV has it for boards. A cross on the ridge has a negative z.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array, IntArray

COLUMNS, ROWS = 13, 9
SQUARE = 0.020  # m
RING = 2  # squares: width of the frame
MARKER_SHARE = 0.75
DICTIONARY = cv2.aruco.DICT_4X4_100
"""Not the calibration board's, so that neither is mistaken for the other."""

RIDGE_HEIGHT = 0.025  # m
RIDGE_TOP = 0.020  # m, width of its flat top
RIDGE_LENGTH = 0.140
RIDGE_Y = 0.068  # m, of the middle of its top
TAB = 0.015  # m, on both sides, to tape it down
CROSS = 0.010  # m, length of the lines
RULER = COLUMNS * SQUARE  # m, the line that the user measures: the width of the frame


@dataclass(frozen=True)
class SheetCross:
    """A target: ``x``, ``y`` m on the paper, ``height`` m above it."""

    number: int
    x: float
    y: float
    height: float

    @property
    def name(self) -> str:
        return str(self.number)

    @property
    def p_S(self) -> Array:
        """(3,) m."""
        return np.array([self.x, self.y, -self.height])


def _crosses() -> tuple[SheetCross, ...]:
    flat = [(x, y, 0.0) for y in (0.100, 0.128) for x in (0.055, 0.105, 0.155, 0.205)]
    raised = [(x, RIDGE_Y, RIDGE_HEIGHT) for x in (0.070, 0.110, 0.150, 0.190)]
    return tuple(SheetCross(k, *place) for k, place in enumerate(flat + raised, 1))


CROSSES = _crosses()
BY_NAME = {c.name: c for c in CROSSES}


def is_in_frame(column: int, row: int) -> bool:
    """Whether a square belongs to the printed frame."""
    return min(column, row, COLUMNS - 1 - column, ROWS - 1 - row) < RING


class TouchSheet:
    """The printed frame as a board for OpenCV."""

    width = COLUMNS * SQUARE
    height = ROWS * SQUARE

    @cached_property
    def board(self) -> cv2.aruco.CharucoBoard:
        """The whole board, of which only the frame is printed."""
        dictionary = cv2.aruco.getPredefinedDictionary(DICTIONARY)
        return cv2.aruco.CharucoBoard((COLUMNS, ROWS), SQUARE, SQUARE * MARKER_SHARE, dictionary)

    @cached_property
    def corner_ids(self) -> IntArray:
        """(n,) numbers of the corners that have all four squares in the frame."""
        found = []
        for row in range(1, ROWS):
            for column in range(1, COLUMNS):
                around = [(column - i, row - j) for i in (0, 1) for j in (0, 1)]
                if all(is_in_frame(*square) for square in around):
                    found.append((row - 1) * (COLUMNS - 1) + column - 1)
        return np.array(found, np.int64)

    def points(self, ids: IntArray) -> Array:
        """(n, 3) m in S of corners, as the sheet is meant to be printed."""
        row, column = np.divmod(ids, COLUMNS - 1)
        flat = np.column_stack([column + 1, row + 1]) * SQUARE
        return np.column_stack([flat, np.zeros(len(ids))])

    def image(self, square_px: int = 60) -> NDArray[np.uint8]:
        """(ROWS, COLUMNS) · square_px grey pixels of the frame alone; white inside."""
        size = (COLUMNS * square_px, ROWS * square_px)
        out = np.array(self.board.generateImage(size), np.uint8)
        inner = slice(RING * square_px, -RING * square_px)
        out[inner, inner] = 255
        return out
