"""A hue table expanded to all colours, using the detector's kernels."""

import numpy as np

from tracker.vision.hue_table import HueTable


def all_classes(table: HueTable) -> np.ndarray:
    """(256, 256, 256) class of every colour, by b, g, r."""
    patterns = table.patterns.reshape(-1, 8, 8, 8)[table.cells]
    cells = patterns.reshape(32, 32, 32, 8, 8, 8)
    return cells.transpose(0, 3, 1, 4, 2, 5).reshape(256, 256, 256)
