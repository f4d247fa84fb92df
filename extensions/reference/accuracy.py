"""Accuracy of the estimates of sessions against their references."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.special import gammainc

from extensions.reference.pairs import Pairs, Quantity
from extensions.reference.statistics import (
    Agreement,
    Icc,
    Interval,
    Pooled,
    bland_altman,
    effective_size,
    icc_2_1,
    random_intercept,
    rms,
)
from tracker.messages import Array, IntArray, Validity
from tracker.session.edits import Mask

SPEEDS = (0.0, 0.05, 0.1, 0.2, 0.4, 0.8, float("inf"))  # m/s, limits of the bins
MULTIPLES = tuple(np.arange(0.25, 4.01, 0.25).tolist())  # of the claimed standard deviation
WORST, APART = 10, 0.5  # instants, and s between two of them
ALL = "all keypoints"
_FEW = 20  # instants of a bin or state that is listed


@dataclass(frozen=True)
class PointRow:
    """One keypoint: ``rmse`` of the distance, with its interval, and ``rmse_rigid`` without marker
    offsets; ``p95`` of the distance; per axis of the hand the agreement; ``icc``: the least of the
    three coordinates in G. Lengths in m."""

    name: str
    n: int
    n_effective: float
    rmse: float
    rmse_ci: Interval
    rmse_rigid: float
    p95: float
    axes: tuple[Agreement, Agreement, Agreement]
    icc: Icc


@dataclass(frozen=True)
class ScalarRow:
    """One joint angle (rad) or distance (m): agreement of estimate minus reference, and ICC."""

    name: str
    is_angle: bool
    rmse: float
    agreement: Agreement
    icc: Icc


@dataclass(frozen=True)
class Bin:
    """Errors of all keypoints at some speeds or in a state: share of all, rms and 95th percentile
    of the distance, m."""

    name: str
    share: float
    rmse: float
    p95: float


@dataclass(frozen=True)
class Instant:
    """A large error: s from the start of the session, keypoint, its error (m), state, claimed
    standard deviation per coordinate (m) and speed."""

    t: float
    keypoint: str
    error: float
    state: str
    sd: float
    speed: float


@dataclass(frozen=True, eq=False)
class Measured:
    """All results of one hand of one session. ``calibration``: the share of errors within each of
    `MULTIPLES`; ``bland_altman`` and ``distances`` are what figures show."""

    pairs: Pairs
    points: tuple[PointRow, ...]
    scalars: tuple[ScalarRow, ...]
    speeds: tuple[Bin, ...]
    states: tuple[Bin, ...]
    calibration: tuple[float, ...]
    nees: float
    worst: tuple[Instant, ...]
    quantities: tuple[Quantity, ...] = field(repr=False, default=())

    def point(self, name: str) -> PointRow:
        return next(r for r in self.points if r.name == name)

    @property
    def whole(self) -> PointRow:
        """All keypoints together."""
        return self.point(ALL)

    @property
    def angle_rmse(self) -> float:
        """Root mean square over all joint angles, rad."""
        return rms(np.array([r.rmse for r in self.scalars if r.is_angle]))


def expected(multiples: Sequence[float] = MULTIPLES) -> Array:
    """The shares that correct standard deviations have: the distance of an error with the standard
    deviation σ per coordinate is within k √3 σ with the probability χ²₃(3 k²)."""
    return np.asarray(gammainc(1.5, 1.5 * np.asarray(multiples) ** 2))


def measure(pairs: Pairs, offsets: bool = True) -> Measured:
    """``offsets``: of the reference with its marker offsets, as estimated at the import."""
    e = pairs.errors(offsets)
    distance = np.linalg.norm(e, axis=2)
    quantities = pairs.quantities(offsets)
    ratio = distance / (np.sqrt(3) * np.maximum(pairs.sd, 1e-9))
    known = ratio[np.isfinite(ratio)]
    return Measured(
        pairs,
        tuple(_points(pairs, e, offsets)),
        tuple(_scalar(q) for q in quantities),
        tuple(_by_speed(distance, pairs.speed)),
        tuple(_by_state(distance, pairs.state)),
        tuple(float(np.mean(known <= k)) if len(known) else float("nan") for k in MULTIPLES),
        float(np.mean(known**2)) if len(known) else float("nan"),
        tuple(_worst(pairs, distance)),
        tuple(quantities),
    )


def _points(pairs: Pairs, e: Array, offsets: bool) -> list[PointRow]:
    rigid = np.linalg.norm(pairs.errors(False), axis=2)
    theirs = pairs.theirs if offsets else pairs.rigid
    rows = []
    for k, name in enumerate(pairs.names):
        known = np.isfinite(e[:, k]).all(axis=1)
        if not known.any():
            continue
        sizes = [effective_size(e[:, k, a]) for a in range(3)]
        n = min(sizes)
        iccs = [
            icc_2_1(np.column_stack([pairs.ours[:, k, a], theirs[:, k, a]]), n) for a in range(3)
        ]
        icc = min(iccs, key=lambda i: i.value if np.isfinite(i.value) else 2.0)
        axes = tuple(bland_altman(e[:, k, a], n_effective=sizes[a]) for a in range(3))
        rows.append(_point(name, np.linalg.norm(e[:, k], axis=1), rigid[:, k], n, axes, icc))
    return [*rows, _all_points(e, rigid)]


def _all_points(e: Array, rigid: Array) -> PointRow:
    """All keypoints; the errors of one instant count as one."""
    known = np.isfinite(e)
    count = known.sum(axis=1)
    mean = np.where(known, e, 0.0).sum(axis=1) / np.where(count > 0, count, np.nan)
    n = min(effective_size(mean[:, a]) for a in range(3))
    each = e.reshape(-1, 3)
    axes = tuple(bland_altman(each[:, a], n_effective=n) for a in range(3))
    none = Icc(float("nan"), (float("nan"), float("nan")), 0, 0.0)
    return _point(ALL, np.linalg.norm(each, axis=1), rigid.ravel(), n, axes, none)


def _point(
    name: str, distance: Array, rigid: Array, n: float, axes: tuple[Agreement, ...], icc: Icc
) -> PointRow:
    d = distance[np.isfinite(distance)]
    squared = bland_altman(d**2, n_effective=n)
    low, high = (float(np.sqrt(max(v, 0.0))) for v in squared.bias_ci)
    x, y, z = axes
    p95 = float(np.percentile(d, 95)) if len(d) else float("nan")
    return PointRow(name, len(d), n, rms(d), (low, high), rms(rigid), p95, (x, y, z), icc)


def _scalar(q: Quantity) -> ScalarRow:
    d = q.ours - q.theirs
    n = effective_size(d)
    icc = icc_2_1(np.column_stack([q.ours, q.theirs]), n)
    return ScalarRow(q.name, q.is_angle, rms(d), bland_altman(d, n_effective=n), icc)


def _by_speed(distance: Array, speed: Array) -> list[Bin]:
    out = []
    for low, high in itertools.pairwise(SPEEDS):
        name = f"{low:g} to {high:g} m/s" if np.isfinite(high) else f"above {low:g} m/s"
        out.append(_bin(name, distance, (speed >= low) & (speed < high)))
    return [b for b in out if b is not None]


def _by_state(distance: Array, state: IntArray) -> list[Bin]:
    out = [
        _bin(s.name.lower(), distance, state == s) for s in (Validity.MEASURED, Validity.INFERRED)
    ]
    return [b for b in out if b is not None]


def _bin(name: str, distance: Array, inside: Mask) -> Bin | None:
    known = np.isfinite(distance)
    d = distance[known & inside]
    if len(d) < _FEW:
        return None
    return Bin(name, len(d) / int(known.sum()), rms(d), float(np.percentile(d, 95)))


def _worst(pairs: Pairs, distance: Array) -> list[Instant]:
    """The largest errors, at most one within `APART`."""
    filled = np.where(np.isfinite(distance), distance, -1.0)
    column = filled.argmax(axis=1)
    largest = filled.max(axis=1)
    out: list[Instant] = []
    for i in np.argsort(-largest, kind="stable"):
        if largest[i] < 0 or len(out) == WORST:
            break
        if all(abs(pairs.t[i] - w.t) >= APART for w in out):
            k = int(column[i])
            state = Validity(int(pairs.state[i, k])).name.lower()
            sd, speed = float(pairs.sd[i, k]), float(pairs.speed[i, k])
            found = float(pairs.t[i]), pairs.names[k], float(largest[i])
            out.append(Instant(*found, state, sd, speed))
    return out


def worst_of(measured: Sequence[Measured]) -> list[tuple[Measured, Instant]]:
    """The largest errors of all recordings, with their recordings."""
    found = [(m, w) for m in measured for w in m.worst]
    return sorted(found, key=lambda of: -of[1].error)[:WORST]


@dataclass(frozen=True)
class SummaryRow:
    """One quantity over all recordings, with a random intercept per person."""

    name: str
    unit: str
    pooled: Pooled


def summary(measured: Sequence[Measured]) -> list[SummaryRow]:
    """Over the recordings of all people: RMSE of all keypoints and of each, RMSE and bias of joint
    angles. In mm and degrees. A recording without a participant is a person of its own."""
    people = [m.pairs.person or f"recording {i}" for i, m in enumerate(measured)]
    rows = []
    names = list(dict.fromkeys([ALL, *(r.name for m in measured for r in m.points)]))
    for name in names:
        values = [_value(m.points, name) for m in measured]
        rows.append(SummaryRow(f"RMSE {name}", "mm", _not_negative(values, people)))
    angles = [float(np.rad2deg(m.angle_rmse)) for m in measured]
    rows.append(SummaryRow("RMSE joint angles", "deg", _not_negative(angles, people)))
    for name in dict.fromkeys(r.name for m in measured for r in m.scalars if r.is_angle):
        found = [next((r for r in m.scalars if r.name == name), None) for m in measured]
        bias = [float("nan") if r is None else float(np.rad2deg(r.agreement.bias)) for r in found]
        rows.append(SummaryRow(f"bias {name}", "deg", random_intercept(bias, people)))
    return rows


def _not_negative(values: Sequence[float], people: Sequence[str]) -> Pooled:
    """For values that are not negative; nor is the interval, which is symmetric for few people."""
    found = random_intercept(values, people)
    return replace(found, ci=(max(found.ci[0], 0.0), found.ci[1]))


def _value(rows: Sequence[PointRow], name: str) -> float:
    return next((1e3 * r.rmse for r in rows if r.name == name), float("nan"))


def headline(measured: Sequence[Measured]) -> str:
    """One line that can be quoted."""
    minutes = sum(float(np.isfinite(m.pairs.errors()).any(axis=(1, 2)).mean())
                  * float(m.pairs.t[-1] - m.pairs.t[0]) for m in measured) / 60  # fmt: skip
    people = len({m.pairs.person or f"recording {i}" for i, m in enumerate(measured)})
    pooled = {row.name: row.pooled for row in summary(measured)}
    points, angles = pooled[f"RMSE {ALL}"], pooled["RMSE joint angles"]
    alone = len(measured) == 1
    ci = tuple(1e3 * v for v in measured[0].whole.rmse_ci) if alone else points.ci
    kinds = "simulated" if all(m.pairs.simulated for m in measured) else "recorded"
    programs = ", ".join(
        sorted({f"{m.pairs.engine} of Glovetrack {m.pairs.version}" for m in measured})
    )
    text = (
        f"RMSE of {_keypoints(measured)} keypoints against the reference: {points.mean:.1f} mm "
        f"(95 % interval {ci[0]:.1f} to {ci[1]:.1f} mm)"
    )
    if np.isfinite(angles.mean):
        text += f", joint angles {angles.mean:.1f}°"
    many = f"{len(measured)} {kinds} recording{'s' * (not alone)} of {people} "
    many += "person" if people == 1 else "people"
    return f"{text}; {many}, {minutes:.1f} min, {programs}."


def _keypoints(measured: Sequence[Measured]) -> str:
    counts = sorted({len(m.pairs.names) for m in measured})
    return str(counts[0]) if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
