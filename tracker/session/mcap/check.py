"""Finds faults of a finished file outside its chunks: wrong checksums and indexes."""

from __future__ import annotations

import struct
import zlib
from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path

from mcap.opcode import Opcode

from tracker.base.errors import FileError
from tracker.base.notices import failure
from tracker.session.mcap.chunks import MESSAGE
from tracker.session.mcap.index import Contents, read_contents, span_records, summary_start
from tracker.session.mcap.records import Damage, McapFile
from tracker.session.mcap.spans import Span

_DATA_END = 13  # bytes of the record that ends the data section, with the section's CRC-32
_BLOCK = 2**20
_Entries = dict[int, list[tuple[int, int]]]


def index_damage(path: Path, contents: Contents) -> list[Damage]:
    """Returns the faults of a file whose ``contents`` were read from its summary.

    A checksum of the data section is sufficient; without one all records are read, and the summary
    and the message indexes are compared with them.
    """
    file = McapFile(path)
    try:
        start = summary_start(file)
        if start <= _DATA_END:
            return []
        at = start - _DATA_END
        if file.record(at) != (Opcode.DATA_END, 4):
            return [Damage(at, failure("check.data_end"))]
        (crc,) = struct.unpack("<I", file.at(at + 9, 4))
        if crc:
            whole = crc == _checksum(file, at)
            return [] if whole else [Damage(0, failure("check.checksum"))]
        return _compared(file, contents)
    finally:
        file.close()


def _checksum(file: McapFile, end: int) -> int:
    crc = 0
    for at in range(0, end, _BLOCK):
        crc = zlib.crc32(file.at(at, min(_BLOCK, end - at)), crc)
    return crc


def _compared(file: McapFile, contents: Contents) -> list[Damage]:
    found = read_contents(file, scan=True)
    pairs = (
        ("chunks", {s[:4] for s in _all(contents)}, {s[:4] for s in _all(found)}),
        ("attachments", contents.attachments, found.attachments),
        ("metadata", contents.metadata, found.metadata),
        ("channels", _fields(contents.channels), _fields(found.channels)),
        ("schemas", _fields(contents.schemas), _fields(found.schemas)),
    )
    differ = [name for name, indexed, found in pairs if indexed != found]
    out = [Damage(0, failure("check.summary_differs", records=name)) for name in differ]
    for span in _all(contents):
        out += _message_index_damage(file, span)
    return [*found.damage, *out]


def _all(contents: Contents) -> list[Span]:
    return [contents.spans[i] for i in range(len(contents.spans))]


def _fields(records: Mapping[int, object]) -> dict[int, dict[str, object]]:
    return {i: vars(r) for i, r in records.items()}


def _message_index_damage(file: McapFile, span: Span) -> list[Damage]:
    """Faults of a chunk whose message indexes do not match its messages."""
    if file.record(span.offset)[0] != Opcode.CHUNK:
        return []
    try:
        named, there = (
            _indexed_messages(file, span.offset + span.length),
            _chunk_messages(file, span),
        )
    except (FileError, struct.error):
        return []  # a damaged chunk is reported elsewhere
    if named and named != there:
        return [Damage(span.offset, failure("check.message_index"))]
    return []


def _indexed_messages(file: McapFile, at: int) -> _Entries:
    """Returns (log time, offset in the chunk) by channel, from the index records at ``at``."""
    out: _Entries = {}
    while True:
        opcode, length = file.record(at)
        if opcode != Opcode.MESSAGE_INDEX:
            return out
        body = file.body(at, length)
        channel, size = struct.unpack_from("<HI", body)
        entries = list(struct.iter_unpack("<QQ", body[6 : 6 + size]))
        if entries:
            out[channel] = sorted(entries)
        at += 9 + length


def _chunk_messages(file: McapFile, span: Span) -> _Entries:
    """Returns the same from the chunk itself."""
    out: defaultdict[int, list[tuple[int, int]]] = defaultdict(list)
    at = 0
    for opcode, body in span_records(file, span):
        if opcode == Opcode.MESSAGE:
            channel, _, log_time, _ = MESSAGE.unpack_from(body)
            out[channel].append((log_time, at))
        at += 9 + len(body)
    return {channel: sorted(entries) for channel, entries in out.items()}
