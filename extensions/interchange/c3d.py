"""C3D: keypoints and the glove's markers as points, angles and IMUs as analogue channels, notes as
events. A point's residual is its standard deviation where it was measured, 0 where it was inferred
or interpolated and -1 where it was lost, as the format means them."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import NamedTuple

import ezc3d
import numpy as np

from tracker.base.files import DiskError
from tracker.messages import Array, IntArray, Validity
from tracker.session.export.load import load_series
from tracker.session.export.markers import carried_markers
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.raw_imu import MARKS, read_notes, read_raw_imu
from tracker.session.reader import SessionReader

_BLOCK = 512  # bytes; a C3D file counts its parts in these
_DATA_START = 16  # byte of the header with the number of the first block of data, from 1
_RESIDUALS = (1.0, 127.0)  # a byte in units of the file; 0 would say inferred
_MEASURED_MM = 1.0  # residual of a measured point for which no sd is claimed
_UNITS = {"acc": "m/s^2", "gyr": "rad/s"}


class _Points(NamedTuple):
    """names (K,), position (N, K, 3) m, state (N, K), sd (N, K) m, what each is."""

    names: list[str]
    position: Array
    state: IntArray
    sd: Array
    words: list[str]


def export_c3d(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """A lost point is invalid in the file (residual -1, NaN); it is never at the origin.

    Markers and IMUs are left out where ``options`` name joints to keep.
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
    _tell(file, m)
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
        [*own.words, *(f"{k.hue} marker on {k.segment}" for k in m.info.glove.markers)],
    )


def _put_points(file: ezc3d.c3d, points: _Points, unit: str, rate: float) -> None:
    values = np.ones((4, len(points.names), len(points.position)))
    values[:3] = points.position.transpose(2, 1, 0) * UNITS[unit]
    parameters = file["parameters"]["POINT"]
    parameters["RATE"]["value"] = [rate]
    parameters["LABELS"]["value"] = points.names
    parameters["DESCRIPTIONS"]["value"] = points.words
    parameters["UNITS"]["value"] = [unit]
    file["data"]["points"] = values
    file["data"]["meta_points"]["residuals"] = _residuals(points, unit).T[None]


def _residuals(points: _Points, unit: str) -> Array:
    """(N, K) in ``unit``, whole numbers: the format has a byte for each."""
    sd = np.where(np.isfinite(points.sd), points.sd, 1e-3 * _MEASURED_MM) * UNITS[unit]
    measured = np.clip(np.ceil(sd), *_RESIDUALS)
    known = np.where(points.state == Validity.MEASURED, measured, 0.0)
    lost = (points.state == Validity.LOST) | ~np.isfinite(points.position).all(axis=2)
    return np.where(lost, -1.0, known)


def _analogs(
    reader: SessionReader, m: EstimateSeries, some: bool
) -> tuple[list[str], Array, list[str]]:
    """Names, (N, A) values and units: angles in degrees, then IMUs at the points' instants."""
    names, values = list(m.joint_names), np.rad2deg(m.angles)
    units = ["deg"] * len(names)
    raw = read_raw_imu(reader, need=False)
    if some or len(raw) == 0:
        return names, values, units
    channels, _ = raw.channels()
    units += [_UNITS[c.rsplit("_", 2)[1]] for c in channels]
    imu = raw.channels_at(m.stamp_ns + m.zero_ns)
    return [*names, *channels], np.column_stack([values, imu]), units


def _tell(file: ezc3d.c3d, m: EstimateSeries) -> None:
    """Axes and what the numbers mean, in parameters of our own."""
    said = {
        "AXES": str(m.notes["axes_are"]),
        "BONE_AXES": m.bone_axes,
        "RESIDUAL": "standard deviation of a measured point; 0 inferred or interpolated; -1 lost",
        "ANGLES": "deg, flexion positive, as rotations about z (abduction), y (flexion), x (twist)",
        "IMU": "in each IMU's own axes, on lines between packets; acc is specific force",
    }
    for name, words in said.items():
        file.add_parameter("GLOVETRACK", name, [words])


def _put_events(file: ezc3d.c3d, reader: SessionReader, m: EstimateSeries) -> None:
    """Notes within the series, in its seconds."""
    for stamp, text in read_notes(reader, MARKS):
        t = (stamp - m.zero_ns - int(m.stamp_ns[0])) * 1e-9
        if 0.0 <= t <= m.elapsed[-1]:
            minutes, seconds = divmod(t, 60.0)
            file.add_event([minutes, seconds], label="note", context="General", description=text)


def _put_gaps(file: ezc3d.c3d, m: EstimateSeries) -> None:
    """An event where each stretch of interpolated points begins and ends."""
    filled = np.r_[False, m.interpolated.any(axis=1), False]
    for label, rows in (
        ("interp. begin", np.flatnonzero(filled[1:-1] & ~filled[:-2])),
        ("interp. end", np.flatnonzero(filled[1:-1] & ~filled[2:])),
    ):
        for t in m.elapsed[rows]:
            minutes, seconds = divmod(float(t), 60.0)
            file.add_event([minutes, seconds], label=label, context="General")


def _check(path: Path, written: ezc3d.c3d) -> None:
    """ezc3d tells of no write that failed, and reading a file cut short may end the program.

    Raises DiskError if the file is not as long as it says or not what was written.
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
    raise DiskError(f"{path.name} could not be written as a whole: the disk may be full.")
