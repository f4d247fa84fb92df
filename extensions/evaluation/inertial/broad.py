"""Orientation filters on BROAD recordings, scored as that benchmark does.

Laidig, Caruso, Cereatti, Seel, "BROAD: A Benchmark for Robust Inertial Orientation Estimation",
Data 6(7):72, 2021, doi 10.3390/data6070072, section 4. Filters without a magnetometer choose their
own heading, so the heading offset of the first scored sample is removed from all samples.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import scipy.io
from numpy.typing import NDArray
from scipy.io.matlab import MatReadError

from extensions.evaluation.inertial.peers import (
    OrientationFilter,
    available,
    imufusion_orientation,
    vqf_orientation,
)
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.inertial.descent import plain_madgwick
from tracker.inertial.segments import SegmentFilters
from tracker.messages import Array

MADGWICK_BETA = 0.033  # rad/s, the filter's paper for a sensor without magnetometer


@dataclass(frozen=True, eq=False)
class BroadTrial:
    """One recording: gyro (n, 3) rad/s, accel (n, 3) m/s², truth q_GB (n, 4) xyzw, NaN where the
    cameras lost it, scored (n,) where the benchmark counts errors."""

    name: str
    dt: float
    gyro: Array
    accel: Array
    q_GB: Array
    scored: NDArray[np.bool_]


@dataclass(frozen=True)
class BroadRow:
    """RMS errors of one filter over one trial."""

    trial: str
    estimator: str
    total_deg: float
    heading_deg: float
    inclination_deg: float


def read_trial(path: Path) -> BroadTrial:
    """Read a trial's MATLAB file. Raises FileError if it is invalid."""
    try:
        data = scipy.io.loadmat(path)
        q_wxyz = np.asarray(data["opt_quat"], float)
        moving = np.asarray(data["movement"], bool).ravel()
        return BroadTrial(
            path.stem,
            1 / float(data["sampling_rate"].item()),
            np.ascontiguousarray(data["imu_gyr"], float),
            np.ascontiguousarray(data["imu_acc"], float),
            np.roll(q_wxyz, -1, axis=1),
            moving & np.isfinite(q_wxyz).all(axis=1),
        )
    except (OSError, ValueError, KeyError, NotImplementedError, MatReadError) as error:
        raise FileError(notice("evaluation.not_broad", path=path, why=error)) from error


def filters() -> dict[str, OrientationFilter]:
    """Our filter, plain Madgwick and the installed peers, each with its defaults."""
    out: dict[str, OrientationFilter] = {
        "segments": _segments,
        "madgwick_plain": lambda g, a, dt: plain_madgwick(g, a, dt, MADGWICK_BETA),
    }
    if "vqf" in available():
        out["vqf"] = vqf_orientation
    if "imufusion" in available():
        out["imufusion"] = imufusion_orientation
    return out


def _segments(gyro: Array, accel: Array, dt: float) -> Array:
    filtered: Array = SegmentFilters(1, dt).run(gyro[:, None], accel[:, None])[:, 0]
    return filtered


def trial_paths(folder: Path) -> list[Path]:
    """The recordings in a folder, sorted by name. Raises FileError if there are none."""
    found = sorted(folder.glob("*.mat"))
    if not found:
        raise FileError(notice("evaluation.no_broad", folder=folder))
    return found


def evaluate(paths: Iterable[Path], chosen: dict[str, OrientationFilter]) -> list[BroadRow]:
    """Apply every filter to every trial."""
    rows = []
    for path in paths:
        trial = read_trial(path)
        for name, run in chosen.items():
            rows.append(score(trial, name, run(trial.gyro, trial.accel, trial.dt)))
    return rows


def score(trial: BroadTrial, name: str, q_GB: Array) -> BroadRow:
    """RMS of total, heading and inclination error over the scored samples."""
    q_error = earth_error(q_GB[trial.scored], trial.q_GB[trial.scored])
    q_error = without_heading(q_error, q_error[0])
    x, y, z, w = np.abs(q_error).T
    total = 2 * np.arccos(np.minimum(w, 1.0))
    heading = 2 * np.arctan2(z, w)
    inclination = 2 * np.arcsin(np.minimum(np.hypot(x, y), 1.0))
    return BroadRow(trial.name, name, _rms_deg(total), _rms_deg(heading), _rms_deg(inclination))


def earth_error(q_GB: Array, truth: Array) -> Array:
    """Rotations (n, 4) xyzw in G from truth to estimate: q ⊗ truth⁻¹."""
    return _product(q_GB, truth * np.array([-1.0, -1.0, -1.0, 1.0]))


def without_heading(q_error: Array, reference: Array) -> Array:
    """Errors without the heading error of ``reference``."""
    turn = np.array([0.0, 0.0, -reference[2], reference[3]])
    turn /= np.linalg.norm(turn)
    return _product(turn[None], q_error)


def _product(p: Array, q: Array) -> Array:
    """Quaternion product of rows xyzw."""
    v = p[:, 3:] * q[:, :3] + q[:, 3:] * p[:, :3] + np.cross(p[:, :3], q[:, :3])
    w = p[:, 3] * q[:, 3] - np.sum(p[:, :3] * q[:, :3], axis=1)
    return np.column_stack([v, w])


def _rms_deg(angle: Array) -> float:
    return float(np.rad2deg(np.sqrt(np.mean(angle**2))))
