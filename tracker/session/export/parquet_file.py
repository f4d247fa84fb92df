"""Writes a flat table as an Apache Parquet file, which pandas, Arrow, DuckDB, R and MATLAB read.

Source: github.com/apache/parquet-format (README.md, Encodings.md, parquet.thrift). Per row group
and column there is one data page (version 1) compressed by Zstandard; numbers are stored plain,
words by a dictionary.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO

import numpy as np
import numpy.typing as npt
import zstandard

from tracker import __version__
from tracker.messages import Array, IntArray
from tracker.session.export.thrift import I32, Struct, Value, struct, varint

MAGIC = b"PAR1"
ROWS = 2**17  # of a row group: a megabyte a column
LEVEL = 3  # of Zstandard

# Numbers of parquet.thrift's enums.
INT64, DOUBLE, BYTE_ARRAY = I32(2), I32(5), I32(6)
REQUIRED, OPTIONAL = I32(0), I32(1)
UTF8 = I32(0)
PLAIN, RLE, RLE_DICTIONARY = I32(0), I32(3), I32(8)
ZSTD = I32(6)
DATA_PAGE, DICTIONARY_PAGE = I32(0), I32(2)
STRING_TYPE: Struct = {1: {}}
UTC_NANOSECONDS: Struct = {8: {1: True, 2: {3: {}}}}


@dataclass(frozen=True)
class Times:
    """Whole nanoseconds since 1970 (N,)."""

    name: str
    values: IntArray


@dataclass(frozen=True)
class Numbers:
    """Doubles (N,), where NaN is null."""

    name: str
    values: Array


@dataclass(frozen=True)
class Words:
    """A few words (N,), each again and again."""

    name: str
    values: npt.NDArray[np.str_]


Column = Times | Numbers | Words


def write_parquet(path: Path, columns: Sequence[Column]) -> None:
    """Write columns of one length."""
    count = len(columns[0].values)
    if any(len(c.values) != count for c in columns):
        raise ValueError("the columns are of different lengths")
    with path.open("wb") as file:
        file.write(MAGIC)
        groups = [_row_group(file, columns, slice(k, k + ROWS)) for k in range(0, count, ROWS)]
        footer = struct(
            {
                1: I32(2),
                2: [_root(columns), *(_element(c) for c in columns)],
                3: count,
                4: [*groups],
                6: f"glovetrack version {__version__}",
            }
        )
        file.write(footer + len(footer).to_bytes(4, "little") + MAGIC)


@dataclass
class _Chunk:
    """Pages of one column as they go into the file, and their size without compression."""

    data: bytes = b""
    plain_size: int = 0
    starts: dict[int, int] = field(default_factory=dict)
    """Of a page's kind, from the chunk's start."""

    def add(self, kind: I32, content: bytes, header: Struct) -> None:
        packed = zstandard.ZstdCompressor(level=LEVEL).compress(content)
        place = 7 if kind == DICTIONARY_PAGE else 5
        head = struct({1: kind, 2: I32(len(content)), 3: I32(len(packed)), place: header})
        self.starts[kind] = len(self.data)
        self.data += head + packed
        self.plain_size += len(head) + len(content)


def _row_group(file: BinaryIO, columns: Sequence[Column], rows: slice) -> Struct:
    """Write one, and describe it."""
    chunks = [_write_chunk(file, column, rows) for column in columns]
    return {
        1: [description for description, _ in chunks],
        2: sum(size for _, size in chunks),
        3: len(columns[0].values[rows]),
    }


def _write_chunk(file: BinaryIO, column: Column, rows: slice) -> tuple[Struct, int]:
    """Write one column's pages. Their description and size without compression."""
    start, chunk = file.tell(), _Chunk()
    if isinstance(column, Words):
        _add_words(chunk, column.values[rows])
    else:
        _add_plain(chunk, column.values[rows], isinstance(column, Numbers))
    file.write(chunk.data)
    meta: dict[int, Value] = {
        1: _physical(column),
        2: [PLAIN, RLE, RLE_DICTIONARY] if isinstance(column, Words) else [PLAIN, RLE],
        3: [column.name],
        4: ZSTD,
        5: len(column.values[rows]),
        6: chunk.plain_size,
        7: len(chunk.data),
        9: start + chunk.starts[DATA_PAGE],
    }
    if DICTIONARY_PAGE in chunk.starts:
        meta[11] = start + chunk.starts[DICTIONARY_PAGE]
    return {2: start, 3: meta}, chunk.plain_size


def _add_plain(chunk: _Chunk, values: Array | IntArray, nullable: bool) -> None:
    content = values.astype("<f8" if nullable else "<i8")
    levels = b""
    if nullable:
        known = ~np.isnan(values)
        packed = bit_packed(known.astype(int), 1)
        levels, content = len(packed).to_bytes(4, "little") + packed, content[known]
    chunk.add(DATA_PAGE, levels + content.tobytes(), _data_header(len(values), PLAIN))


def _add_words(chunk: _Chunk, values: npt.NDArray[np.str_]) -> None:
    words, index = np.unique(values, return_inverse=True)
    data = [word.encode() for word in words.tolist()]
    listed = b"".join(len(d).to_bytes(4, "little") + d for d in data)
    chunk.add(DICTIONARY_PAGE, listed, {1: I32(len(data)), 2: PLAIN})
    width = max(1, (len(data) - 1).bit_length())
    content = bytes([width]) + bit_packed(index, width)
    chunk.add(DATA_PAGE, content, _data_header(len(values), RLE_DICTIONARY))


def bit_packed(values: IntArray, width: int) -> bytes:
    """Numbers of ``width`` bits as one bit-packed run of the RLE/bit-packing hybrid."""
    bits = (values[:, None] >> np.arange(width)) & 1
    groups = -(-len(values) // 8)
    packed = np.packbits(bits.astype(np.uint8), bitorder="little").tobytes()
    return varint(groups << 1 | 1) + packed.ljust(groups * width, b"\0")


def _data_header(count: int, encoding: I32) -> Struct:
    return {1: I32(count), 2: encoding, 3: RLE, 4: RLE}


def _physical(column: Column) -> I32:
    return {Times: INT64, Numbers: DOUBLE, Words: BYTE_ARRAY}[type(column)]


def _root(columns: Sequence[Column]) -> Struct:
    return {4: "schema", 5: I32(len(columns))}


def _element(column: Column) -> Struct:
    """The schema of one column."""
    nullable = OPTIONAL if isinstance(column, Numbers) else REQUIRED
    plain: dict[int, Value] = {1: _physical(column), 3: nullable, 4: column.name}
    if isinstance(column, Times):
        return {**plain, 10: UTC_NANOSECONDS}
    if isinstance(column, Words):
        return {**plain, 6: UTF8, 10: STRING_TYPE}
    return plain
