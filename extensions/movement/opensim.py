"""Exports OpenSim tables: marker trajectories (TRC) and joint angles (MOT)."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracker.session.export.load import load_series
from tracker.session.export.markers import carried_markers, dorsal_points
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader


def export_trc(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write keypoints and, unless joints are selected by name, the glove's markers and a point
    above each segment, from which inverse kinematics recovers the angles."""
    m = load_series(reader, options, even=True, axes="opensim", segments=True)
    unit = options.units or "mm"
    names, points = m.keypoint_names, m.keypoints
    if not options.joints:
        on = carried_markers(reader, m), dorsal_points(reader, m)
        names = (*names, *on[0].names, *on[1].names)
        points = np.concatenate([points, *(k.position for k in on)], axis=1)
    rows = points.reshape(len(m), -1) * UNITS[unit]
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write(_header(m, names, path.name, unit))
        for i, t in enumerate(m.elapsed):
            cells = [f"{v:.6f}" if np.isfinite(v) else "" for v in rows[i]]
            # OpenSim ignores an empty cell at the end of a line, so every cell ends with a tab
            out.write("\t".join([str(i + 1), f"{t:.6f}", *cells]) + "\t\n")
    return m


def _header(m: EstimateSeries, markers: tuple[str, ...], name: str, unit: str) -> str:
    rate, n, points = f"{m.rate:.6g}", len(m), len(markers)
    keys = ["DataRate", "CameraRate", "NumFrames", "NumMarkers", "Units"]
    keys += ["OrigDataRate", "OrigDataStartFrame", "OrigNumFrames"]
    values = [rate, rate, str(n), str(points), unit, rate, "1", str(n)]
    names = ["Frame#", "Time", *(f"{k}\t\t" for k in markers)]
    axes = ["", "", *(f"{c}{k}" for k in range(1, points + 1) for c in "XYZ")]
    lines = (["PathFileType", "4", "(X/Y/Z)", name], keys, values, names, axes)
    return "\n".join("\t".join(line) for line in lines) + "\n\n"


def export_mot(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    m = load_series(reader, options)
    names = ["time", *m.joint_names]
    head = [path.stem, "version=1", f"nRows={len(m)}", f"nColumns={len(names)}", "inDegrees=yes"]
    table = np.column_stack([m.elapsed, np.rad2deg(m.angles)])
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write("\n".join([*head, "endheader", "\t".join(names)]) + "\n")
        np.savetxt(out, table, fmt="%.8g", delimiter="\t")
    return m
