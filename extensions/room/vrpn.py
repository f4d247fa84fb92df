"""Messages of VRPN, the Virtual-Reality Peripheral Network (version 7), big-endian.

Both sides of a TCP connection first send a cookie of 24 bytes, ``vrpn: ver. 07.35  0``. Then each
message has a header of five integers (length with this header, seconds and microseconds since
1970, sender, type) in 24 bytes, and a payload padded to 8 bytes. A server describes the names of
its senders (type -1) and of its types (-2); the number that is described is in the sender's place.
A tracker's pose is of the type *vrpn_Tracker Pos_Quat*: sensor, padding, x y z, qx qy qz qw.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tracker.messages import Array

PORT = 3883
COOKIE_BYTES = 24
COOKIE = b"vrpn: ver. 07.35  0".ljust(COOKIE_BYTES, b"\0")
MAJOR = b"vrpn: ver. 07."  # other versions behind the point understand each other
POSE_TYPE = "vrpn_Tracker Pos_Quat"
SENDER, TYPE = -1, -2  # types of messages that describe a name
MOST_BYTES = 1 << 16  # of one message
MOST_NAMES = 4096
_HEADER = struct.Struct(">IIIii")
_POSE = struct.Struct(">ii7d")
HEADER_BYTES = 24


class VrpnError(ValueError):
    """The bytes are not what a VRPN server sends."""


class VrpnPose(NamedTuple):
    """Pose of a sensor, p (3,) and q (4,) xyzw in the server's units and axes; ``stamp``: s since
    1970 by the server's clock."""

    tracker: str
    sensor: int
    stamp: float
    p: Array
    q: Array


class VrpnReader:
    """Reads the bytes of one connection, from the server's cookie on."""

    def __init__(self) -> None:
        self._bytes = b""
        self._greeted = False
        self._senders: dict[int, str] = {}
        self._types: dict[int, str] = {}

    @property
    def greeted(self) -> bool:
        """Whether the server's cookie has arrived."""
        return self._greeted

    def poses(self, data: bytes) -> list[VrpnPose]:
        """The poses that are complete with ``data``. Raises VrpnError."""
        self._bytes += data
        if not self._greeted:
            if len(self._bytes) < COOKIE_BYTES:
                return []
            self._greet(self._bytes[:COOKIE_BYTES])
            self._bytes = self._bytes[COOKIE_BYTES:]
        return [pose for each in self._messages() if (pose := self._read(*each)) is not None]

    def _greet(self, cookie: bytes) -> None:
        if not cookie.startswith(MAJOR):
            raise VrpnError("this is not a VRPN server of version 7")
        self._greeted = True

    def _messages(self) -> Iterator[tuple[float, int, int, bytes]]:
        """Stamp (s), sender, type and payload of each complete message, which is then dropped."""
        at = 0
        while at + HEADER_BYTES <= len(self._bytes):
            length, seconds, micros, sender, kind = _HEADER.unpack_from(self._bytes, at)
            if not HEADER_BYTES <= length <= MOST_BYTES:
                raise VrpnError("a message has an impossible length")
            end = at + -(-length // 8) * 8
            if end > len(self._bytes):
                break
            yield (
                seconds + 1e-6 * micros,
                sender,
                kind,
                self._bytes[at + HEADER_BYTES : at + length],
            )
            at = end
        self._bytes = self._bytes[at:]

    def _read(self, stamp: float, sender: int, kind: int, payload: bytes) -> VrpnPose | None:
        if kind in (SENDER, TYPE):
            names = self._senders if kind == SENDER else self._types
            if len(names) < MOST_NAMES:
                names[sender] = _name(payload)
            return None
        if self._types.get(kind) != POSE_TYPE:
            return None
        if len(payload) < _POSE.size:
            raise VrpnError("a pose is cut off")
        sensor, _, *values = _POSE.unpack_from(payload)
        p_q = np.array(values)
        length = float(np.linalg.norm(p_q[3:]))
        if not np.isfinite(p_q).all() or length < 0.5:
            return None  # the server has no pose of this sensor
        name = self._senders.get(sender, str(sender))
        return VrpnPose(name, int(sensor), stamp, p_q[:3], p_q[3:] / length)


def _name(payload: bytes) -> str:
    """For a description: its length with the zero at its end, then the name."""
    if len(payload) < 4:
        raise VrpnError("a description is cut off")
    (length,) = struct.unpack_from(">I", payload)
    return payload[4 : 4 + length].split(b"\0")[0].decode("utf-8", "replace")
