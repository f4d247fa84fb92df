"""Thrift's compact protocol, as far as writing needs it: in it a Parquet file describes itself.

Source: github.com/apache/thrift, doc/specs/thrift-compact-protocol.md.

A struct is a dict from a field's number to its value. A value's Python type says what it is in
Thrift: bool, `I32`, int (64 bits), str (UTF-8), list (of one type; of structs
where it is empty) or dict (a struct).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

Value: TypeAlias = "bool | int | str | list[Value] | Struct"
Struct: TypeAlias = Mapping[int, Value]

TRUE, FALSE, INT32, INT64, BINARY, LIST, STRUCT = 1, 2, 5, 6, 8, 9, 12
STOP = b"\0"
MAX_SHORT = 14  # elements of a list whose number stands beside their type, 15 says "see next"


class I32(int):
    """A number that Thrift's definition has as i32 or as an enum."""


def struct(fields: Struct) -> bytes:
    """A struct's bytes, from its fields by number."""
    out, before = b"", 0
    for number, value in sorted(fields.items()):
        kind, step = _kind(value), number - before
        if not 0 < step <= 15:
            raise ValueError(f"field {number} after {before}: more than 15 apart")
        out += bytes([step << 4 | kind]) + (b"" if kind in (TRUE, FALSE) else _content(value))
        before = number
    return out + STOP


def varint(value: int) -> bytes:
    """A number from 0 in groups of seven bits, the lowest first."""
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes([*out, value])


def _kind(value: Value) -> int:
    if isinstance(value, bool):
        return TRUE if value else FALSE
    if isinstance(value, int):
        return INT32 if isinstance(value, I32) else INT64
    if isinstance(value, str):
        return BINARY
    return LIST if isinstance(value, list) else STRUCT


def _content(value: Value) -> bytes:
    """What follows a value's type; of a bool nothing does."""
    if isinstance(value, int):
        return varint(value << 1 if value >= 0 else -value * 2 - 1)  # zigzag
    if isinstance(value, str):
        data = value.encode()
        return varint(len(data)) + data
    if isinstance(value, list):
        kind, size = _kind(value[0]) if value else STRUCT, len(value)
        head = bytes([min(size, 15) << 4 | kind]) + (varint(size) if size > MAX_SHORT else b"")
        return head + b"".join(_content(v) for v in value)
    return struct(value)
