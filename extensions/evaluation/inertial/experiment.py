"""The numerical experiment of Lemak et al. 2020 (section 3), over many seeds."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from extensions.evaluation.inertial import peers
from extensions.evaluation.inertial.errors import SERIES, Errors, draw
from extensions.evaluation.inertial.estimators import ESTIMATORS, VARIANTS
from extensions.evaluation.inertial.motion import (
    DURATIONS,
    HORIZONTAL,
    MOVING,
    VERTICAL,
    FingerMotion,
    MotionCondition,
    grasp,
)
from tracker.inertial.finger import Finger
from tracker.messages import Array

Progress = Callable[[float, str], None]
"""Receives the completed share, 0..1, and the current step."""


@dataclass(frozen=True)
class Plan:
    """Cases to run. Peers and the study of β have fewer seeds, since their runs at 1 kHz are
    long."""

    rates_hz: tuple[float, ...] = (100.0, 1000.0)
    seeds: int = 5
    side_seeds: int = 2
    durations: tuple[float, ...] = DURATIONS
    series: tuple[str, ...] = SERIES
    with_peers: bool = True

    @staticmethod
    def quick(seeds: int = 2) -> Plan:
        """A plan of about a minute: every third duration up to 100 s, 100 Hz."""
        short = tuple(t for t in DURATIONS[::3] if t < 100)
        return Plan((100.0,), seeds, 1, short)


@dataclass(frozen=True)
class ErrorRow:
    """RMS error (°) of both measured angles over complete motions, and its range over seeds."""

    condition: str
    series: str
    rate_hz: float
    t_m: float
    estimator: str
    rms_deg: float
    low_deg: float
    high_deg: float
    seeds: int


@dataclass(frozen=True, eq=False)
class FingerCase:
    """One duration at one rate under one kind of errors."""

    condition: MotionCondition
    series: str
    rate_hz: float
    t_m: float
    names: tuple[str, ...]
    side: tuple[str, ...]  # peers and variants, for the first seeds only


def run(
    plan: Plan, finger: Finger, progress: Progress = lambda share, what: None
) -> list[ErrorRow]:
    """Run every case of the plan."""
    cases = list(_cases(plan))
    work = np.cumsum([c.t_m * c.rate_hz + 1 for c in cases])
    rows: list[ErrorRow] = []
    for case, done in zip(cases, work, strict=True):
        rows += run_case(case, plan, finger)
        progress(float(done / work[-1]), f"{case.condition.name} {case.series} {case.rate_hz:g} Hz")
    return rows


def _cases(plan: Plan) -> Iterator[FingerCase]:
    own = tuple(ESTIMATORS)
    side = (*VARIANTS, *(peers.available() if plan.with_peers else ()))
    for rate_hz in plan.rates_hz:
        for series in plan.series:
            for t_m in plan.durations:
                yield FingerCase(VERTICAL, series, rate_hz, t_m, own, side)
    for condition in (HORIZONTAL, MOVING):
        for t_m in plan.durations:
            yield FingerCase(condition, "both", plan.rates_hz[0], t_m, own, ())


def run_case(case: FingerCase, plan: Plan, finger: Finger) -> list[ErrorRow]:
    """One row per estimator; all receive the same readings of the same seeds."""
    motion = grasp(finger, case.t_m, case.rate_hz, case.condition)
    errors: dict[str, list[float]] = {}
    for seed in range(plan.seeds):
        drawn = draw(len(motion.t), case.series, case.rate_hz, _seed(case, seed))
        for name in (*case.names, *(case.side if seed < plan.side_seeds else ())):
            theta = _angles(name, finger, motion, drawn, 1 / case.rate_hz)
            errors.setdefault(name, []).append(rms_deg(motion, theta))
    return [_row(case, name, values) for name, values in errors.items()]


def _angles(name: str, finger: Finger, motion: FingerMotion, errors: Errors, dt: float) -> Array:
    """Angles θ (n, 2) rad of one estimator or peer."""
    maker = ESTIMATORS.get(name) or VARIANTS.get(name)
    if maker is None:
        return peers.peer_angles(name, motion, errors, dt)
    return maker(finger, dt).run(errors.planar(motion.ideal))


def rms_deg(motion: FingerMotion, theta: Array) -> float:
    """Root mean square error of θ (n, 2) over samples and sensors."""
    return float(np.rad2deg(np.sqrt(np.mean((theta - motion.theta[:, :2]) ** 2))))


def _seed(case: FingerCase, seed: int) -> tuple[int, ...]:
    """Seed of an independent generator per case and seed."""
    return seed, SERIES.index(case.series), round(case.rate_hz), round(1e3 * case.t_m)


def _row(case: FingerCase, name: str, values: list[float]) -> ErrorRow:
    pooled = float(np.sqrt(np.mean(np.square(values))))
    where = (case.condition.name, case.series, case.rate_hz, case.t_m)
    return ErrorRow(*where, name, pooled, min(values), max(values), len(values))


def crossover(rows: list[ErrorRow], series: str, rate_hz: float) -> float | None:
    """t_m (s) above which gravity alone is better than integration; None if not in the rows."""
    t_m, gravity = curve(rows, series, rate_hz, "gravity")
    gain = np.log(gravity / curve(rows, series, rate_hz, "integration")[1])
    worse = np.flatnonzero(gain > 0)
    if len(worse) == 0 or worse[-1] == len(gain) - 1:
        return None
    i = int(worse[-1])
    share = gain[i] / (gain[i] - gain[i + 1])
    return float(t_m[i] * (t_m[i + 1] / t_m[i]) ** share)


def curve(rows: list[ErrorRow], series: str, rate_hz: float, name: str) -> tuple[Array, Array]:
    """t_m and RMS error of one estimator with the plane vertical, by duration."""
    found = sorted(
        (r.t_m, r.rms_deg)
        for r in rows
        if (r.condition, r.series, r.rate_hz, r.estimator) == ("vertical", series, rate_hz, name)
    )
    t_m, rms = np.array(found, float).reshape(-1, 2).T
    return t_m, rms
