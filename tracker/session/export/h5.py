"""HDF5: one array per quantity, with names and units as attributes; NaN where lost."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np

from tracker.messages import Validity
from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader

INTERPOLATED = "whether an edit filled a gap here"


def export_h5(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """``/stamp_ns``, ``/keypoints/{position,orientation,sd,state,interpolated}`` and
    ``/joints/{angle,state,interpolated}``."""
    m = load_series(reader, options)
    unit = options.units or "m"
    # Created in memory: if the disk fills up while the library writes, it aborts the program at
    # exit.
    with h5py.File(path.name, "w", driver="core", backing_store=False) as file:
        file.attrs["axes"] = str(m.notes["axes_are"])
        file.attrs["bone_axes"] = m.bone_axes
        file.create_dataset("stamp_ns", data=m.stamp_ns).attrs["unit"] = "ns since 1970"
        points = file.create_group("keypoints")
        points.attrs["names"] = list(m.keypoint_names)
        _put(points, "position", m.keypoints * UNITS[unit], unit)
        _put(points, "orientation", m.q, "quaternion x, y, z, w")
        _put(points, "sd", m.sd * UNITS[unit], unit)
        _put(points, "state", m.state.astype(np.int8), _states())
        _put(points, "interpolated", m.interpolated, INTERPOLATED)
        joints = file.create_group("joints")
        joints.attrs["names"] = list(m.joint_names)
        _put(joints, "angle", m.angles, "rad")
        _put(joints, "state", m.angle_state.astype(np.int8), _states())
        _put(joints, "interpolated", m.angles_interpolated, INTERPOLATED)
        file.flush()
        path.write_bytes(file.id.get_file_image())
    return m


def _put(group: h5py.Group, name: str, values: np.ndarray, unit: str) -> None:
    data = group.create_dataset(name, data=values, compression="gzip" if values.size else None)
    data.attrs["unit"] = unit


def _states() -> str:
    return ", ".join(f"{s.value} {s.name.lower()}" for s in Validity)
