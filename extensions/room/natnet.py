"""Rigid bodies from OptiTrack's NatNet packets (protocol 2.6 to 4.x), little-endian.

A frame of data contains marker sets, unlabelled markers, then rigid bodies; since 4.1 the size of
each section in bytes follows its count. What comes after the rigid bodies is not read.
"""

from __future__ import annotations

import struct
from typing import NamedTuple

import numpy as np

from tracker.messages import Array

CONNECT, SERVER_INFO, FRAME_OF_DATA, KEEP_ALIVE = 0, 1, 7, 10
GROUP = "239.255.42.99"  # the multicast group that Motive uses by default
COMMAND_PORT, DATA_PORT = 1510, 1511
MOST = 4096  # elements of a section
_NAME = 256  # bytes of the server's name, before its versions
Version = tuple[int, int]


class NatNetError(ValueError):
    """The packet cannot be read."""


class RigidBody(NamedTuple):
    """p (3,) m and q (4,) xyzw in Motive's axes; ``valid``: the cameras track it."""

    number: int
    p: Array
    q: Array
    valid: bool


class _Reader:
    def __init__(self, data: bytes) -> None:
        self._data, self._at = data, 0

    def take(self, form: str) -> tuple[float, ...]:
        values = struct.unpack_from(form, self._data, self._at)
        self._at += struct.calcsize(form)
        return values

    def count(self, sized: bool) -> int:
        n = int(self.take("<i")[0])
        if sized:
            self.take("<i")
        if not 0 <= n <= MOST:
            raise NatNetError("a section has an impossible number of elements")
        return n

    def skip(self, size: int) -> None:
        self._at += size
        if self._at > len(self._data):
            raise NatNetError("the packet is cut off")

    def skip_text(self) -> None:
        end = self._data.find(b"\0", self._at)
        if end < 0:
            raise NatNetError("a name has no end")
        self._at = end + 1


def kind_of(data: bytes) -> int:
    """The message's kind; -1 of what is not a packet."""
    return int(struct.unpack_from("<H", data)[0]) if len(data) >= 4 else -1


def request(kind: int) -> bytes:
    """A request of a client without content."""
    return struct.pack("<HH", kind, 0) + b"\0"


def protocol_version(data: bytes) -> Version:
    """For a server's answer to `CONNECT`. Raises NatNetError."""
    if kind_of(data) != SERVER_INFO or len(data) < 4 + _NAME + 8:
        raise NatNetError("this is not a server's description")
    return data[4 + _NAME + 4], data[4 + _NAME + 5]


def rigid_bodies(data: bytes, version: Version) -> list[RigidBody]:
    """The rigid bodies of a frame of data. Raises NatNetError."""
    if kind_of(data) != FRAME_OF_DATA:
        raise NatNetError("this is not a frame of data")
    try:
        return _bodies(_Reader(data[4:]), version)
    except struct.error as error:
        raise NatNetError("the packet is cut off") from error


def _bodies(source: _Reader, version: Version) -> list[RigidBody]:
    sized = version >= (4, 1)
    source.take("<i")  # the frame's number
    for _ in range(source.count(sized)):
        source.skip_text()
        source.skip(12 * source.count(False))
    source.skip(12 * source.count(sized))
    return [_body(source, version) for _ in range(source.count(sized))]


def _body(source: _Reader, version: Version) -> RigidBody:
    number = int(source.take("<i")[0])
    values = np.array(source.take("<7f"), float)
    if version < (3, 0):  # markers: position, number and size of each
        source.skip(20 * source.count(False))
    source.take("<f")  # mean error
    flags = int(source.take("<H")[0]) if version >= (2, 6) else 1
    length = float(np.linalg.norm(values[3:]))
    valid = bool(flags & 1) and bool(np.isfinite(values).all()) and length > 0.5
    return RigidBody(number, values[:3], values[3:] / max(length, 1e-9), valid)
