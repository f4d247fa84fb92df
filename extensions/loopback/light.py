"""Finds a blinking light in images, and its delay.

The share of an exposure in which the light is on, predicted for a delay, correlates with the
brightness where the light is. The delay of the largest correlation is the estimate; pulses at
irregular times make it unique, and finer than the interval of the images.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, notice
from tracker.messages import Array

EARLIEST, LATEST, STEP, FINE = -0.1, 0.6, 0.002, 0.0002  # s
LEAST = 0.7  # correlation of a light that is seen
DISTINCT = 0.6  # of it, at most, with the same commands in reverse
SLOW = 0.75  # s over which slow changes of brightness are removed
EXPOSED = (0.1, 0.5, 1.0)  # of the interval of the images
BLOCKS = 8
FEWEST = 10  # pulses in the images


class DelayedLight(NamedTuple):
    """A light: its cell in the grid, its delay and the standard deviation of that in s, and the
    correlation with the commands."""

    cell: int
    delay: float
    sd: float
    correlation: float


def no_light(correlation: float) -> Notice:
    """No cell follows the commands."""
    return notice("loopback.no_light", correlation=correlation)


def find_light(
    times: Array, cells: Array, pulses: Array, unseen: Callable[[float], Notice] = no_light
) -> DelayedLight:
    """The light among the brightnesses (N, M) of cells at the exposures' ``times`` (N,) s that
    follows ``pulses`` (P, 2): begin and end in s, as commanded.

    Raises DeviceError if there are too few, or, with the notice ``unseen`` makes of the
    correlation, if no cell follows them.
    """
    times, order = np.sort(times), np.argsort(times)
    shown = pulses[(pulses[:, 0] > times[0]) & (pulses[:, 1] + LATEST < times[-1])]
    if len(shown) < FEWEST or len(times) < 2 * FEWEST:
        raise DeviceError(notice("loopback.too_short", pulses=len(shown), least=FEWEST))
    frame = float(np.median(np.diff(times)))
    bright = _without_slow(np.asarray(cells, float)[order], max(3, round(SLOW / frame)))
    grid = np.arange(EARLIEST, LATEST, STEP)
    found = _correlations(times, bright, pulses, grid, 0.5 * frame)
    k, cell = np.unravel_index(np.argmax(found), found.shape)
    best = float(found[k, cell])
    mirrored = times[0] + times[-1] - pulses[::-1, ::-1]
    chance = _correlations(times, bright[:, [cell]], mirrored, grid, 0.5 * frame).max()
    if not (best > LEAST and chance < DISTINCT * best):
        raise DeviceError(unseen(round(max(best, 0.0), 2)))
    delay, best = _refined(times, bright[:, [cell]], pulses, float(grid[k]), frame)
    return DelayedLight(
        int(cell), delay, _spread(times, bright[:, [cell]], pulses, delay, frame), best
    )


def _refined(
    times: Array, bright: Array, pulses: Array, near: float, frame: float
) -> tuple[float, float]:
    """The delay of the largest correlation near a first one, and that correlation."""
    grid = np.arange(near - 3 * STEP, near + 3 * STEP, FINE)
    made = [_correlations(times, bright, pulses, grid, share * frame)[:, 0] for share in EXPOSED]
    best = max(made, key=np.max)
    top = best > best.max() - 1e-9  # several where no exposure falls between
    return float(grid[top].mean()), float(best.max())


def _spread(times: Array, bright: Array, pulses: Array, delay: float, frame: float) -> float:
    """Standard deviation of the delay: jackknife over blocks of time."""
    edges = np.linspace(times[0], times[-1], BLOCKS + 1)
    left_out = []
    for begin, end in pairwise(edges):
        kept = (times < begin) | (times >= end)
        left_out.append(_refined(times[kept], bright[kept], pulses, delay, frame)[0])
    return float(np.sqrt((BLOCKS - 1) * np.var(left_out)))


def _correlations(
    times: Array, bright: Array, pulses: Array, delays: Array, exposure: float
) -> Array:
    """(D, M): of each delay with each cell."""
    predicted = np.array([_share_on(times - d, pulses, exposure) for d in delays])
    predicted -= predicted.mean(axis=1, keepdims=True)
    norms = np.linalg.norm(predicted, axis=1)[:, None] * np.linalg.norm(bright, axis=0)
    return np.divide(predicted @ bright, norms, out=np.zeros(norms.shape), where=norms > 0)


def _share_on(times: Array, pulses: Array, exposure: float) -> Array:
    """Share of exposures, centred at ``times``, in which a light of these pulses is on."""
    half = max(exposure, FINE) / 2
    return (_time_on(times + half, pulses) - _time_on(times - half, pulses)) / (2 * half)


def _time_on(times: Array, pulses: Array) -> Array:
    """s that the light has been on until each time."""
    nodes = pulses.ravel()
    on = np.cumsum(pulses[:, 1] - pulses[:, 0])
    values = np.column_stack([np.concatenate([[0.0], on[:-1]]), on]).ravel()
    made: Array = np.interp(times, nodes, values)
    return made


def _without_slow(bright: Array, count: int) -> Array:
    """Less the mean of ``count`` images around each: lamps, and a hand that moves."""
    total = np.cumsum(np.vstack([np.zeros(bright.shape[1]), bright]), axis=0)
    n = np.arange(len(bright))
    low, high = np.maximum(n - count // 2, 0), np.minimum(n + count // 2 + 1, len(bright))
    return bright - (total[high] - total[low]) / (high - low)[:, None]
