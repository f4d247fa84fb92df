"""Unpacks chunks within size limits, and reads their records."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator

import lz4.frame
import zstandard
from mcap.opcode import Opcode

from tracker.base.errors import DataError
from tracker.base.notices import notice
from tracker.session.mcap.records import BAD_RECORD, LIMIT

ALWAYS_ALLOWED = 4 * 2**20  # bytes to which any chunk may unpack
MAX_EXPANSION = 250  # times the packed size for larger ones; sensor data expand ten times at most
_HEAD = struct.Struct("<QQQII")
_RECORD = struct.Struct("<BQ")
MESSAGE = struct.Struct("<HIQQ")
"""Channel, sequence, log time and publish time of a message; its data follow."""
_IN_CHUNKS = (Opcode.SCHEMA, Opcode.CHANNEL, Opcode.MESSAGE)
_FEW, _FEWEST_BYTES = 64, 4


def decompress(name: str, packed: bytes, size: int) -> bytes:
    """A chunk's records, never more than ``size`` + 1 bytes of them."""
    if name == "":
        return packed
    if name == "lz4":
        return bytes(lz4.frame.LZ4FrameDecompressor().decompress(packed, max_length=size + 1))
    if name == "zstd":
        with zstandard.ZstdDecompressor(max_window_size=2**27).stream_reader(packed) as stream:
            return bytes(stream.read(size + 1))
    raise DataError(notice("data.compression", name=name[:20]))


def unpacked(chunk: bytes) -> bytes:
    """Returns the records of a chunk. Raises ValueError if it is damaged."""
    try:
        _, _, size, crc, n = _HEAD.unpack_from(chunk)
        name = chunk[32 : 32 + n].decode()
        packed = chunk[40 + n :]
        if size > LIMIT or size > max(ALWAYS_ALLOWED, MAX_EXPANSION * len(packed)):
            raise DataError(notice("data.declared_size", size_bytes=size))
        data = decompress(name, packed, size)
    except DataError:
        raise
    except (*BAD_RECORD, RuntimeError, zstandard.ZstdError) as error:
        raise ValueError(str(error)) from error
    if len(data) != size:
        raise DataError(notice("data.size"))
    if crc and zlib.crc32(data) != crc:
        raise DataError(notice("data.checksum"))
    return data


def records(block: bytes) -> Iterator[tuple[int, bytes]]:
    """Yields (opcode, content) of the records in a block. Raises ValueError for an incomplete one.

    Opcode 0 is invalid: a block of zeros would be a record every nine bytes.
    """
    at = 0
    while at < len(block):
        if at + _RECORD.size > len(block):
            raise DataError(notice("data.incomplete_record"))
        opcode, size = _RECORD.unpack_from(block, at)
        at += _RECORD.size
        if opcode == 0 or at + size > len(block):
            raise DataError(notice("data.incomplete_record"))
        yield opcode, block[at : at + size]
        at += size


def message_records(block: bytes, length: int) -> Iterator[tuple[int, bytes]]:
    """Yields `records` of a span of ``length`` bytes of the file.

    Raises ValueError also for a record that is not allowed in a chunk, and for more records than so
    few bytes can contain: every message has two times and a number, which compression cannot reduce
    below four bytes. So the work on a file is bounded by its size.
    """
    most = _FEW + length // _FEWEST_BYTES
    for n, (opcode, body) in enumerate(records(block)):
        if opcode not in _IN_CHUNKS or (opcode == Opcode.MESSAGE and len(body) < MESSAGE.size):
            raise DataError(notice("data.incomplete_record"))
        if n > most:
            raise DataError(notice("data.many_messages"))
        yield opcode, body
