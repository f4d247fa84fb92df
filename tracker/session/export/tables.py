"""CSV and Parquet: one row per estimate, the same columns; a lost cell is empty or null."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array, Validity
from tracker.session.edits import Mask
from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries, seconds_text, state_names
from tracker.session.reader import SessionReader

NUMBERS = ("x", "y", "z", "qx", "qy", "qz", "qw", "sd")
"""The numbers of each keypoint: its position, the bone's orientation, and its sd."""


def numbered(m: EstimateSeries) -> tuple[str, ...]:
    """The columns `NUMBERS` and, for OpenXR's joints, their radius."""
    return NUMBERS if m.radius is None else (*NUMBERS, "radius")


def columns(m: EstimateSeries) -> list[str]:
    """Names of the columns: time, keypoints with their state, angles with their state."""
    points = [f"{k}_{c}" for k in m.keypoint_names for c in (*numbered(m), "state")]
    return ["t", *points, *(c for j in m.joint_names for c in (j, f"{j}_state"))]


def _numbers(m: EstimateSeries, scale: float) -> Array:
    """(N, K, n) of `numbered`; lengths times ``scale``."""
    sd = np.where(np.isfinite(m.keypoints).all(axis=2), m.sd, np.nan)
    parts = [m.keypoints * scale, m.q, sd[..., None] * scale]
    if m.radius is not None:
        radius = np.where(m.state == Validity.LOST, np.nan, m.radius)
        parts.append(radius[..., None] * scale)
    return np.concatenate(parts, axis=2)


def export_csv(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """``t`` is in seconds since 1970 to the microsecond; positions in m unless ``options`` has
    other units."""
    m = load_series(reader, options)
    numbers = _numbers(m, UNITS[options.units or "m"])
    points, angles = m.interpolated, m.angles_interpolated
    with path.open("w", encoding="utf-8", newline="") as out:
        csv.writer(out, lineterminator="\n").writerow(columns(m))
        for i in range(len(m)):
            filled = points[i], angles[i]
            out.write(",".join(_row(m, i, numbers[i], filled)) + "\n")
    return m


def _row(m: EstimateSeries, i: int, numbers: Array, filled: tuple[Mask, Mask]) -> list[str]:
    """``filled``: (K,) keypoints and (J,) angles that are interpolated."""
    cells = [seconds_text(int(m.stamp_ns[i]))]
    for point, state in zip(numbers, state_names(m.state[i], filled[0]), strict=True):
        cells += [_cell(float(v)) for v in point]
        cells.append(state)
    for angle, state in zip(m.angles[i], state_names(m.angle_state[i], filled[1]), strict=True):
        cells += [_cell(float(angle)), state]
    return cells


def _cell(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.9g}"


def export_parquet(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """``t`` is a UTC timestamp; states are dictionary-encoded names; the schema's metadata contains
    axes and units. Raises ConfigError without the extra ``parquet``.
    """
    pa, pq = arrow()
    m = load_series(reader, options)
    unit = options.units or "m"
    numbers = _numbers(m, UNITS[unit])
    points, angles = m.interpolated, m.angles_interpolated
    table: dict[str, Any] = {"t": pa.array(m.stamp_ns, pa.timestamp("ns", "UTC"))}
    for k, name in enumerate(m.keypoint_names):
        for c, what in enumerate(numbered(m)):
            table[f"{name}_{what}"] = pa.array(numbers[:, k, c], from_pandas=True)
        names = state_names(m.state[:, k], points[:, k])
        table[f"{name}_state"] = pa.array(names).dictionary_encode()
    for j, name in enumerate(m.joint_names):
        table[name] = pa.array(m.angles[:, j], from_pandas=True)
        names = state_names(m.angle_state[:, j], angles[:, j])
        table[f"{name}_state"] = pa.array(names).dictionary_encode()
    pq.write_table(pa.table(table).replace_schema_metadata(_metadata(m, unit)), path)
    return m


def _metadata(m: EstimateSeries, unit: str) -> dict[str, str]:
    """Metadata that describe the columns."""
    return {
        "axes": str(m.notes["axes_are"]),
        "bone_axes": m.bone_axes,
        "length_unit": unit,
        "angle_unit": "rad",
        "quaternion": "x, y, z, w of the bone that begins at the keypoint",
        "sd": "root of the mean variance of the keypoint's position",
    }


def arrow() -> tuple[ModuleType, ModuleType]:
    """Imports Arrow, which takes 165 MB and is needed for Parquet only. Raises ConfigError if it is
    missing."""
    try:
        import pyarrow.parquet  # deferred: an extra
    except ImportError as error:
        raise ConfigError(notice("export.needs_arrow")) from error
    return pyarrow, pyarrow.parquet
