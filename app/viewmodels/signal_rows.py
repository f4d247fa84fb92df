"""Rows of numbers computed from messages, and the values of signals in them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from app.engines.engine import EngineSetup
from app.viewmodels.signals import Signal, SignalMeasure, SignalSource
from tracker.gestures.recogniser import GestureRecogniser
from tracker.gestures.values import GESTURES
from tracker.live.history import SearchedImage
from tracker.messages import Array, Estimate, ImuSample, Status, Validity
from tracker.session.holes import LONGEST_FILLED
from tracker.session.motion import SMOOTH, speed

LONGEST_STEP = {
    SignalSource.IMU: LONGEST_FILLED,
    SignalSource.HAND: LONGEST_FILLED,
    SignalSource.GESTURES: LONGEST_FILLED,
    SignalSource.IMAGES: 0.25,  # a camera may deliver ten images a second, and lose one
    SignalSource.STATUS: 2.5,  # a recording has one per second
}
"""Maximum s between two instants of a source; a longer gap interrupts a curve."""


@dataclass(frozen=True, eq=False)
class Rows:
    """Instants t (n,) s in increasing order, and columns (n, ...) in SI units by their names; NaN
    where unknown."""

    t: Array
    columns: Mapping[str, Array]


def nothing() -> Rows:
    """No rows."""
    return Rows(np.zeros(0), {})


def imu_rows(samples: Sequence[ImuSample]) -> Rows:
    """Columns gyro (n, i, 3) rad/s and accel (n, i, 3) m/s² of i IMUs."""
    if not samples:
        return nothing()
    columns = {"gyro": [s.gyro for s in samples], "accel": [s.accel for s in samples]}
    return _rows([s.t for s in samples], {n: np.array(rows) for n, rows in columns.items()})


def hand_rows(estimates: Sequence[Estimate]) -> Rows:
    """Columns angles (n, j) rad, points (n, k, 3) m in G, sd (n, k) m and state (n,)."""
    if not estimates:
        return nothing()
    angles = np.array([e.angles for e in estimates])
    angles[np.array([e.angle_state for e in estimates]) == Validity.LOST] = np.nan
    lost = np.array([e.keypoint_state for e in estimates]) == Validity.LOST
    points = np.array([e.keypoints for e in estimates])
    sd = np.array([e.keypoint_sd for e in estimates])
    points[lost], sd[lost] = np.nan, np.nan
    state = np.array([float(e.tracking) for e in estimates])
    columns = {"angles": angles, "points": points, "sd": sd, "state": state}
    return _rows([e.t for e in estimates], columns)


def image_rows(images: Sequence[SearchedImage]) -> Rows:
    """Numbers of blobs and of matched markers, and residuals (px, RMS), each (n,)."""
    if not images:
        return nothing()
    left, right = (
        np.array([getattr(i.result, f"match_{side}") for i in images]) >= 0
        for side in ("left", "right")
    )
    residual = np.array([i.result.residual for i in images])
    columns = {
        "blobs_left": np.array([float(i.left) for i in images]),
        "blobs_right": np.array([float(i.right) for i in images]),
        "matched_left": left.sum(axis=1).astype(float),
        "matched_right": right.sum(axis=1).astype(float),
        "matched_both": (left & right).sum(axis=1).astype(float),
        "residual_left": _rms(residual[:, :, :2]),
        "residual_right": _rms(residual[:, :, 2:]),
    }
    return _rows([i.t for i in images], columns)


def _rms(residual: Array) -> Array:
    """(n,) px of (n, m, 2): the root mean square distance; NaN where no marker is matched."""
    square = (residual**2).sum(axis=2)
    count = np.isfinite(square).sum(axis=1)
    total = np.nansum(square, axis=1)
    return np.asarray(np.sqrt(np.where(count > 0, total / np.maximum(count, 1), np.nan)))


def status_rows(statuses: Sequence[Status]) -> Rows:
    """A column (n,) for each value that any of them has."""
    names = dict.fromkeys(name for status in statuses for name in status.values)
    nan = float("nan")
    columns = {n: np.array([s.values.get(n, nan) for s in statuses]) for n in names}
    return _rows([s.t for s in statuses], columns)


class GestureRows:
    """Strengths of all gestures, 0 to 1, for consecutive estimates of one hand."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self._forget()

    def _forget(self) -> None:
        hand, glove = self._setup.hand, self._setup.glove
        self._recogniser = GestureRecogniser(hand, glove.keypoint_names(hand))
        self._t = -np.inf

    def rows(self, estimates: Sequence[Estimate]) -> Rows:
        """Rows of estimates later than all previous ones; a column (n,) for each gesture."""
        if estimates and estimates[-1].t < self._t:
            self._forget()
        t, found = [], []
        for estimate in estimates:
            if estimate.t > self._t:
                self._recogniser.feed(estimate)
                self._t = estimate.t
                values = self._recogniser.values
                t.append(estimate.t)
                found.append([values[name] for name in GESTURES])
        table = np.array(found).reshape(-1, len(GESTURES))
        return _rows(t, {name: table[:, k] for k, name in enumerate(GESTURES)})


def _rows(t: Sequence[float], columns: Mapping[str, Array]) -> Rows:
    """Sorted by time, each instant once."""
    times = np.array(t, float)
    if (np.diff(times) > 0).all():
        return Rows(times, columns)
    times, first = np.unique(times, return_index=True)
    return Rows(times, {name: values[first] for name, values in columns.items()})


def values_of(signal: Signal, rows: Rows) -> Array:
    """(n,) in the signal's unit; NaN without such a column."""
    column = rows.columns.get(signal.column)
    if column is None:
        return np.full(len(rows.t), np.nan)
    for place in signal.index:
        column = column[:, place]
    x = column
    match signal.measure:
        case SignalMeasure.NORM:
            x = np.linalg.norm(x, axis=1)
        case SignalMeasure.RATE:
            x = speed(rows.t, x)
        case SignalMeasure.SPEED:
            x = np.sqrt(sum(speed(rows.t, x[:, k]) ** 2 for k in range(x.shape[1])))
    return np.asarray(signal.factor * x)


def is_smoothed(signal: Signal) -> bool:
    """Whether a value depends on rows up to `SMOOTH` / 2 before and after it."""
    return signal.measure in (SignalMeasure.RATE, SignalMeasure.SPEED)


LEAD = SMOOTH
"""s of rows before the first wanted value that a smoothed signal needs."""
