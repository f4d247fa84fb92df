"""Measures the motion in a recording: ranges and speeds of angles, distances between points.

Angles in rad, lengths in m, times in s. Lost values are ignored; inferred ones are used, and their
share is given. Time without estimates (see `holes`) counts as lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.session.edits import Mask
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.holes import LONGEST_FILLED, time_shares, with_breaks
from tracker.session.reader import SessionReader

APERTURE = ("thumb_tip", "index_tip")
"""Points whose distance is the aperture of a grasp."""
SMOOTH = 0.05  # s over which a speed is computed, so that the noise of one estimate is not motion
Pair = tuple[str, str]


@dataclass(frozen=True, eq=False)
class Take:
    """N estimates: t (N,) s from the session's start; angles (N, J) rad, angle_state (N, J);
    points (N, K, 3) m in G, point_sd (N, K) m, point_state (N, K); NaN where lost. limits (J, 2)
    rad. angle_filled (N, J) and point_filled (N, K): interpolated by an edit; None without one."""

    t: Array
    angle_names: tuple[str, ...]
    angles: Array
    angle_state: IntArray
    limits: Array
    point_names: tuple[str, ...]
    points: Array
    point_sd: Array
    point_state: IntArray
    angle_filled: Mask | None = None
    point_filled: Mask | None = None


@dataclass(frozen=True)
class Measure:
    """Measures of one angle (rad) or distance (m) in a recording: least, greatest, mean and sd of
    its values; fastest change per s; shares of the time in which it was measured, inferred and
    lost; the mean standard deviation reported by the tracker, NaN without one; and the share of the
    time that was interpolated by an edit, part of the inferred share."""

    name: str
    is_angle: bool
    least: float
    greatest: float
    mean: float
    sd: float
    fastest: float
    measured: float
    inferred: float
    lost: float
    claimed_sd: float
    interpolated: float = 0.0

    @property
    def range(self) -> float:
        """Range of motion."""
        return self.greatest - self.least


def read_take(reader: SessionReader) -> Take:
    """Reads all estimates of a session. Raises FileError if there are none."""
    series, info = recorded_series(reader, segments=False), reader.info
    return Take(
        instants(reader, series),
        series.joint_names,
        series.angles,
        series.angle_state,
        info.hand.angle_limits,
        series.keypoint_names,
        series.keypoints,
        series.sd,
        series.state,
        None if series.angle_filled is None else series.angles_interpolated,
        None if series.point_filled is None else series.interpolated,
    )


def instants(reader: SessionReader, series: EstimateSeries) -> Array:
    """(N,) s from the session's start."""
    start = reader.anchor.monotonic(reader.span_ns[0])
    return np.array([reader.anchor.monotonic(int(s)) for s in series.stamp_ns]) - start


def take_of(
    estimates: Sequence[Estimate],
    angle_names: tuple[str, ...],
    limits: Array,
    point_names: tuple[str, ...],
    start: float,
) -> Take:
    """Converts estimates, in the order of their instants, to a Take; ``start`` is the engine's time
    of 0."""
    return Take(
        np.array([e.t for e in estimates]) - start,
        angle_names,
        np.array([e.angles for e in estimates]),
        np.array([e.angle_state for e in estimates]),
        limits,
        point_names,
        np.array([e.keypoints for e in estimates]),
        np.array([e.keypoint_sd for e in estimates]),
        np.array([e.keypoint_state for e in estimates]),
    )


def distance(take: Take, pair: Pair) -> tuple[Array, Array, IntArray]:
    """Returns (N,) m between two points, its sd (N,) m, and its state (N,), the worse of both.

    The sd assumes that the points' errors are independent: a common error, as of the hand's
    position, does not change a distance, so the true sd is smaller.
    """
    a, b = (take.point_names.index(name) for name in pair)
    away = np.linalg.norm(take.points[:, a] - take.points[:, b], axis=1)
    sd = np.hypot(take.point_sd[:, a], take.point_sd[:, b])
    return away, sd, np.minimum(take.point_state[:, a], take.point_state[:, b])


def speed(t: Array, values: Array) -> Array:
    """(N,) change per s of values (N,), over `SMOOTH` s, or from one neighbour to the other where
    those are farther apart; NaN in and next to holes."""
    out = np.full(len(t), np.nan)
    known = np.flatnonzero(np.isfinite(values))
    if len(known) < 2:
        return out
    at, x = t[known], values[known]
    before = np.searchsorted(at, at - 0.5 * SMOOTH - 1e-9)
    after = np.searchsorted(at, at + 0.5 * SMOOTH + 1e-9, side="right") - 1
    row, last = np.arange(len(at)), len(at) - 1
    is_slow = after - before < 2  # fewer values than SMOOTH needs
    before = np.where(is_slow, np.maximum(row - 1, 0), before)
    after = np.where(is_slow, np.minimum(row + 1, last), after)
    span = at[after] - at[before]
    jumps = np.concatenate([[0], np.cumsum(np.diff(at) > LONGEST_FILLED)])
    fine = (span > 0.3 * SMOOTH) & (jumps[after] == jumps[before])
    out[known[fine]] = (x[after] - x[before])[fine] / span[fine]
    return out


