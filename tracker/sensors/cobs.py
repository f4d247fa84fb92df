"""Consistent Overhead Byte Stuffing (Cheshire & Baker 1999, doi:10.1109/90.769765).

It rewrites bytes so that no zero is left, for at most one byte more in 254; a zero then ends a
frame regardless of the preceding bytes.
"""

from __future__ import annotations

MAX_RUN = 254


class CobsError(ValueError):
    """The bytes are not a COBS encoding."""


def encode(data: bytes) -> bytes:
    """``data`` without zeros (the closing zero is not added)."""
    out = bytearray()
    blocks = data.split(b"\0")
    for n, block in enumerate(blocks):
        last = n == len(blocks) - 1
        while len(block) >= MAX_RUN:
            out += b"\xff" + block[:MAX_RUN]
            block = block[MAX_RUN:]
            if last and not block:
                return bytes(out)  # a full run at the end encodes no zero
        out.append(len(block) + 1)
        out += block
    return bytes(out)


def decode(data: bytes) -> bytes:
    """The inverse of `encode`. Raises CobsError for an empty text, a zero or a run cut short."""
    if not data or 0 in data:
        raise CobsError("empty, or a zero inside")
    out = bytearray()
    i, n = 0, len(data)
    while i < n:
        code = data[i]
        end = i + code
        if end > n:
            raise CobsError("a run goes past the end")
        out += data[i + 1 : end]
        i = end
        if code <= MAX_RUN and i < n:
            out.append(0)
    return bytes(out)
