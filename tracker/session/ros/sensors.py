"""Encodes and decodes ROS 2 sensor messages; tested against the bytes of rosbags.

Stamps are nanoseconds since 1970.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.messages import Array, Blobs, Cloth
from tracker.session.ros.cdr import CdrError, CdrReader, CdrWriter
from tracker.vision.rig import Camera

IMU = "sensor_msgs/msg/Imu"
IMAGE = "sensor_msgs/msg/CompressedImage"
CAMERA_INFO = "sensor_msgs/msg/CameraInfo"
TIME_REFERENCE = "sensor_msgs/msg/TimeReference"
DETECTIONS = "vision_msgs/msg/Detection2DArray"
CLOTH = "std_msgs/msg/Int64MultiArray"
LONGEST_IMAGE = 1 << 16  # px

_NO_ORIENTATION = np.array([0.0, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 0, 0])
_IMU_AT_REST = np.r_[_NO_ORIENTATION, np.zeros(3 + 9 + 3 + 9)]
_UNKNOWN_POSE = np.r_[0.0, 0, 0, 0, 0, 0, 1, np.zeros(36)]


class ImuMessage(NamedTuple):
    """Variances are those of each axis, 0 if unknown."""

    stamp: int
    frame: str
    gyro: Array  # (3,) rad/s
    accel: Array  # (3,) m/s²
    gyro_variance: float = 0.0  # rad²/s²
    accel_variance: float = 0.0  # m²/s⁴


class ImageMessage(NamedTuple):
    stamp: int
    frame: str
    format: str
    data: bytes


class TimeReference(NamedTuple):
    """The same instant on the host's clock (stamp) and on another (reference)."""

    stamp: int
    reference: int
    source: str


class Detections(NamedTuple):
    stamp: int
    frame: str
    blobs: Blobs  # hue indexes ``names``
    names: tuple[str, ...]


def pack_imu(m: ImuMessage) -> bytes:
    out = CdrWriter()
    out.header(m.stamp, m.frame)
    values = _IMU_AT_REST.copy()
    values[13:16], values[16:25:4] = m.gyro, m.gyro_variance
    values[25:28], values[28:37:4] = m.accel, m.accel_variance
    out.doubles(values)
    return out.done()


def unpack_imu(data: bytes) -> ImuMessage:
    source = CdrReader(data)
    stamp, frame = source.header()
    values = source.doubles(37)
    variances = float(values[16]), float(values[28])
    return ImuMessage(stamp, frame, values[13:16], values[25:28], *variances)


def pack_image(m: ImageMessage) -> bytes:
    out = CdrWriter()
    out.header(m.stamp, m.frame)
    out.text(m.format)
    out.byte_list(m.data)
    return out.done()


def unpack_image(data: bytes) -> ImageMessage:
    source = CdrReader(data)
    stamp, frame = source.header()
    return ImageMessage(stamp, frame, source.text(), source.byte_list())


def pack_time_reference(m: TimeReference) -> bytes:
    out = CdrWriter()
    out.header(m.stamp, "")
    out.time(m.reference)
    out.text(m.source)
    return out.done()


def unpack_time_reference(data: bytes) -> TimeReference:
    source = CdrReader(data)
    stamp, _ = source.header()
    return TimeReference(stamp, source.time(), source.text())


def pack_camera_info(stamp: int, frame: str, camera: Camera) -> bytes:
    out = CdrWriter()
    out.header(stamp, frame)
    out.u32(camera.height)
    out.u32(camera.width)
    model = "plumb_bob" if camera.D.size <= 5 else "rational_polynomial"
    out.text("equidistant" if camera.fisheye else model)
    out.double_list(camera.D)
    for matrix in (camera.K, camera.R, camera.P):
        out.doubles(matrix.ravel())
    for _ in range(6):  # binning x, y; region of interest x, y, height, width
        out.u32(0)
    out.u8(0)
    return out.done()