def curve(take: Take, values: Array, state: IntArray) -> tuple[Array, Array]:
    """Times and values (N,) of an angle or a distance to draw a line through: NaN where it is lost,
    and a break in each hole."""
    return with_breaks(take.t, np.where(state == Validity.LOST, np.nan, values))


def measures(take: Take, pairs: Sequence[Pair]) -> list[Measure]:
    """Measures of all angles, then of the distances between the points of each pair."""
    no_sd = np.full(len(take.t), np.nan)
    out = []
    for j, name in enumerate(take.angle_names):
        found = _measure(name, True, take.t, take.angles[:, j], take.angle_state[:, j], no_sd)
        filled = None if take.angle_filled is None else take.angle_filled[:, j]
        out.append(_with_filled(found, take, filled))
    for pair in pairs:
        away, sd, state = distance(take, pair)
        found = _measure(pair_name(pair), False, take.t, away, state, sd)
        out.append(_with_filled(found, take, distance_filled(take, pair)))
    return out


def distance_filled(take: Take, pair: Pair) -> Mask | None:
    """(N,) where one of both points was interpolated; None without an edit."""
    if take.point_filled is None:
        return None
    return np.asarray(take.point_filled[:, [take.point_names.index(n) for n in pair]].any(axis=1))


def _with_filled(measure: Measure, take: Take, filled: Mask | None) -> Measure:
    if filled is None:
        return measure
    return replace(measure, interpolated=float(time_shares(take.t)[filled].sum()))


def pair_name(pair: Pair) -> str:
    return f"{pair[0]} - {pair[1]}"


def pair_of(name: str) -> Pair:
    """The inverse of `pair_name`."""
    first, _, second = name.partition(" - ")
    return first, second


def _measure(
    name: str, is_angle: bool, t: Array, values: Array, state: IntArray, sd: Array
) -> Measure:
    known = np.isfinite(values) & (state != Validity.LOST)
    valid = np.where(known, values, np.nan)
    of_time = time_shares(t)
    shares = [
        float(of_time[known & (state == s)].sum()) for s in (Validity.MEASURED, Validity.INFERRED)
    ]
    if not known.any():
        nan = float("nan")
        return Measure(name, is_angle, nan, nan, nan, nan, nan, 0.0, 0.0, 1.0, nan)
    x, rate = values[known], speed(t, valid)
    fastest = float(np.nanmax(np.abs(rate))) if np.isfinite(rate).any() else float("nan")
    claimed = sd[known & np.isfinite(sd)]
    return Measure(
        name, is_angle, float(x.min()), float(x.max()), float(x.mean()), float(x.std()), fastest,
        shares[0], shares[1], 1.0 - sum(shares), float(claimed.mean()) if len(claimed) else np.nan,
    )  # fmt: skip


@dataclass(frozen=True)
class Units:
    """Units of printed numbers: ``degrees`` or rad; lengths are always in mm."""

    degrees: bool = True

    def angle(self, value: float) -> float:
        return float(np.rad2deg(value)) if self.degrees else value

    def of(self, value: float, is_angle: bool) -> float:
        """Formats an angle (rad) or length (m)."""
        return self.angle(value) if is_angle else value * 1000.0

    def name(self, is_angle: bool) -> str:
        return ("deg" if self.degrees else "rad") if is_angle else "mm"


COLUMNS = (
    "name", "unit", "min", "max", "range", "mean", "sd", "fastest_per_s", "measured_percent",
    "inferred_percent", "lost_percent", "claimed_sd", "interpolated_percent",
)  # fmt: skip


def table(rows: Sequence[Measure], units: Units, separator: str = ",") -> str:
    """A header and a line for each measure; cells are empty where nothing is known."""
    lines = [separator.join(COLUMNS)]
    for m in rows:
        values = (m.least, m.greatest, m.range, m.mean, m.sd, m.fastest)
        numbers = [_text(units.of(v, m.is_angle)) for v in values]
        shares = [_text(100 * share) for share in (m.measured, m.inferred, m.lost)]
        claimed = _text(units.of(m.claimed_sd, m.is_angle))
        filled = _text(100 * m.interpolated)
        cells = [m.name, units.name(m.is_angle), *numbers, *shares, claimed, filled]
        lines.append(separator.join(cells))
    return "\n".join(lines) + "\n"


def _text(value: float) -> str:
    return f"{value:.6g}" if np.isfinite(value) else ""
