"""Decodes images of a session; their size is checked first."""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.damage import LeftOut
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import CameraPose, StereoFrame
from tracker.session.ros import sensors, topics

MOST_PIXELS = 40_000_000
_START_OF_SCAN, _END_OF_IMAGE = b"\xff\xda", b"\xff\xd9"
_START_OF_FRAME = {0xC0, 0xC1, 0xC2, 0xC3, 0xC5, 0xC6, 0xC7, 0xC9, 0xCA, 0xCB, 0xCD, 0xCE, 0xCF}


@dataclass(frozen=True, eq=False, slots=True)
class PackedFrame:
    """A StereoFrame before its images are unpacked: ``parts`` by camera, ``left`` and ``right``.

    Unpacking takes most of the time to read and may be done in any thread. ``left_out`` counts the
    images that turn out to be damaged.
    """

    t: float
    t_arrival: float
    parts: dict[str, sensors.ImageMessage]
    pose: CameraPose | None
    index: int
    left_out: LeftOut | None = None

    def unpack(self) -> StereoFrame | None:
        """The frame without its damaged images; None where no image is left."""
        images: dict[str, NDArray[np.uint8]] = {}
        for camera, part in self.parts.items():
            try:
                images[camera] = decode_image(part.data, part.frame)
            except FileError:
                if self.left_out is not None:
                    self.left_out.add(topics.image(camera), part.stamp)
        if not images:
            return None
        return StereoFrame(
            self.t,
            self.t_arrival,
            images.get("left"),
            images.get("right"),
            self.pose,
            self.index,
        )


def decode_image(data: bytes, name: str) -> NDArray[np.uint8]:
    """Decodes JPEG or PNG bytes to (h, w, 3) BGR. Raises FileError, which includes ``name``."""
    check_image(data, name)
    image = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)
    if image is None:
        raise FileError(notice("session.image_damaged", camera=name))
    return np.asarray(image, np.uint8)


def check_image(data: bytes, name: str) -> None:
    """Raises FileError for an image that is not a JPEG or PNG, too large or truncated, without
    decoding it."""
    size = image_size(data)
    if size is None:
        raise FileError(notice("session.image_kind", camera=name))
    if size[0] * size[1] > MOST_PIXELS:
        raise FileError(notice("session.image_size", camera=name, width=size[0], height=size[1]))
    if not (_is_whole_png(data) if data[:1] == b"\x89" else _is_whole_jpeg(data)):
        raise FileError(notice("session.image_damaged", camera=name))


def encode_image(image: NDArray[np.uint8], kind: str, quality: int) -> bytes:
    """A BGR image as JPEG (of ``quality`` 1 to 100) or PNG bytes."""
    if kind == "jpeg":
        _, data = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality])
    else:
        _, data = cv2.imencode(".png", image, [cv2.IMWRITE_PNG_COMPRESSION, 1])
    return data.tobytes()


def image_size(data: bytes) -> tuple[int, int] | None:
    """(width, height) that a JPEG or PNG states; None if it is neither."""
    if data[:8] == b"\x89PNG\r\n\x1a\n" and len(data) >= 24:
        return struct.unpack(">II", data[16:24])
    if data[:2] == b"\xff\xd8":
        return _jpeg_size(data)
    return None


def _is_whole_png(data: bytes) -> bool:
    """Whether all chunks are present with valid checksums, up to the last one (ISO/IEC 15948,
    5.3)."""
    at, view = 8, memoryview(data)
    while at + 12 <= len(data):
        end = at + 8 + int.from_bytes(data[at : at + 4], "big")
        if end + 4 > len(data):
            return False
        if zlib.crc32(view[at + 4 : end]) != int.from_bytes(data[end : end + 4], "big"):
            return False
        if data[at + 4 : at + 8] == b"IEND":
            return True
        at = end + 4
    return False


def _is_whole_jpeg(data: bytes) -> bool:
    """Whether the image ends after its first scan has begun (ITU-T T.81, B.1.1.3).

    The marker of the end cannot occur in the coded data of a scan.
    """
    scan = data.find(_START_OF_SCAN, max(_frame_header(data), 0))
    return 0 <= scan < data.find(_END_OF_IMAGE, scan)


def _jpeg_size(data: bytes) -> tuple[int, int] | None:
    at = _frame_header(data)
    if at < 0:
        return None
    height, width = struct.unpack(">HH", data[at + 5 : at + 9])
    return width, height


def _frame_header(data: bytes) -> int:
    """Walk over a JPEG's segments to its frame header (ITU-T T.81, B.2.2); -1 without one."""
    at = 2
    while at + 9 <= len(data) and data[at] == 0xFF:
        marker, length = data[at + 1], struct.unpack(">H", data[at + 2 : at + 4])[0]
        if marker in _START_OF_FRAME:
            return at
        at += 2 + length
    return -1
