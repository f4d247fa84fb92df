"""MOT/STO, joint angles for OpenSim: tab-separated, degrees; lost is NaN."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracker.session.export.motion import ExportOptions, Motion, load_motion
from tracker.session.reader import SessionReader


def export_mot(reader: SessionReader, path: Path, options: ExportOptions) -> Motion:
    m = load_motion(reader, options)
    names = ["time", *m.joint_names]
    head = [path.stem, "version=1", f"nRows={len(m)}", f"nColumns={len(names)}", "inDegrees=yes"]
    table = np.column_stack([m.elapsed, np.rad2deg(m.angles)])
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write("\n".join([*head, "endheader", "\t".join(names)]) + "\n")
        np.savetxt(out, table, fmt="%.8g", delimiter="\t")
    return m
