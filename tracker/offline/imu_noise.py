"""Noise of a glove's IMUs from a recording at rest, and its glove file with that noise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import nnls

from tracker.base.command import UsageError
from tracker.base.errors import FileError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.glove.imu_values import with_noise
from tracker.glove.model import ImuNoise
from tracker.messages import Array
from tracker.offline.commands import ImuNoiseArguments
from tracker.session.raw_imu import RawImu, read_raw_imu
from tracker.session.reader import SessionReader

POINTS_PER_DECADE = 12
LONGEST_SHARE = 1 / 9
"""For the recording: longer averages have fewer than nine clusters, and say little."""
BIAS_INSTABILITY = np.sqrt(2 * np.log(2) / np.pi)
"""For the flat part of a curve, as a share of the flicker coefficient (IEEE Std 952-1997, C.7)."""


@dataclass(frozen=True, eq=False)
class AllanCurve:
    """``deviation`` (M, k) of k signals at averaging times ``tau`` (M,) s, in their own unit."""

    tau: Array
    deviation: Array


@dataclass(frozen=True)
class NoiseModel:
    """For one signal in unit u: ``white`` u/√Hz, ``flicker`` u (bias instability), ``walk`` u/√s
    (random walk of the bias). 0 where the recording does not show one."""

    white: float
    flicker: float
    walk: float

    def deviation(self, tau: Array) -> Array:
        """The Allan deviation (M,) of this model at ``tau`` (M,) s."""
        coefficients = np.array([self.white, self.flicker, self.walk]) ** 2
        return np.asarray(np.sqrt(_terms(tau) @ coefficients))


def allan(signal: Array, rate_hz: float) -> AllanCurve:
    """Overlapping Allan deviation of ``signal`` (N, k), sampled at ``rate_hz`` without gaps.

    IEEE Std 952-1997, C.2, with overlapping clusters. Raises ValueError for fewer than 100 samples.
    """
    n = len(signal)
    if n < 100:
        raise ValueError("an Allan deviation needs 100 samples")
    longest = int(n * LONGEST_SHARE)
    decades = np.log10(longest)
    sizes = np.unique(np.logspace(0, decades, int(POINTS_PER_DECADE * decades)).astype(int))
    theta = np.concatenate([np.zeros((1, signal.shape[1])), np.cumsum(signal, axis=0)]) / rate_hz
    rows = []
    for m in sizes:
        second = theta[2 * m :] - 2 * theta[m:-m] + theta[: -2 * m]
        tau = m / rate_hz
        rows.append(np.sqrt((second**2).mean(axis=0) / (2 * tau**2)))
    return AllanCurve(sizes / rate_hz, np.array(rows))


def fit(tau: Array, deviation: Array, clusters: Array) -> NoiseModel:
    """White noise, flicker and random walk of one curve (M,), none negative.

    ``clusters`` (M,) is how many independent averages each point has: the relative error of a
    variance is the inverse of the root of that.
    """
    weight = np.sqrt(np.maximum(clusters, 1.0)) / deviation**2
    solution, _ = nnls(_terms(tau) * weight[:, None], deviation**2 * weight)
    return NoiseModel(*(float(np.sqrt(c)) for c in solution))


def _terms(tau: Array) -> Array:
    """(M, 3) variances of unit coefficients: white N²/τ, flicker, walk K² τ/3."""
    return np.stack([1 / tau, np.full_like(tau, BIAS_INSTABILITY**2), tau / 3], axis=1)


def noise_of(signal: Array, rate_hz: float) -> tuple[AllanCurve, list[NoiseModel]]:
    """The curve of ``signal`` (N, k) and the k models fitted to it."""
    curve = allan(signal, rate_hz)
    clusters = len(signal) / (curve.tau * rate_hz)
    return curve, [fit(curve.tau, column, clusters) for column in curve.deviation.T]


LEAST_S = 60.0
WINDOW_S = 1.0
MOVED = 4.0
"""Windows whose standard deviation exceeds that at rest by this factor count as motion."""
QUIET_PERCENTILE = 20
GAPS = 0.02
"""Largest share of samples that may be missing; they are interpolated."""


@dataclass(frozen=True, eq=False)
class ImuNoiseResult:
    """One IMU: curves and models of the gyroscope (rad/s) and accelerometer (m/s²), axes x y z."""

    name: str
    gyro_curve: AllanCurve
    accel_curve: AllanCurve
    gyro: list[NoiseModel]
    accel: list[NoiseModel]

    @property
    def noise(self) -> ImuNoise:
        """The worst axis of each, for the glove file."""
        return ImuNoise(
            gyro=max(m.white for m in self.gyro),
            accel=max(m.white for m in self.accel),
            gyro_bias=max(m.walk for m in self.gyro),
            accel_bias=max(m.walk for m in self.accel),
        )


@dataclass(frozen=True, eq=False)
class NoiseReport:
    """For a rest that began ``start_s`` after the recording and lasts ``duration_s``."""

    rate_hz: float
    start_s: float
    duration_s: float
    imus: list[ImuNoiseResult]

    def as_json(self) -> dict[str, Any]:
        return {
            "rate_hz": self.rate_hz,
            "start_s": self.start_s,
            "duration_s": self.duration_s,
            "imus": {i.name: _as_json(i) for i in self.imus},
        }

    def lines(self) -> list[str]:
        """A table for people."""
        out = [
            f"At rest from {self.start_s:.0f} s for {self.duration_s:.0f} s, "
            f"{self.rate_hz:.1f} samples per second. Worst axis of each IMU:",
            f"{'IMU':20}{'gyro °/s/√Hz':>14}{'instability °/h':>17}{'accel µg/√Hz':>14}"
            f"{'instability µg':>16}",
        ]
        for imu in self.imus:
            dps = np.rad2deg(max(m.white for m in imu.gyro))
            dph = 3600 * np.rad2deg(max(m.flicker for m in imu.gyro))
            ug = [
                1e6 / 9.80665 * max(getattr(m, n) for m in imu.accel) for n in ("white", "flicker")
            ]
            out.append(f"{imu.name:20}{dps:14.4f}{dph:17.1f}{ug[0]:14.0f}{ug[1]:16.0f}")
        return out

    def table(self) -> tuple[list[str], Array]:
        """Column names and rows (M, 1 + 6 n) of all curves: s, rad/s and m/s²."""
        names, columns = ["tau_s"], [self.imus[0].gyro_curve.tau[:, None]]
        for imu in self.imus:
            for what, curve in (("gyr", imu.gyro_curve), ("acc", imu.accel_curve)):
                names += [f"{imu.name}_{what}_{axis}" for axis in "xyz"]
                columns.append(curve.deviation)
        return names, np.concatenate(columns, axis=1)


def _as_json(imu: ImuNoiseResult) -> dict[str, Any]:
    return {
        name: [{"white": m.white, "flicker": m.flicker, "walk": m.walk} for m in models]
        for name, models in (("gyro_rad_s", imu.gyro), ("accel_m_s2", imu.accel))
    }


def imu_noise(raw: RawImu) -> NoiseReport:
    """Analyses the longest rest of a recording. Raises FileError if it has none of 60 s, or if an
    IMU is missing in more than 2 % of it."""
    if len(raw) < 2:
        raise FileError(notice("noise.no_samples"))
    t = (raw.stamp_ns - raw.stamp_ns[0]) * 1e-9
    rate_hz = (len(t) - 1) / float(t[-1])  # single steps have the jitter of the time stamps
    first, last = longest_rest(raw, rate_hz)
    duration = (last - first) / rate_hz
    if duration < LEAST_S:
        raise FileError(notice("noise.short_rest", rest_s=duration, least_s=LEAST_S))
    out = []
    for j, name in enumerate(raw.names):
        gyro = _without_gaps(raw.gyro[first:last, j], name)
        accel = _without_gaps(raw.accel[first:last, j], name)
        gyro_curve, gyro_models = noise_of(gyro, rate_hz)
        accel_curve, accel_models = noise_of(accel, rate_hz)
        out.append(ImuNoiseResult(name, gyro_curve, accel_curve, gyro_models, accel_models))
    return NoiseReport(rate_hz, float(t[first]), duration, out)


def longest_rest(raw: RawImu, rate_hz: float) -> tuple[int, int]:
    """First packet of the longest rest and the one after its last."""
    size = max(2, round(WINDOW_S * rate_hz))
    count = len(raw) // size
    if count == 0:
        return 0, 0
    gyro = raw.gyro[: count * size].reshape(count, size, -1)
    spread = np.full(count, np.inf)
    for k, window in enumerate(gyro):
        known = window[np.isfinite(window).all(axis=1)]
        if len(known) > size / 2:
            spread[k] = known.std(axis=0).max()
    if not np.isfinite(spread).any():
        return 0, 0
    least = np.percentile(spread[np.isfinite(spread)], QUIET_PERCENTILE)
    still = spread <= MOVED * least
    edges = np.flatnonzero(np.diff(np.concatenate([[False], still, [False]])))
    if len(edges) == 0:
        return 0, 0
    starts, ends = edges[::2], edges[1::2]
    k = int(np.argmax(ends - starts))
    return int(starts[k]) * size, int(ends[k]) * size


def _without_gaps(values: Array, name: str) -> Array:
    """(N, 3) with missing samples interpolated."""
    known = np.isfinite(values).all(axis=1)
    missing = 1 - known.mean()
    if missing > GAPS:
        raise FileError(notice("noise.imu_missing", imu=name, missing_percent=100 * missing))
    at = np.arange(len(values))
    return np.stack([np.interp(at, at[known], column[known]) for column in values.T], axis=1)


def run(args: ImuNoiseArguments) -> int:
    if (args.glove is None) != (args.target is None):
        raise UsageError(notice("option.together", options=("--glove", "--set")))
    inputs = [path for path in (args.session, args.glove) if path is not None]
    check_json(args, inputs)
    for path in (args.out, args.target):
        if path is not None:
            check_target(path, args.force, inputs)
    with SessionReader(args.session) as reader:
        report = imu_noise(read_raw_imu(reader))
    lines = report.lines()
    if args.out is not None:
        names, rows = report.table()
        table = [",".join(names), *(",".join(f"{x:.6g}" for x in row) for row in rows)]
        write_whole(args.out, "\n".join(table) + "\n", args.force, inputs)
    if args.glove is not None and args.target is not None:
        text = args.glove.read_text("utf-8")
        noise = {imu.name: imu.noise for imu in report.imus}
        write_whole(args.target, with_noise(text, noise), args.force, inputs)
        lines.append(f"{args.target}: noise of {len(noise)} IMUs")
    finish(args, report.as_json(), lines, inputs)
    return 0
