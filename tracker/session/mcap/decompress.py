"""Chunks unpacked within bounds."""

from __future__ import annotations

import lz4.frame
import zstandard


def decompress(name: str, packed: bytes, size: int) -> bytes:
    """A chunk's records, never more than ``size`` + 1 bytes of them."""
    if name == "":
        return packed
    if name == "lz4":
        return bytes(lz4.frame.LZ4FrameDecompressor().decompress(packed, max_length=size + 1))
    if name == "zstd":
        with zstandard.ZstdDecompressor(max_window_size=2**27).stream_reader(packed) as stream:
            return bytes(stream.read(size + 1))
    raise ValueError(f"the compression {name[:20]!r} is unknown")
