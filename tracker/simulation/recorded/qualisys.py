"""Qualisys Track Manager's TSV export: markers of a glove in mm, z up."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracker.base.errors import FileError
from tracker.simulation.recorded.track import PointTrack

FINGERS = ("thumb", "index", "middle", "ring", "little")
_PLACE = {"tip": "tip", "middle": "pip"}


def read_qualisys(path: Path, text: str) -> PointTrack:
    """Markers <finger>_middle, <finger>_tip and hand_*; missing ones are 0 or empty."""
    lines = text.splitlines()
    header = {line.split("\t")[0]: line.split("\t")[1:] for line in lines[:12] if line}
    if "MARKER_NAMES" not in header or "FREQUENCY" not in header:
        raise FileError(f"{path} has no MARKER_NAMES or FREQUENCY line: not a Qualisys TSV file.")
    names = header["MARKER_NAMES"]
    rows = [line.split("\t") for line in lines[11:] if line and line[0].isdigit()]
    try:
        rate = float(header["FREQUENCY"][0])
        table = np.array([[float(c or 0) for c in r] for r in rows])
    except ValueError as error:
        raise FileError(f"{path} holds something that is no number: {error}.") from error
    columns = table.shape[1] - 3 * len(names) if table.ndim == 2 else -1
    if columns not in (0, 2):
        raise FileError(f"{path} does not hold three columns for each of its markers.")
    points = table[:, columns:].reshape(len(table), len(names), 3)
    points[np.all(points == 0, axis=2)] = np.nan
    kept = {i: target for i, n in enumerate(names) if (target := _target(n))}
    return PointTrack(
        np.arange(len(table)) / rate, points[:, list(kept)], tuple(kept.values()),
        np.array([0.0, 0, 1]), "right", 1e-3,
    )  # fmt: skip


def _target(name: str) -> str | None:
    """Where on the hand a marker sits, None if elsewhere."""
    finger, _, place = name.partition("_")
    if finger == "hand":
        return f"dorsum:{place}"
    if finger in FINGERS and place in _PLACE:
        part = "ip" if finger == "thumb" and place == "middle" else _PLACE[place]
        return f"{finger}_{part}"
    return None
