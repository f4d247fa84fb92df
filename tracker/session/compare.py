"""What differs between two trackings of one movement, and between one and the truth."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from tracker.errors import FileError
from tracker.files import whole_file
from tracker.messages import Array, IntArray
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.reader import SessionReader

_ALIGNED_NS = 1_000_000


def compare(a: Path, b: Path, figure: Path | None = None, force: bool = False) -> dict[str, Any]:
    """Distances of keypoints (mm) and angles (deg) at the instants that both files have.

    ``figure``: a PNG or PDF of both over time, which replaces one only with ``force``. Raises
    FileError where nothing can be compared.
    """
    with SessionReader(a) as reader_a, SessionReader(b) as reader_b:
        first, second = (recorded_series(r) for r in (reader_a, reader_b))
        words = _metadata_changes(reader_a, reader_b)
        made_on = [r.metadata.get("arithmetic", "") for r in (reader_a, reader_b)]
    rows_a, rows_b = common_rows(first.stamp_ns, second.stamp_ns)
    if len(rows_a) == 0:
        raise FileError(f"{a} and {b} have no instant in common.")
    points, distance = _keypoint_distance(first, second, rows_a, rows_b)
    joints, turn = _angle_difference(first, second, rows_a, rows_b)
    if figure is not None:
        with whole_file(figure, force, [a, b]) as part:
            _draw(part, first.elapsed[rows_a], distance, turn, (a.name, b.name))
    return {
        "estimates": [len(first), len(second)],
        "compared": len(rows_a),
        "identical": _identical(first, second),
        "mean_mm": _mean(distance),
        "max_mm": _largest(distance),
        "rms_deg": float(np.sqrt(_mean(turn**2))),
        "keypoints_mm": {n: _mean(distance[:, i]) for i, n in enumerate(points)},
        "joints_rms_deg": {n: float(np.sqrt(_mean(turn[:, i] ** 2))) for i, n in enumerate(joints)},
        "differing": words,
        "made_on": made_on,
    }


def truth_error_mm(tracked: Path, truth: Path) -> dict[str, float]:
    """Mean distance (mm) of each keypoint of ``tracked`` from the truth that ``truth`` holds.

    Empty where it holds none or no instant is common; NaN for a keypoint that was always lost.
    Raises FileError if ``tracked`` holds no estimates.
    """
    with SessionReader(truth) as reader:
        true = list(reader.truth())
        names = reader.info.keypoint_names
        stamps = np.array([reader.anchor.wall(e.t) for e in true], np.int64)
    with SessionReader(tracked) as reader:
        series = recorded_series(reader)
    if not true:
        return {}
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
    pairs = [
        (a.stamp_ns, b.stamp_ns),
        (a.keypoints, b.keypoints),
        (a.q, b.q),
        (a.angles, b.angles),
        (a.state, b.state),
        (a.angle_state, b.angle_state),
    ]
    return a.keypoint_names == b.keypoint_names and all(
        np.array_equal(x, y, equal_nan=x.dtype.kind == "f") for x, y in pairs
    )


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


def _draw(path: Path, t: Array, distance: Array, turn: Array, names: tuple[str, str]) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 5), layout="constrained")
    FigureCanvasAgg(figure)
    figure.suptitle(f"{names[0]} against {names[1]}")
    upper, lower = figure.subplots(2, 1, sharex=True)
    for axes, values, label in (
        (upper, distance, "keypoint distance (mm)"),
        (lower, np.abs(turn), "angle difference (°)"),
    ):
        known = np.isfinite(values).any(axis=1)
        axes.plot(t[known], np.nanmean(values[known], axis=1), label="mean", lw=1)
        axes.plot(t[known], np.nanmax(values[known], axis=1), label="largest", lw=0.7)
        axes.set_ylabel(label)
        axes.grid(alpha=0.3)
    upper.legend(loc="upper right")
    lower.set_xlabel("time (s)")
    figure.savefig(path, dpi=120)
