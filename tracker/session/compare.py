"""Compares two trackings of one movement, or a tracking with the truth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.files import whole_file
from tracker.base.notices import notice
from tracker.messages import Array, IntArray
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.holes import LONGEST_FILLED
from tracker.session.reader import SessionReader

_ALIGNED_NS = 1_000_000


def compare(
    a: Path, b: Path, figure: Path | None = None, force: bool = False, shift_s: float = 0.0
) -> dict[str, Any]:
    """Returns distances of keypoints (mm) and angles (deg) at the common instants of two files.

    In sessions of both hands each hand is compared: ``hands`` contains the report of each, by side;
    the other values are for both hands: the worse or the mean of the two. ``figure``: a PNG or PDF
    of both over time, which replaces an existing one only with ``force``. ``shift_s`` is added to
    the stamps of ``b``, whose values are then interpolated linearly (see `align`). Raises FileError
    if nothing can be compared.
    """
    sides = _common_sides(a, b)
    found, curves = {}, []
    for side in sides:
        found[side], curve = _compare_hand(a, b, side, shift_s)
        curves.append(curve)
    if figure is not None:
        names = [f"{a.name} against {b.name}" + (f", {side}" if side else "") for side in sides]
        with whole_file(figure, force, [a, b]) as part:
            _draw(part, curves, names)
    if len(found) == 1:
        return found[sides[0]]
    return _combine_hands(found)


class _Curves(NamedTuple):
    """t (N,) s, distance (N, K) mm, turn (N, J) deg."""

    t: Array
    distance: Array
    turn: Array


def _common_sides(a: Path, b: Path) -> list[str]:
    """The sides of sessions of both hands; one empty name if neither file is one."""
    with SessionReader(a) as first, SessionReader(b) as second:
        if not first.sides and not second.sides:
            return [""]
        of = [reader.sides or (reader.info.side,) for reader in (first, second)]
    common = [side for side in of[0] if side in of[1]]
    if not common:
        raise FileError(notice("compare.no_hand", first=a, second=b))
    return common


def _compare_hand(a: Path, b: Path, side: str, shift_s: float) -> tuple[dict[str, Any], _Curves]:
    """Compares one hand."""
    with _of_side(a, side) as reader_a, _of_side(b, side) as reader_b:
        first, second = (recorded_series(r, segments=False) for r in (reader_a, reader_b))
        changes = _metadata_changes(reader_a, reader_b)
        made_on = [r.metadata.get("arithmetic", "") for r in (reader_a, reader_b)]
    second = _shifted(second, first.stamp_ns, shift_s) if shift_s else second
    rows_a, rows_b = common_rows(first.stamp_ns, second.stamp_ns)
    if len(rows_a) == 0:
        raise FileError(notice("compare.no_instant", first=a, second=b))
    points, distance = _keypoint_distance(first, second, rows_a, rows_b)
    joints, turn = _angle_difference(first, second, rows_a, rows_b)
    report = {
        "estimates": [len(first), len(second)],
        "compared": len(rows_a),
        "identical": _identical(first, second),
        "first_difference_s": _first_difference(first, second, rows_a, rows_b),
        "mean_mm": _mean(distance),
        "max_mm": _largest(distance),
        "rms_deg": float(np.sqrt(_mean(turn**2))),
        "keypoints_mm": {n: _mean(distance[:, i]) for i, n in enumerate(points)},
        "joints_rms_deg": {n: float(np.sqrt(_mean(turn[:, i] ** 2))) for i, n in enumerate(joints)},
        "differing": changes,
        "made_on": made_on,
    }
    return report, _Curves(first.elapsed[rows_a], distance, turn)


def _of_side(path: Path, side: str) -> SessionReader:
    reader = SessionReader(path)
    if not side or not reader.sides:
        return reader
    reader.close()
    return SessionReader(path, side=side)


def _combine_hands(found: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """Combines the reports of both hands."""
    hands = list(found.values())
    return {
        "hands": found,
        "compared": sum(h["compared"] for h in hands),
        "identical": all(h["identical"] for h in hands),
        "first_difference_s": min(
            (h["first_difference_s"] for h in hands if h["first_difference_s"] is not None),
            default=None,
        ),
        "mean_mm": float(
            np.average([h["mean_mm"] for h in hands], weights=[h["compared"] for h in hands])
        ),
        "max_mm": max(h["max_mm"] for h in hands),
        "rms_deg": max(h["rms_deg"] for h in hands),
        "differing": hands[0]["differing"],
        "made_on": hands[0]["made_on"],
    }


def _shifted(m: EstimateSeries, stamp_ns: IntArray, shift_s: float) -> EstimateSeries:
    """The estimates at those of ``stamp_ns`` at which they are known after their own stamps are
    shifted."""
    own = m.stamp_ns + round(shift_s * NS)
    m = m.rows(np.flatnonzero(np.diff(own, prepend=own[0] - 1) > 0))
    own = m.stamp_ns + round(shift_s * NS)
    inside = stamp_ns[(stamp_ns >= own[0]) & (stamp_ns <= own[-1])]
    if len(inside) == 0:
        return replace(m, stamp_ns=own)
    zero = own[0]
    t, at = (own - zero) / NS, (inside - zero) / NS
    nearest = np.clip(np.searchsorted((t[1:] + t[:-1]) / 2, at), 0, len(t) - 1)
    return replace(
        m.rows(nearest),
        stamp_ns=inside,
        keypoints=_interpolated(t, m.keypoints, at),
        angles=_interpolated(t, m.angles, at),
    )


def _interpolated(t: Array, values: Array, at: Array) -> Array:
    """Interpolates values (N, …) linearly; NaN next to a lost value, and in holes."""
    after = np.clip(np.searchsorted(t, at), 1, max(len(t) - 1, 1))
    if len(t) < 2:
        return values[np.zeros(len(at), np.int64)]
    step = t[after] - t[after - 1]
    share = ((at - t[after - 1]) / step).reshape(-1, *[1] * (values.ndim - 1))
    out = values[after - 1] * (1 - share) + values[after] * share
    out[step > LONGEST_FILLED] = np.nan
    return np.asarray(out)


def truth_error_mm(tracked: Path, truth: Path, also_in: Path | None = None) -> dict[str, float]:
    """Returns the mean distance (mm) of each keypoint of ``tracked`` from the truth in ``truth``,
    at the instants that are in ``also_in`` too.

    Empty without truth or common instants; NaN for a keypoint that was always lost. Raises
    FileError if ``tracked`` contains no estimates.
    """
    with SessionReader(truth) as reader:
        true = list(reader.truth())
        names = reader.info.keypoint_names
        stamps = np.array([reader.anchor.wall(e.t) for e in true], np.int64)
    with SessionReader(tracked) as reader:
        series = recorded_series(reader, segments=False)
    if not true:
        return {}
    if also_in is not None:
        with SessionReader(also_in) as reader:
            other = recorded_series(reader, segments=False)
        series = series.rows(common_rows(series.stamp_ns, other.stamp_ns)[0])
    rows, true_rows = common_rows(series.stamp_ns, stamps)
    if len(rows) == 0:
        return {}
    keypoints = np.array([e.keypoints for e in true])
    common = [n for n in series.keypoint_names if n in names]
    mine = series.keypoints[rows][:, [series.keypoint_names.index(n) for n in common]]
    theirs = keypoints[true_rows][:, [names.index(n) for n in common]]
    distance_mm = 1e3 * np.linalg.norm(mine - theirs, axis=2)
    known = np.isfinite(distance_mm)
    total = np.where(known, distance_mm, 0.0).sum(axis=0)
    mean = np.where(known.any(axis=0), total / np.maximum(known.sum(axis=0), 1), np.nan)
    return {n: float(m) for n, m in zip(common, mean, strict=True)}


def common_rows(a: IntArray, b: IntArray) -> tuple[IntArray, IntArray]:
    """Rows of both whose stamps (ns, rising) agree within a millisecond."""
    nearest = np.clip(np.searchsorted((b[1:] + b[:-1]) // 2, a), 0, len(b) - 1)
    close = np.abs(b[nearest] - a) <= _ALIGNED_NS
    return np.flatnonzero(close), nearest[close]


def _keypoint_distance(
    a: EstimateSeries, b: EstimateSeries, rows_a: IntArray, rows_b: IntArray
) -> tuple[list[str], Array]:
    names = [n for n in a.keypoint_names if n in b.keypoint_names]
    ia = [a.keypoint_names.index(n) for n in names]
    ib = [b.keypoint_names.index(n) for n in names]
    gap = a.keypoints[rows_a][:, ia] - b.keypoints[rows_b][:, ib]
    return names, np.linalg.norm(gap, axis=2) * 1000


def _angle_difference(
    a: EstimateSeries, b: EstimateSeries, rows_a: IntArray, rows_b: IntArray
) -> tuple[list[str], Array]:
    names = [n for n in a.joint_names if n in b.joint_names]
    ia = [a.joint_names.index(n) for n in names]
    ib = [b.joint_names.index(n) for n in names]
    return names, np.rad2deg(a.angles[rows_a][:, ia] - b.angles[rows_b][:, ib])


def _identical(a: EstimateSeries, b: EstimateSeries) -> bool:
    """Whether every number and state is the same to the last bit."""
    return (
        a.keypoint_names == b.keypoint_names
        and np.array_equal(a.stamp_ns, b.stamp_ns)
        and not _differs(a, b).any()
    )


def _first_difference(
    a: EstimateSeries, b: EstimateSeries, rows_a: IntArray, rows_b: IntArray
) -> float | None:
    """Returns the time (s) from the first estimate of ``a`` to the first common instant at which a
    value or a state differs; None if the estimates are identical or have different keypoints."""
    if a.keypoint_names != b.keypoint_names or a.joint_names != b.joint_names:
        return None
    found = np.flatnonzero(_differs(a.rows(rows_a), b.rows(rows_b)))
    return float(a.elapsed[rows_a[found[0]]]) if len(found) else None


def _differs(a: EstimateSeries, b: EstimateSeries) -> NDArray[np.bool_]:
    """(N,) whether any bit of an estimate differs; both have the same instants and names."""
    out = np.zeros(len(a), bool)
    for name in ("keypoints", "q", "sd", "angles", "state", "angle_state"):
        x, y = getattr(a, name).reshape(len(a), -1), getattr(b, name).reshape(len(b), -1)
        both_nan = (x != x) & (y != y)
        out |= ((x != y) & ~both_nan).any(axis=1)
    return out


def _metadata_changes(a: SessionReader, b: SessionReader) -> list[str]:
    """Names of metadata and attachments that are not the same."""
    out = [
        key for key in ("engine", "version") if a.metadata.get(key, "") != b.metadata.get(key, "")
    ]
    names = sorted({*a.attachments, *b.attachments})
    return out + [n for n in names if a.attachments.get(n) != b.attachments.get(n)]


def _mean(values: Array) -> float:
    return float(np.nanmean(values)) if np.isfinite(values).any() else float("nan")


def _largest(values: Array) -> float:
    return float(np.nanmax(values)) if np.isfinite(values).any() else float("nan")


def _draw(path: Path, curves: Sequence[_Curves], titles: Sequence[str]) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # deferred: slow to load
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 5 * len(curves)), layout="constrained")
    FigureCanvasAgg(figure)
    panes = figure.subplots(2 * len(curves), 1, sharex=True, squeeze=False)[:, 0]
    for k, (one, title) in enumerate(zip(curves, titles, strict=True)):
        panes[2 * k].set_title(title)
        for axes, values, label in (
            (panes[2 * k], one.distance, "keypoint distance (mm)"),
            (panes[2 * k + 1], np.abs(one.turn), "angle difference (°)"),
        ):
            known = np.isfinite(values).any(axis=1)
            axes.plot(one.t[known], np.nanmean(values[known], axis=1), label="mean", lw=1)
            axes.plot(one.t[known], np.nanmax(values[known], axis=1), label="largest", lw=0.7)
            axes.set_ylabel(label)
            axes.grid(alpha=0.3)
        panes[2 * k].legend(loc="upper right")
    panes[-1].set_xlabel("time (s)")
    figure.savefig(path, dpi=120)
