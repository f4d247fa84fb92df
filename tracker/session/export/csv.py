"""Comma-separated values: one row per estimate, a lost cell empty."""

from __future__ import annotations

import math
from pathlib import Path

from tracker.session.export.motion import UNITS, ExportOptions, Motion, load_motion, state_words
from tracker.session.reader import SessionReader


def columns(m: Motion) -> list[str]:
    """Names of the columns: time, keypoints with their state, angles."""
    points = [f"{k}_{c}" for k in m.keypoint_names for c in ("x", "y", "z", "state")]
    return ["t", *points, *m.joint_names]


def export_csv(reader: SessionReader, path: Path, options: ExportOptions) -> Motion:
    """``t`` is in seconds since 1970 to the microsecond; positions in m unless asked otherwise."""
    m = load_motion(reader, options)
    scale = UNITS[options.units or "m"]
    with path.open("w", encoding="utf-8", newline="") as out:
        out.write(",".join(columns(m)) + "\n")
        for i in range(len(m)):
            out.write(",".join(_row(m, i, scale)) + "\n")
    return m


def seconds_text(ns: int) -> str:
    """Seconds to the microsecond; a float would not hold that many digits since 1970."""
    whole, micro = divmod(round(ns / 1000), 1_000_000)
    return f"{whole}.{micro:06d}"


def _row(m: Motion, i: int, scale: float) -> list[str]:
    cells = [seconds_text(int(m.stamp_ns[i]))]
    for point, state in zip(m.keypoints[i] * scale, state_words(m.state[i]), strict=True):
        cells += [_cell(float(v)) for v in point]
        cells.append(state)
    return cells + [_cell(float(a)) for a in m.angles[i]]


def _cell(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.9g}"
