"""Chunks unpacked within bounds, and the records inside."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator

import lz4.frame
import zstandard

from tracker.session.mcap.records import BAD_RECORD, LIMIT

INNOCENT = 4 * 2**20  # bytes that a chunk may unpack to whatever its packed size
MOST_SWELLING = 250  # times its packed size beyond that; sensors' data swell ten times at most
_HEAD = struct.Struct("<QQQII")
_RECORD = struct.Struct("<BQ")


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


def unpacked(chunk: bytes) -> bytes:
    """The records of a chunk record's content. Raises ValueError, in words, if it is damaged."""
    try:
        _, _, size, crc, n = _HEAD.unpack_from(chunk)
        name = chunk[32 : 32 + n].decode()
        packed = chunk[40 + n :]
        if size > LIMIT or size > max(INNOCENT, MOST_SWELLING * len(packed)):
            raise ValueError(f"it says it holds {size} bytes")
        data = decompress(name, packed, size)
    except (*BAD_RECORD, RuntimeError, zstandard.ZstdError) as error:
        raise ValueError(str(error)) from error
    if len(data) != size:
        raise ValueError("it holds another amount of data than it says")
    if crc and zlib.crc32(data) != crc:
        raise ValueError("its checksum is wrong")
    return data


def records(block: bytes) -> Iterator[tuple[int, bytes]]:
    """(opcode, content) of the records in a block. Raises ValueError where one is not whole.

    Opcode 0 is none: a block of zeros would be a record every nine bytes, millions in a chunk.
    """
    at = 0
    while at + _RECORD.size <= len(block):
        opcode, size = _RECORD.unpack_from(block, at)
        at += _RECORD.size
        if opcode == 0 or at + size > len(block):
            raise ValueError("a record in it is not whole")
        yield opcode, block[at : at + size]
        at += size
