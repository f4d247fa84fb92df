"""One OSC 1.0 message from untrusted bytes; bundles of one message are opened.

Types are those that senders of commands use: int32, float32, string, true, false.
"""

from __future__ import annotations

import struct

from tracker.base.errors import DataError
from tracker.base.notices import notice

BUNDLE = b"#bundle\0"
_HEAD = len(BUNDLE) + 8  # with the time tag


class OscError(DataError):
    """Not OSC, or not of the part of it that is understood here."""


def message(data: bytes) -> tuple[str, list[str | int | float | bool]]:
    """Address and values. Raises OscError."""
    if data.startswith(BUNDLE):
        data = _alone(data)
    address, rest = _string(data)
    if not address.startswith("/"):
        raise OscError(notice("osc.no_slash"))
    if not rest:
        return address, []  # older senders leave the tags out
    tags, rest = _string(rest)
    if not tags.startswith(","):
        raise OscError(notice("osc.no_tags"))
    values: list[str | int | float | bool] = []
    for tag in tags[1:]:
        value, rest = _value(tag, rest)
        values.append(value)
    return address, values


def _alone(data: bytes) -> bytes:
    """The first message of a bundle, which must be the only one."""
    if len(data) < _HEAD + 4:
        raise OscError(notice("osc.truncated"))
    (size,) = struct.unpack_from(">i", data, _HEAD)
    if size != len(data) - _HEAD - 4 or data[_HEAD + 4 :].startswith(BUNDLE):
        raise OscError(notice("osc.several"))
    return data[_HEAD + 4 :]


def _value(tag: str, data: bytes) -> tuple[str | int | float | bool, bytes]:
    if tag in "TF":
        return tag == "T", data
    if tag == "s":
        return _string(data)
    if tag not in "if" or len(data) < 4:
        raise OscError(notice("osc.type", tag=tag))
    (number,) = struct.unpack_from(f">{tag}", data)
    return number, data[4:]


def _string(data: bytes) -> tuple[str, bytes]:
    """Zero-terminated, padded to four bytes."""
    end = data.find(b"\0")
    if end < 0:
        raise OscError(notice("osc.no_end"))
    try:
        text = data[:end].decode("utf-8")
    except UnicodeDecodeError as error:
        raise OscError(notice("osc.not_utf8")) from error
    return text, data[(end // 4 + 1) * 4 :]
