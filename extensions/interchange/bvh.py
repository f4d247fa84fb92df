"""Exports BVH: a skeleton with one rotation per joint, in cm, y up.

A bone whose length was changed by the calibration also has positions, which replace its offset. BVH
cannot mark a joint as lost: it does not move, and ``holes_s`` in the JSON file next to the BVH file
lists the periods.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from extensions.interchange.skeleton import Skeleton, skeleton
from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader

_TURN = "Zrotation Yrotation Xrotation"


def export_bvh(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    m = load_series(reader, replace(options, joints=()), even=True, axes="y-up", segments=True)
    tree, scale = skeleton(m), UNITS[options.units or "cm"]
    lines = ["HIERARCHY"]
    order: list[int] = []
    _joint(tree, 0, 0, scale, lines, order)
    lines += ["MOTION", f"Frames: {len(m)}", f"Frame Time: {1 / m.rate:.9f}"]
    columns: list[np.ndarray] = []
    for i in order:
        if _moves(tree, i):
            columns.append(tree.translation[:, i] * scale)
        columns.append(_euler_deg(tree.rotation[:, i]))
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write("\n".join(lines) + "\n")
        np.savetxt(out, np.column_stack(columns), fmt="%.6f")
    return replace(m, notes={**m.notes, **tree.notes(m.elapsed)})


def _moves(tree: Skeleton, i: int) -> bool:
    return tree.parent[i] < 0 or bool(tree.stretches[i])


def _joint(
    tree: Skeleton, i: int, depth: int, scale: float, lines: list[str], order: list[int]
) -> None:
    """Write joint ``i`` and its children; ``order`` collects joints in the order of channels."""
    pad, children = "  " * depth, tree.children(i)
    offset = tree.offset[i] * scale if depth else np.zeros(3)
    lines += [f"{pad}{'JOINT' if depth else 'ROOT'} {tree.names[i]}", f"{pad}{{"]
    lines.append(f"{pad}  OFFSET {_numbers(offset)}")
    place = "6 Xposition Yposition Zposition" if _moves(tree, i) else "3"
    lines.append(f"{pad}  CHANNELS {place} {_TURN}")
    order.append(i)
    for child in children:
        _joint(tree, child, depth + 1, scale, lines, order)
    if not children:
        lines += [f"{pad}  End Site", f"{pad}  {{", f"{pad}    OFFSET {_numbers(np.zeros(3))}"]
        lines.append(f"{pad}  }}")
    lines.append(f"{pad}}}")


def _numbers(values: np.ndarray) -> str:
    return " ".join(f"{v:.6f}" for v in values)


def _euler_deg(q: np.ndarray) -> np.ndarray:
    """Angles (N, 3) in degrees about z, then y, then x (intrinsic)."""
    return Rotation.from_quat(q).as_euler("ZYX", degrees=True)
