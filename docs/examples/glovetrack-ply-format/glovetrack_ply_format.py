"""An export format for Glovetrack: the paths of all keypoints as a PLY point cloud.

Each point has the time since the first estimate in s and the number of its keypoint; the header
names the keypoints. Lost points are left out. Blender, MeshLab and Open3D read the file.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from glovetrack.formats import (
    UNITS,
    EstimateSeries,
    ExportFormat,
    ExportOptions,
    SessionReader,
    Writer,
    load_series,
)

HEADER = """ply
format ascii 1.0
{comments}
element vertex {count}
property double x
property double y
property double z
property double time
property int keypoint
end_header
"""


def export_ply(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write one hand. `load_series` has applied the range, rate, axes and joints of ``options``."""
    series = load_series(reader, options)
    points = series.keypoints * UNITS[options.units or "m"]
    row, keypoint = np.nonzero(np.isfinite(points).all(axis=2))
    comments = [f"comment keypoint {i} {name}" for i, name in enumerate(series.keypoint_names)]
    table = np.column_stack([points[row, keypoint], series.elapsed[row], keypoint])
    with path.open("w", encoding="ascii", newline="\n") as out:
        out.write(HEADER.format(comments="\n".join(comments), count=len(table)))
        np.savetxt(out, table, fmt=["%.6f"] * 4 + ["%d"])
    return series


def _writer() -> Writer:
    """Called when somebody exports; import here what takes long to import."""
    return export_ply


PLY = ExportFormat("ply", "Paths of the keypoints (PLY)", _writer)
