"""OSC 1.0 messages and bundles as bytes: strings, float32, and int32 or, beyond, int64."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from functools import lru_cache

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
    head = _string("#bundle") + struct.pack(">Q", IMMEDIATELY)
    return head + b"".join([part for m in messages for part in (LENGTH.pack(len(m)), m)])


@lru_cache(maxsize=1024)
def _string(text: str) -> bytes:
    """Zero-terminated and padded to four bytes; UTF-8, which holds the ASCII of OSC 1.0."""
    data = text.encode("utf-8", "replace")
    return data + bytes(4 - len(data) % 4)
