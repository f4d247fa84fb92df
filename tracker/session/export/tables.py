"""CSV and Parquet: one row per estimate, the same columns; a lost cell is empty or null."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from types import ModuleType
from typing import Any

from tracker.errors import ConfigError
from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries, seconds_text, state_words
from tracker.session.reader import SessionReader


def columns(m: EstimateSeries) -> list[str]:
    """Names of the columns: time, keypoints with their state, angles."""
    points = [f"{k}_{c}" for k in m.keypoint_names for c in ("x", "y", "z", "state")]
    return ["t", *points, *m.joint_names]


def export_csv(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """``t`` is in seconds since 1970 to the microsecond; positions in m unless asked otherwise."""
    m = load_series(reader, options)
    scale = UNITS[options.units or "m"]
    with path.open("w", encoding="utf-8", newline="") as out:
        csv.writer(out, lineterminator="\n").writerow(columns(m))
        for i in range(len(m)):
            out.write(",".join(_row(m, i, scale)) + "\n")
    return m


def _row(m: EstimateSeries, i: int, scale: float) -> list[str]:
    cells = [seconds_text(int(m.stamp_ns[i]))]
    for point, state in zip(m.keypoints[i] * scale, state_words(m.state[i]), strict=True):
        cells += [_cell(float(v)) for v in point]
        cells.append(state)
    return cells + [_cell(float(a)) for a in m.angles[i]]


def _cell(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.9g}"


def export_parquet(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """``t`` is a UTC timestamp; ``<keypoint>_state`` a dictionary of words.

    ConfigError without the extra ``parquet``.
    """
    pa, pq = _arrow()
    m = load_series(reader, options)
    scale = UNITS[options.units or "m"]
    table: dict[str, Any] = {"t": pa.array(m.stamp_ns, pa.timestamp("ns", "UTC"))}
    for k, name in enumerate(m.keypoint_names):
        for c, axis in enumerate("xyz"):
            table[f"{name}_{axis}"] = pa.array(m.keypoints[:, k, c] * scale, from_pandas=True)
        table[f"{name}_state"] = pa.array(state_words(m.state[:, k])).dictionary_encode()
    for j, name in enumerate(m.joint_names):
        table[name] = pa.array(m.angles[:, j], from_pandas=True)
    pq.write_table(pa.table(table), path)
    return m


def _arrow() -> tuple[ModuleType, ModuleType]:
    """Arrow, which takes 165 MB and serves this format alone."""
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError as error:
        raise ConfigError("Parquet needs Arrow: install glovetrack[parquet].") from error
    return pyarrow, pyarrow.parquet
