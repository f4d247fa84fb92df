"""Exports C3D: keypoints and the glove's markers as points, angles and IMUs as analogue channels,
notes as events. As the format defines it, a point's residual is its standard deviation if it was
measured, 0 if it was inferred or interpolated, and -1 if it was lost."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import NamedTuple

import ezc3d
import numpy as np

from tracker.base.files import DiskError
from tracker.base.notices import notice
from tracker.messages import Array, IntArray, Validity
from tracker.session.export.load import load_series
from tracker.session.export.markers import carried_markers
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.raw_imu import MARKS, read_notes, read_raw_imu
from tracker.session.reader import SessionReader

_BLOCK = 512  # bytes: the unit of positions in a C3D file
_DATA_START = 16  # byte of the header with the number of the first data block, from 1
_RESIDUALS = (1.0, 127.0)  # range of the byte for measured points; 0 would mean inferred
_MEASURED_MM = 1.0  # residual of a measured point without a standard deviation
_UNITS = {"acc": "m/s^2", "gyr": "rad/s"}


class _Points(NamedTuple):
    """names (K,), position (N, K, 3) m, state (N, K), sd (N, K) m, descriptions (K,)."""

    names: list[str]
    position: Array
    state: IntArray
    sd: Array
    descriptions: list[str]


def export_c3d(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write the file. A lost point is invalid (residual -1, NaN), never at the origin.

    Markers and IMUs are omitted if ``options`` select joints.
    """
    m = load_series(reader, options, even=True, segments=True)
    points = _points(reader, m, bool(options.joints))
    names, values, units = _analogs(reader, m, bool(options.joints))
    unit = options.units or "mm"
    file = ezc3d.c3d()
    _put_points(file, points, unit, m.rate)
    file["parameters"]["ANALOG"]["RATE"]["value"] = [m.rate]
    file["parameters"]["ANALOG"]["LABELS"]["value"] = names
    file["parameters"]["ANALOG"]["UNITS"]["value"] = units
    file["data"]["analogs"] = values.T[None]
    _add_parameters(file, m)
    if "notes" not in options.anonymous:
        _put_events(file, reader, m)
    _put_gaps(file, m)
    file.write(str(path))
    _check(path, file)
    return m


def _points(reader: SessionReader, m: EstimateSeries, some: bool) -> _Points:
    keypoints = ["keypoint of the hand"] * len(m.keypoint_names)
    own = _Points(list(m.keypoint_names), m.keypoints, m.state, m.sd, keypoints)
    if some:
        return own
    on = carried_markers(reader, m)
    return _Points(
        [*own.names, *on.names],
        np.concatenate([own.position, on.position], axis=1),
        np.concatenate([own.state, on.state], axis=1),
        np.concatenate([own.sd, on.sd], axis=1),
        [*own.descriptions, *(f"{k.hue} marker on {k.segment}" for k in m.info.glove.markers)],
    )


def _put_points(file: ezc3d.c3d, points: _Points, unit: str, rate: float) -> None:
    values = np.ones((4, len(points.names), len(points.position)))
    values[:3] = points.position.transpose(2, 1, 0) * UNITS[unit]
    parameters = file["parameters"]["POINT"]
    parameters["RATE"]["value"] = [rate]
    parameters["LABELS"]["value"] = points.names
    parameters["DESCRIPTIONS"]["value"] = points.descriptions
    parameters["UNITS"]["value"] = [unit]
    file["data"]["points"] = values
    file["data"]["meta_points"]["residuals"] = _residuals(points, unit).T[None]


def _residuals(points: _Points, unit: str) -> Array:
    """Residuals (N, K) in ``unit``, integers, since the format has one byte for each."""
    sd = np.where(np.isfinite(points.sd), points.sd, 1e-3 * _MEASURED_MM) * UNITS[unit]
    measured = np.clip(np.ceil(sd), *_RESIDUALS)
    known = np.where(points.state == Validity.MEASURED, measured, 0.0)
    lost = (points.state == Validity.LOST) | ~np.isfinite(points.position).all(axis=2)
    return np.where(lost, -1.0, known)


def _analogs(
    reader: SessionReader, m: EstimateSeries, some: bool
) -> tuple[list[str], Array, list[str]]:
    """Names, values (N, A) and units: angles in degrees, then IMUs at the points' instants."""
    names, values = list(m.joint_names), np.rad2deg(m.angles)
    units = ["deg"] * len(names)
    raw = read_raw_imu(reader, need=False)
    if some or len(raw) == 0:
        return names, values, units
    channels, _ = raw.channels()
    units += [_UNITS[c.rsplit("_", 2)[1]] for c in channels]
    imu = raw.channels_at(m.stamp_ns + m.zero_ns)
    return [*names, *channels], np.column_stack([values, imu]), units


def _add_parameters(file: ezc3d.c3d, m: EstimateSeries) -> None:
    """Add axes and the meaning of values as parameters of our own."""
    parameters = {
        "AXES": str(m.notes["axes_are"]),
        "BONE_AXES": m.bone_axes,
        "RESIDUAL": "standard deviation of a measured point; 0 inferred or interpolated; -1 lost",
        "ANGLES": "deg, flexion positive, as rotations about z (abduction), y (flexion), x (twist)",
        "IMU": "in each IMU's axes, linear between packets; acc is specific force",
    }
    for name, text in parameters.items():
        file.add_parameter("GLOVETRACK", name, [text])


def _put_events(file: ezc3d.c3d, reader: SessionReader, m: EstimateSeries) -> None:
    """Add notes within the series, with times in s from its start."""
    for stamp, text in read_notes(reader, MARKS):
        t = (stamp - m.zero_ns - int(m.stamp_ns[0])) * 1e-9
        if 0.0 <= t <= m.elapsed[-1]:
            minutes, seconds = divmod(t, 60.0)
            file.add_event([minutes, seconds], label="note", context="General", description=text)


def _put_gaps(file: ezc3d.c3d, m: EstimateSeries) -> None:
    """Add an event at the beginning and end of each interpolated period."""
    filled = np.r_[False, m.interpolated.any(axis=1), False]
    for label, rows in (
        ("interp. begin", np.flatnonzero(filled[1:-1] & ~filled[:-2])),
        ("interp. end", np.flatnonzero(filled[1:-1] & ~filled[2:])),
    ):
        for t in m.elapsed[rows]:
            minutes, seconds = divmod(float(t), 60.0)
            file.add_event([minutes, seconds], label=label, context="General")


def _check(path: Path, written: ezc3d.c3d) -> None:
    """Compare the file with what was written, since ezc3d does not report failed writes and reading
    a truncated file may crash.

    Raises DiskError if the file is shorter than its header states or differs.
    """
    points, analogs = written["data"]["points"], written["data"]["analogs"]
    with path.open("rb") as file:
        head = file.read(_BLOCK)
    if len(head) == _BLOCK:
        (first,) = struct.unpack_from("<H", head, _DATA_START)
        size = (first - 1) * _BLOCK + 4 * (4 * points[0].size + analogs.size)
        if path.stat().st_size >= size and np.array_equal(
            ezc3d.c3d(str(path))["data"]["points"][:3],
            points[:3].astype(np.float32),
            equal_nan=True,
        ):
            return
    raise DiskError(notice("export.incomplete", file=path.name))
