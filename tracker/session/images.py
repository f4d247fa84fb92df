"""Images of a session, with their size checked before they are unpacked."""

from __future__ import annotations

import struct
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.errors import FileError
from tracker.messages import CameraPose, StereoFrame
from tracker.session.ros import sensors

MOST_PIXELS = 40_000_000
_START_OF_FRAME = {0xC0, 0xC1, 0xC2, 0xC3, 0xC5, 0xC6, 0xC7, 0xC9, 0xCA, 0xCB, 0xCD, 0xCE, 0xCF}


@dataclass(frozen=True, eq=False, slots=True)
class PackedFrame:
    """A StereoFrame before its images are unpacked: ``parts`` by camera, ``left`` and ``right``.

    Unpacking is most of the cost of reading and may be done in any thread.
    """

    t: float
    t_arrival: float
    parts: dict[str, sensors.ImageMessage]
    pose: CameraPose | None
    index: int

    def unpack(self) -> StereoFrame:
        """Raises FileError where an image is damaged."""
        images = {c: decode_image(p.data, p.frame) for c, p in self.parts.items()}
        return StereoFrame(
            self.t,
            self.t_arrival,
            images.get("left"),
            images.get("right"),
            self.pose,
            self.index,
        )


def decode_image(data: bytes, name: str) -> NDArray[np.uint8]:
    """(h, w, 3) BGR of JPEG or PNG bytes. Raises FileError; ``name`` stands for the image."""
    size = image_size(data)
    if size is None:
        raise FileError(f"An image of {name} is neither JPEG nor PNG.")
    if size[0] * size[1] > MOST_PIXELS:
        raise FileError(f"An image of {name} claims {size[0]} by {size[1]} pixels.")
    image = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)
    if image is None:
        raise FileError(f"An image of {name} is damaged.")
    return np.asarray(image, np.uint8)


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


def _jpeg_size(data: bytes) -> tuple[int, int] | None:
    """Walk over a JPEG's segments to its frame header (ITU-T T.81, B.2.2)."""
    at = 2
    while at + 9 <= len(data) and data[at] == 0xFF:
        marker, length = data[at + 1], struct.unpack(">H", data[at + 2 : at + 4])[0]
        if marker in _START_OF_FRAME:
            height, width = struct.unpack(">HH", data[at + 5 : at + 9])
            return width, height
        at += 2 + length
    return None
