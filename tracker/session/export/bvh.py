"""BVH: a skeleton with one rotation per joint, cm, y up.

BVH knows no lost joint: it keeps its last angle, and the JSON beside the file counts how often.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.export.skeleton import Skeleton, skeleton
from tracker.session.reader import SessionReader

_TURN = "Zrotation Yrotation Xrotation"


def export_bvh(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    m = load_series(reader, replace(options, joints=()), even=True, axes="y-up")
    tree, scale = skeleton(m), UNITS[options.units or "cm"]
    lines = ["HIERARCHY"]
    order: list[int] = []
    _joint(tree, 0, 0, scale, lines, order)
    lines += ["MOTION", f"Frames: {len(m)}", f"Frame Time: {1 / m.rate:.9f}"]
    table = np.column_stack([tree.root * scale, *(_euler_deg(tree.rotation[:, i]) for i in order)])
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write("\n".join(lines) + "\n")
        np.savetxt(out, table, fmt="%.6f")
    return replace(m, notes={**m.notes, "held": tree.held})


def _joint(
    tree: Skeleton, i: int, depth: int, scale: float, lines: list[str], order: list[int]
) -> None:
    """Write joint ``i`` and what hangs on it; ``order`` collects joints as their channels go."""
    pad, children = "  " * depth, tree.children(i)
    kind = f"{'ROOT' if depth == 0 else 'JOINT'} {tree.names[i]}" if children else "End Site"
    offset = " ".join(f"{v:.6f}" for v in tree.offset[i] * scale)
    lines += [f"{pad}{kind}", f"{pad}{{", f"{pad}  OFFSET {offset}"]
    if children:
        order.append(i)
        place = "6 Xposition Yposition Zposition" if depth == 0 else "3"
        lines.append(f"{pad}  CHANNELS {place} {_TURN}")
        for child in children:
            _joint(tree, child, depth + 1, scale, lines, order)
    lines.append(f"{pad}}}")


def _euler_deg(q: np.ndarray) -> np.ndarray:
    """(N, 3) degrees about z, then y, then x, each about the turned axes."""
    return Rotation.from_quat(q).as_euler("ZYX", degrees=True)
