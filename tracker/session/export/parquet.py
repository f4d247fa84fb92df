"""Parquet with the columns of the CSV; lost is null, times are whole nanoseconds."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracker.session.export.motion import UNITS, ExportOptions, Motion, load_motion, state_words
from tracker.session.export.parquet_file import Column, Numbers, Times, Words, write_parquet
from tracker.session.reader import SessionReader


def export_parquet(reader: SessionReader, path: Path, options: ExportOptions) -> Motion:
    """``t`` is a UTC timestamp; ``<keypoint>_state`` a word."""
    m = load_motion(reader, options)
    scale = UNITS[options.units or "m"]
    table: list[Column] = [Times("t", m.stamp_ns)]
    for k, name in enumerate(m.keypoint_names):
        for c, axis in enumerate("xyz"):
            table.append(Numbers(f"{name}_{axis}", m.keypoints[:, k, c] * scale))
        table.append(Words(f"{name}_state", np.asarray(state_words(m.state[:, k]))))
    for j, name in enumerate(m.joint_names):
        table.append(Numbers(name, m.angles[:, j]))
    write_parquet(path, table)
    return m
