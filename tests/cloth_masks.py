"""The glove's own cloth in an image, from where it is drawn."""

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Cloth
from tracker.vision.cloth import SIDE, STEP, TILE


def looked_at(height: int, width: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """x and y (h, w) px of the pixels that a cloth map knows of an image."""
    y, x = np.mgrid[: height // TILE * TILE : STEP, : width // TILE * TILE : STEP]
    return x, y


def cloth_of(mask: NDArray[np.bool_]) -> Cloth:
    """For all tiles; ``mask`` (h, w) as `looked_at` has the pixels."""
    rows, columns = (n // SIDE for n in mask.shape)
    return Cloth(columns, rows, np.arange(rows * columns), bits_of(mask))


def bits_of(mask: NDArray[np.bool_]) -> NDArray[np.int64]:
    """(n,) of all tiles."""
    rows, columns = (n // SIDE for n in mask.shape)
    tiles = mask.reshape(rows, SIDE, columns, SIDE).transpose(0, 2, 1, 3).reshape(-1, SIDE**2)
    return np.asarray((tiles * np.left_shift(np.int64(1), np.arange(SIDE**2))).sum(axis=1))