def unpack_camera_info(data: bytes) -> Camera:
    source = CdrReader(data)
    source.header()
    height, width = source.u32(), source.u32()
    fisheye = source.text() == "equidistant"
    D = source.double_list()
    K, R, P = source.doubles(9), source.doubles(9), source.doubles(12)
    K, R, P = K.reshape(3, 3), R.reshape(3, 3), P.reshape(3, 4)
    return Camera(width, height, K, D, R, P, fisheye)


def pack_detections(m: Detections) -> bytes:
    out = CdrWriter()
    out.header(m.stamp, m.frame)
    out.u32(len(m.blobs))
    rows = np.zeros((len(m.blobs), 1 + len(_UNKNOWN_POSE) + 5))
    rows[:, 0], rows[:, 1:-5] = m.blobs.score, _UNKNOWN_POSE
    rows[:, -5:-3], rows[:, -2:] = m.blobs.uv, m.blobs.size
    for hue, row in zip(m.blobs.hue.tolist(), rows, strict=True):
        out.header(m.stamp, m.frame)
        out.u32(1)
        out.text(m.names[hue])
        out.doubles(row)
        out.text("")
    return out.done()


def unpack_detections(data: bytes) -> Detections:
    """Detections without a hypothesis have no hue and are left out."""
    source = CdrReader(data)
    stamp, frame = source.header()
    rows: list[tuple[str, float, Array]] = []
    for _ in range(source.count(16)):
        source.header()
        best = _best_hypothesis(source)
        box = source.doubles(5)
        source.text()
        if best is not None:
            rows.append((*best, box))
    names = tuple(dict.fromkeys(name for name, _, _ in rows))
    box = np.array([b for _, _, b in rows], float).reshape(-1, 5)
    hue = np.array([names.index(name) for name, _, _ in rows], np.int64)
    score = np.array([s for _, s, _ in rows], float)
    return Detections(stamp, frame, Blobs(box[:, :2].copy(), box[:, 3:].copy(), hue, score), names)


def pack_cloth(cloth: Cloth) -> bytes:
    """columns, rows, number of runs of tiles; the runs' first tiles, their lengths; all bits; then
    those of the brightness, if it is known."""
    begins = np.flatnonzero(np.diff(cloth.tile, prepend=-2) != 1)
    lengths = np.diff(begins, append=len(cloth.tile))
    head = [cloth.columns, cloth.rows, len(begins)]
    out = CdrWriter()
    out.no_layout()
    bright = cloth.tile[:0] if cloth.bright is None else cloth.bright
    out.long_list(np.concatenate([head, cloth.tile[begins], lengths, cloth.bits, bright]))
    return out.done()


def unpack_cloth(data: bytes) -> Cloth:
    source = CdrReader(data)
    source.skip_layout()
    values = source.long_list()
    if len(values) < 3:
        raise CdrError("a map of cloth must contain its size")
    columns, rows, n = values[:3].tolist()
    if not (0 <= columns < LONGEST_IMAGE and 0 <= rows < LONGEST_IMAGE and 0 <= n < len(values)):
        raise CdrError("a map of cloth is larger than any image")
    first, length, found = np.split(values[3:], [n, 2 * n])
    inside = (first >= 0) & (length > 0) & (length <= len(found)) & (first < columns * rows)
    count = int(length[inside].sum())
    if not inside.all() or (first + length > columns * rows).any():
        raise CdrError("a map of cloth has parts that are not in its image")
    if len(found) not in (count, 2 * count):
        raise CdrError("a map of cloth has parts that are not in its image")
    before = np.cumsum(length) - length
    tile = np.arange(count) + np.repeat(first - before, length)
    bright = found[count:].copy() if len(found) > count else None
    return Cloth(columns, rows, tile, found[:count].copy(), bright)


def _best_hypothesis(source: CdrReader) -> tuple[str, float] | None:
    found = []
    for _ in range(source.count(16)):
        name = source.text()
        found.append((name, float(source.doubles(44)[0])))  # score, then pose and covariance
    return max(found, key=lambda f: f[1], default=None)
