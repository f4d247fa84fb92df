"""Seven orientation filters, one sample: ours in one compiled call beside seven VQFs."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec

import numpy as np

from tests.benchmarks.rows import BenchRow, Call, interleaved, row
from tracker import GRAVITY
from tracker.inertial.segments import SegmentFilters
from tracker.messages import Array

IMUS, DT = 7, 0.01
INNER = 1000


def inertial_rows(rounds: int, seed: int = 1, inner: int = INNER) -> list[BenchRow]:
    """One row; without a ratio where vqf is not installed."""
    rng = np.random.default_rng(seed)
    gyro = 0.1 * rng.standard_normal((IMUS, 3))
    accel = np.array([0.0, 0.0, GRAVITY]) + 0.1 * rng.standard_normal((IMUS, 3))
    filters = SegmentFilters(IMUS, DT)
    calls: list[Call] = [lambda: filters.update(gyro, accel)]
    if find_spec("vqf") is not None:
        calls.append(_vqf(gyro, accel))
    us = 1e6 * interleaved(calls, rounds, inner)
    peer = us[1] if len(us) > 1 else None
    return [row("seven orientation filters, one step", us[0], "µs", "vqf, streaming", peer, "0.25")]


def _vqf(gyro: Array, accel: Array) -> Call:
    """Seven filters; the rows are taken out beforehand, in the peer's favour."""
    make = import_module("vqf").VQF
    rows = [(make(DT), g.copy(), a.copy()) for g, a in zip(gyro, accel, strict=True)]

    def call() -> None:
        for f, g, a in rows:
            f.update(g, a)

    return call
