"""Measures the cost of one update in interleaved rounds.

Streaming is the cost in a live glove: one call from Python per sample. Batch is the arithmetic
alone: the time of `run` divided by the number of samples. Both are medians over the rounds.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from extensions.evaluation.inertial.errors import draw
from extensions.evaluation.inertial.estimators import ESTIMATORS
from extensions.evaluation.inertial.motion import grasp
from extensions.evaluation.inertial.peers import available
from tracker import GRAVITY
from tracker.inertial.finger import Finger
from tracker.inertial.planar import PlanarEstimator, PlanarReadings
from tracker.inertial.segments import SegmentFilters
from tracker.messages import Array

GLOVE = 7  # IMUs
DT = 0.01
ROUNDS, UPDATES = 9, 1000

Job = Callable[[], object]


def streaming_us() -> dict[str, float]:
    """µs per update: two sensors of a finger for the planar estimators, otherwise seven IMUs."""
    finger = Finger()
    readings = _readings(finger, 1.0)
    jobs = {name: _update(make(finger, DT), readings) for name, make in ESTIMATORS.items()}
    gyro, accel = _glove_sample()
    jobs["segments_7"] = _segments(gyro, accel)
    if "vqf" in available():
        jobs["vqf_7"] = _vqf(gyro, accel)
    return _medians(jobs, UPDATES)


def batch_us() -> dict[str, float]:
    """µs per sample of two sensors of a finger, without the calls from Python."""
    finger = Finger()
    readings = _readings(finger, 100.0)
    jobs = {name: _batch(make(finger, DT), readings) for name, make in ESTIMATORS.items()}
    n = len(readings.root)
    return {name: us / n for name, us in _medians(jobs, 1).items()}


def _medians(jobs: dict[str, Job], updates: int) -> dict[str, float]:
    for job in jobs.values():
        job()  # compiles
    times: dict[str, list[float]] = {name: [] for name in jobs}
    for _ in range(ROUNDS):
        for name, job in jobs.items():
            start = time.perf_counter()
            for _ in range(updates):
                job()
            times[name].append((time.perf_counter() - start) / updates * 1e6)
    return {name: float(np.median(values)) for name, values in times.items()}


def _readings(finger: Finger, t_m: float) -> PlanarReadings:
    motion = grasp(finger, t_m, 1 / DT)
    return draw(len(motion.t), "both", 1 / DT, (0,)).planar(motion.ideal)


def _update(estimator: PlanarEstimator, readings: PlanarReadings) -> Job:
    gyro, accel = readings.gyro[0].copy(), readings.accel[0].copy()
    root = complex(readings.root[0])
    return lambda: estimator.update(gyro, accel, root)


def _batch(estimator: PlanarEstimator, readings: PlanarReadings) -> Job:
    return lambda: estimator.run(readings)


def _glove_sample() -> tuple[Array, Array]:
    rng = np.random.default_rng(0)
    accel = np.tile([0.0, 0.0, GRAVITY], (GLOVE, 1)) + 0.1 * rng.standard_normal((GLOVE, 3))
    return 0.1 * rng.standard_normal((GLOVE, 3)), accel


def _segments(gyro: Array, accel: Array) -> Job:
    filters = SegmentFilters(GLOVE, DT)
    return lambda: filters.update(gyro, accel)


def _vqf(gyro: Array, accel: Array) -> Job:
    """Seven VQF filters; rows are extracted beforehand, in the peer's favour."""
    from vqf import VQF  # deferred: an extra

    filters = [VQF(DT) for _ in range(GLOVE)]
    rows = [(f, g.copy(), a.copy()) for f, g, a in zip(filters, gyro, accel, strict=True)]

    def job() -> None:
        for f, g, a in rows:
            f.update(g, a)

    return job
