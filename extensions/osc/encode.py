"""OSC 1.0 messages and bundles as bytes: strings, float32, and int32 or, beyond, int64."""

from __future__ import annotations

import struct
from collections.abc import Sequence

IMMEDIATELY = 1  # the time tag for "now"


def message(address: str, *values: str | int | float) -> bytes:
    """One message; the type of each value gives its tag."""
    tags, data = ",", b""
    for value in values:
        if isinstance(value, str):
            tags, data = tags + "s", data + _string(value)
        elif isinstance(value, int) and -(2**31) <= value < 2**31:
            tags, data = tags + "i", data + struct.pack(">i", value)
        elif isinstance(value, int):
            tags, data = tags + "h", data + struct.pack(">q", value)
        else:
            tags, data = tags + "f", data + struct.pack(">f", value)
    return _string(address) + _string(tags) + data


def bundle(messages: Sequence[bytes]) -> bytes:
    """Messages that take effect together, now."""
    head = _string("#bundle") + struct.pack(">Q", IMMEDIATELY)
    return head + b"".join(struct.pack(">i", len(m)) + m for m in messages)


def _string(text: str) -> bytes:
    """Zero-terminated and padded to four bytes; UTF-8, which holds the ASCII of OSC 1.0."""
    data = text.encode("utf-8", "replace")
    return data + bytes(4 - len(data) % 4)
