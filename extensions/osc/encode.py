"""OSC 1.0 messages and bundles as bytes: strings, float32, and int32 or, beyond, int64.

A stream sends the same bundle again and again with other numbers: an `OscTemplate` has its bytes,
into which numbers are written.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from functools import lru_cache
from typing import Final

import numpy as np

from tracker.messages import Array, IntArray

IMMEDIATELY = 1  # the time tag for "now"
LENGTH = struct.Struct(">i")
_TAGS: dict[type, str] = {float: "f", str: "s"}
_FORMS = {"i": "i", "h": "q", "f": "f"}


def message(address: str, *values: str | int | float) -> bytes:
    """One message; the type of each value gives its tag."""
    tags = "".join([_TAGS.get(type(v)) or _tag(v) for v in values])
    if "s" not in tags:
        return _head(address, tags) + _numbers(tags).pack(*values)
    first = len(tags) - len(tags.lstrip("s"))
    rest, tail = tags[first:], values[first:]
    names = [_string(str(v)) for v in values[:first]]
    if "s" not in rest:  # names, then numbers
        return b"".join((_head(address, tags), *names, _numbers(rest).pack(*tail)))
    data = [
        _string(v) if isinstance(v, str) else _numbers(k).pack(v)
        for k, v in zip(rest, tail, strict=True)
    ]
    return b"".join((_head(address, tags), *names, *data))


def _tag(value: str | int | float) -> str:
    if isinstance(value, str):
        return "s"
    if isinstance(value, int):
        return "i" if -(2**31) <= value < 2**31 else "h"
    return "f"


@lru_cache(maxsize=1024)
def _numbers(tags: str) -> struct.Struct:
    """What numbers of these tags are packed by."""
    return struct.Struct(">" + "".join([_FORMS[tag] for tag in tags]))


@lru_cache(maxsize=1024)
def _head(address: str, tags: str) -> bytes:
    """What messages of an address begin with, which is the same again and again."""
    return _string(address) + _string("," + tags)


def bundle(messages: Sequence[bytes]) -> bytes:
    """Messages that take effect together, now."""
    return bundle_of(elements(messages))


def elements(messages: Sequence[bytes]) -> bytes:
    """Messages as they are in a bundle, each after its length."""
    return b"".join([part for m in messages for part in (LENGTH.pack(len(m)), m)])


def bundle_of(*parts: bytes) -> bytes:
    """A bundle of parts that `elements` or `OscTemplate.pack` returned."""
    return b"".join((_BUNDLE_HEAD, *parts))


@lru_cache(maxsize=1024)
def _string(text: str) -> bytes:
    """Zero-terminated and padded to four bytes; UTF-8, which holds the ASCII of OSC 1.0."""
    data = text.encode("utf-8", "replace")
    return data + bytes(4 - len(data) % 4)


_BUNDLE_HEAD = _string("#bundle") + struct.pack(">Q", IMMEDIATELY)


class Slot:
    """A number of an `OscTemplate` that `OscTemplate.pack` writes."""

    def __init__(self, placeholder: int | float) -> None:
        self.placeholder = placeholder


FLOAT: Final = Slot(0.0)
INT: Final = Slot(0)
Value = str | int | float | Slot


class OscTemplate:
    """Messages of a bundle: each an address and its values, of which some are `FLOAT` or `INT`.

    Everything in a message is a multiple of four bytes long.
    """

    def __init__(self, messages: Sequence[tuple[str, Sequence[Value]]]) -> None:
        floats: list[int] = []
        ints: list[int] = []
        data = b""
        for address, values in messages:
            plain = [v.placeholder if isinstance(v, Slot) else v for v in values]
            whole = message(address, *plain)
            at = len(data) + LENGTH.size + len(whole) - sum(map(_size, plain))
            for value, size in zip(values, map(_size, plain), strict=True):
                if isinstance(value, Slot):
                    (ints if value is INT else floats).append(at // 4)
                at += size
            data += LENGTH.pack(len(whole)) + whole
        self._data, self._floats, self._ints = data, np.array(floats, int), np.array(ints, int)

    def pack(self, floats: Array, ints: IntArray | Sequence[int] = ()) -> bytes:
        """The messages with these numbers, in order, for `bundle_of`."""
        out = bytearray(self._data)
        np.frombuffer(out, ">f4")[self._floats] = floats
        if len(self._ints):
            np.frombuffer(out, ">i4")[self._ints] = ints
        return bytes(out)


def _size(value: str | int | float) -> int:
    """Bytes of a value in a message."""
    if isinstance(value, str):
        return len(_string(value))
    return _numbers(_TAGS.get(type(value)) or _tag(value)).size
