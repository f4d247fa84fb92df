"""Parquet with the columns of the CSV; lost is null, times are whole nanoseconds."""

from __future__ import annotations

from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from tracker.session.export.motion import UNITS, ExportOptions, Motion, load_motion, state_words
from tracker.session.reader import SessionReader


def export_parquet(reader: SessionReader, path: Path, options: ExportOptions) -> Motion:
    """``t`` is a UTC timestamp; ``<keypoint>_state`` a dictionary of words."""
    m = load_motion(reader, options)
    scale = UNITS[options.units or "m"]
    table: dict[str, pa.Array] = {"t": pa.array(m.stamp_ns, pa.timestamp("ns", "UTC"))}
    for k, name in enumerate(m.keypoint_names):
        for c, axis in enumerate("xyz"):
            table[f"{name}_{axis}"] = pa.array(m.keypoints[:, k, c] * scale, from_pandas=True)
        table[f"{name}_state"] = pa.array(state_words(m.state[:, k])).dictionary_encode()
    for j, name in enumerate(m.joint_names):
        table[name] = pa.array(m.angles[:, j], from_pandas=True)
    pq.write_table(pa.table(table), path)
    return m
