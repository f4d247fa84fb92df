"""Statistics of each feature, per episode and overall, by which LeRobot normalises."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array

MOST_IMAGES = 100
"""Images per episode and camera from which statistics are computed."""


class Stats(NamedTuple):
    """Statistics of values (C,), or of images (3, 1, 1) per colour, red first, 0 to 1."""

    min: Array
    max: Array
    mean: Array
    std: Array
    frames: int

    def to_json(self) -> dict[str, Any]:
        values = {name: np.asarray(v).tolist() for name, v in self._asdict().items()}
        return {**values, "count": [values.pop("frames")]}


def stats_of(values: NDArray[Any]) -> Stats:
    """Statistics of values (N, C) or (N,)."""
    table = np.asarray(values).reshape(len(values), -1)
    low, high = table.min(axis=0).astype(float), table.max(axis=0).astype(float)
    mean, std = table.mean(axis=0, dtype=float), table.std(axis=0, dtype=float)
    return Stats(low, high, mean, std, len(table))


def image_rows(frames: int) -> frozenset[int]:
    """Frames whose images are sampled."""
    return frozenset(np.linspace(0, frames - 1, min(frames, MOST_IMAGES)).round().astype(int))


def image_stats(images: Iterable[bytes]) -> Stats:
    """Statistics of encoded images at an eighth of their size. Raises FileError if one is
    damaged."""
    found = []
    for data in images:
        image = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_REDUCED_COLOR_8)
        if image is None:
            raise FileError(notice("lerobot.image_damaged"))
        mean, std = cv2.meanStdDev(image)
        low, high = image.min(axis=(0, 1)), image.max(axis=(0, 1))
        found.append(np.array([low, high, mean[:, 0], mean[:, 0] ** 2 + std[:, 0] ** 2]))
    low, high, mean, square = np.moveaxis(np.array(found)[:, :, ::-1], 1, 0)  # red first
    middle = mean.mean(axis=0)
    std = np.sqrt(np.maximum(square.mean(axis=0) - middle**2, 0.0))
    row = (low.min(axis=0), high.max(axis=0), middle, std)
    by_colour = [(v / 255.0).reshape(3, 1, 1) for v in row]
    return Stats(by_colour[0], by_colour[1], by_colour[2], by_colour[3], len(found))


def together(all_stats: Sequence[Mapping[str, Stats]]) -> dict[str, Stats]:
    """Statistics over all episodes; means and variances are weighted by the number of frames."""

    return {key: _joined([s[key] for s in all_stats]) for key in all_stats[0]}


def _joined(found: Sequence[Stats]) -> Stats:
    counts = np.array([s.frames for s in found], float)
    weight = (counts / counts.sum()).reshape(-1, *[1] * found[0].mean.ndim)
    means = np.array([s.mean for s in found])
    mean = (weight * means).sum(axis=0)
    within = np.array([s.std**2 for s in found]) + (means - mean) ** 2
    low, high = np.min([s.min for s in found], axis=0), np.max([s.max for s in found], axis=0)
    return Stats(low, high, mean, np.sqrt((weight * within).sum(axis=0)), int(counts.sum()))
