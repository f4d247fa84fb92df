"""CDR, the byte layout of ROS 2 messages (OMG DDS-RTPS 9.3, plain CDR version 1).

Every value is aligned to its own size, counted from the end of the four-byte header.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array, IntArray

LITTLE_ENDIAN = b"\x00\x01\x00\x00"
_END_OF_TIME = 2**31 * NS
_PADDING = tuple(bytes(n) for n in range(8))
_U32 = struct.Struct("<I")
_TIME = struct.Struct("<iI")
_FLOATS, _LONGS = np.dtype("<f8"), np.dtype("<i8")


_LAYOUTS = [
    (struct.Struct(f"{c}I").unpack_from, struct.Struct(f"{c}iI").unpack_from,
     np.dtype(f"{c}f8"), np.dtype(f"{c}i8"))
    for c in "><"
]  # fmt: skip
"""Of u32, times, float64 and int64, by the second byte of a message."""
_NAME = 100  # characters


@lru_cache(maxsize=1024)
def _name(value: str) -> bytes:
    """`_text` of one of the names that most messages consist of."""
    return _text(value)


def _text(value: str) -> bytes:
    raw = value.encode()
    return _U32.pack(len(raw) + 1) + raw + b"\0"


class CdrError(ValueError):
    """The bytes are not a message of the given type."""


class CdrWriter:
    """Writes one little-endian message."""

    def __init__(self) -> None:
        self._body = bytearray()

    def done(self) -> bytes:
        return LITTLE_ENDIAN + bytes(self._body)

    def _align(self, size: int) -> None:
        missing = -len(self._body) % size
        if missing:
            self._body += _PADDING[missing]

    def u8(self, value: int) -> None:
        self._body.append(value)

    def u32(self, value: int) -> None:
        self._align(4)
        self._body += _U32.pack(value)

    def time(self, ns: int) -> None:
        """builtin_interfaces/Time of nanoseconds since 1970. Raises FileError out of its range."""
        self._align(4)
        if not -_END_OF_TIME <= ns < _END_OF_TIME:
            raise FileError(notice("session.instant_range"))
        self._body += _TIME.pack(*divmod(ns, NS))

    def text(self, value: str) -> None:
        self._align(4)
        self._body += _name(value) if len(value) < _NAME else _text(value)

    def header(self, ns: int, frame: str) -> None:
        """std_msgs/Header."""
        self.time(ns)
        self.text(frame)

    def doubles(self, values: ArrayLike) -> None:
        """float64 numbers without a length in front."""
        raw = np.asarray(values, _FLOATS).tobytes()
        if raw:
            self._align(8)
            self._body += raw

    def double_list(self, values: ArrayLike) -> None:
        """A float64 sequence."""
        values = np.asarray(values, _FLOATS).ravel()
        self.u32(len(values))
        self.doubles(values)

    def long_list(self, values: ArrayLike) -> None:
        """An int64 sequence."""
        values = np.asarray(values, _LONGS).ravel()
        self.u32(len(values))
        if len(values):
            self._align(8)
            self._body += values.tobytes()

    def no_layout(self) -> None:
        """std_msgs/MultiArrayLayout of one row of numbers, which is empty."""
        self.u32(0)  # dimensions
        self.u32(0)  # offset

    def text_list(self, values: Iterable[str]) -> None:
        values = list(values)
        self.u32(len(values))
        for v in values:
            self.text(v)

    def byte_list(self, data: bytes) -> None:
        """A uint8 sequence."""
        self.u32(len(data))
        self._body += data


class CdrReader:
    """Reads the values of one message. Raises CdrError if the bytes end early."""

    def __init__(self, data: bytes) -> None:
        if len(data) < 4 or data[0] != 0 or data[1] not in (0, 1):
            raise CdrError("not a plain CDR message")
        self._data = data
        self._at = 4
        self._u32, self._time, self._floats, self._longs = _LAYOUTS[data[1]]

    @property
    def at(self) -> int:
        """Where the value that was read last ends."""
        return self._at

    def _next(self, size: int, align: int = 1) -> int:
        """Where the next ``size`` bytes begin."""
        start = self._at + (4 - self._at) % align
        end = start + size
        if size < 0 or end > len(self._data):
            raise CdrError(f"the message ends {end - len(self._data)} bytes early")
        self._at = end
        return start

    def _read(self, size: int) -> bytes:
        start = self._next(size)
        return self._data[start : self._at]

    def _numbers(self, n: int, kind: np.dtype) -> NDArray[Any]:
        start = self._next(8 * n, 8)
        return np.frombuffer(self._data, kind, n, start)

    def u8(self) -> int:
        return self._data[self._next(1)]

    def u32(self) -> int:
        (value,) = self._u32(self._data, self._next(4, 4))
        return int(value)

    def count(self, smallest: int = 1) -> int:
        """Returns the length of a sequence whose elements have at least ``smallest`` bytes."""
        n = self.u32()
        if n * smallest > len(self._data) - self._at + 8:
            raise CdrError(f"a list of {n} elements does not fit")
        return n

    def time(self) -> int:
        """Nanoseconds since 1970."""
        sec, nanosec = self._time(self._data, self._next(8, 4))
        return int(sec * NS + nanosec)

    def text(self) -> str:
        raw = self._read(self.u32())
        try:
            return raw.rstrip(b"\0").decode()
        except UnicodeDecodeError as error:
            raise CdrError("a text is not UTF-8") from error

    def header(self) -> tuple[int, str]:
        return self.time(), self.text()

    def doubles(self, n: int) -> Array:
        """(n,) float64, writable."""
        if n == 0:
            return np.zeros(0)
        return self._numbers(n, self._floats).astype(np.float64)

    def double_list(self) -> Array:
        return self.doubles(self.count(8))

    def long_list(self) -> IntArray:
        """(n,) int64, writable."""
        n = self.count(8)
        if n == 0:
            return np.zeros(0, np.int64)
        return self._numbers(n, self._longs).astype(np.int64)

    def skip_layout(self) -> None:
        """Skips a std_msgs/MultiArrayLayout."""
        for _ in range(self.count(12)):
            self.text()
            self.u32()
            self.u32()
        self.u32()

    def text_list(self) -> list[str]:
        return [self.text() for _ in range(self.count(4))]

    def byte_list(self) -> bytes:
        return self._read(self.u32())
