"""How far a tracking is from what the simulated hand really did."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracker.session.compare import common_rows
from tracker.session.export.motion import ExportOptions, load_motion
from tracker.session.reader import SessionReader


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
        motion = load_motion(reader, ExportOptions())
    if not true:
        return {}
    rows, true_rows = common_rows(motion.stamp_ns, stamps)
    if len(rows) == 0:
        return {}
    keypoints = np.array([e.keypoints for e in true])
    common = [n for n in motion.keypoint_names if n in names]
    mine = motion.keypoints[rows][:, [motion.keypoint_names.index(n) for n in common]]
    theirs = keypoints[true_rows][:, [names.index(n) for n in common]]
    distance_mm = 1e3 * np.linalg.norm(mine - theirs, axis=2)
    known = np.isfinite(distance_mm)
    total = np.where(known, distance_mm, 0.0).sum(axis=0)
    mean = np.where(known.any(axis=0), total / np.maximum(known.sum(axis=0), 1), np.nan)
    return {n: float(m) for n, m in zip(common, mean, strict=True)}
