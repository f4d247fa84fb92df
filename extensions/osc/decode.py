"""One OSC 1.0 message from bytes that anybody may have sent; bundles of one are opened.

Types are those that senders of commands use: int32, float32, string, true, false.
"""

from __future__ import annotations

import struct

BUNDLE = b"#bundle\0"
_HEAD = len(BUNDLE) + 8  # with the time tag


class OscError(ValueError):
    """Not OSC, or not of the part of it that is understood here."""


def message(data: bytes) -> tuple[str, list[str | int | float | bool]]:
    """Address and values. Raises OscError."""
    if data.startswith(BUNDLE):
        data = _alone(data)
    address, rest = _string(data)
    if not address.startswith("/"):
        raise OscError("an OSC address begins with a slash")
    if not rest:
        return address, []  # older senders leave the tags out
    tags, rest = _string(rest)
    if not tags.startswith(","):
        raise OscError("the OSC type tags are missing")
    values: list[str | int | float | bool] = []
    for tag in tags[1:]:
        value, rest = _value(tag, rest)
        values.append(value)
    return address, values


def _alone(data: bytes) -> bytes:
    """The first message of a bundle, which must be the only one."""
    if len(data) < _HEAD + 4:
        raise OscError("the OSC bundle is cut off")
    (size,) = struct.unpack_from(">i", data, _HEAD)
    if size != len(data) - _HEAD - 4 or data[_HEAD + 4 :].startswith(BUNDLE):
        raise OscError("the OSC bundle holds more than one message")
    return data[_HEAD + 4 :]


def _value(tag: str, data: bytes) -> tuple[str | int | float | bool, bytes]:
    if tag in "TF":
        return tag == "T", data
    if tag == "s":
        return _string(data)
    if tag not in "if" or len(data) < 4:
        raise OscError(f"the OSC type {tag!r} is not understood, or its value is cut off")
    (number,) = struct.unpack_from(f">{tag}", data)
    return number, data[4:]


def _string(data: bytes) -> tuple[str, bytes]:
    """Zero-terminated, padded to four bytes."""
    end = data.find(b"\0")
    if end < 0:
        raise OscError("an OSC text has no end")
    try:
        text = data[:end].decode("utf-8")
    except UnicodeDecodeError as error:
        raise OscError("an OSC text is not UTF-8") from error
    return text, data[(end // 4 + 1) * 4 :]
