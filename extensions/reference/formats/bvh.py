"""BVH: positions of joints and end sites by forward kinematics."""

from __future__ import annotations

from pathlib import Path

from extensions.reference.recording import ReferenceRecording
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.simulation.recorded.bvh import joint_positions

CENTIMETRE = 0.01  # m: BVH does not name its unit; most programs write centimetres


def read_bvh(path: Path, lines: list[str], unit: float = CENTIMETRE) -> ReferenceRecording:
    """``unit`` in m. An end site has the name of its joint with ``.end``. Raises FileError."""
    try:
        joints, t, positions = joint_positions("\n".join(lines))
    except (ValueError, IndexError, StopIteration) as error:
        raise FileError(notice("reference.not_readable", file=path, why=str(error))) from error
    return ReferenceRecording("BVH", tuple(j.name for j in joints), t, positions * unit).checked(
        path
    )
