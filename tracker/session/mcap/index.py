"""The index of an MCAP file that may be damaged, unfinished, hostile or very long.

The index is read from the summary or, without one, built from the records, so that an unfinished
file is read like a complete one.
"""

from __future__ import annotations

import contextlib
import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from io import BytesIO

from mcap.data_stream import ReadDataStream
from mcap.opcode import Opcode
from mcap.records import Channel, Header, Schema

from tracker.base.errors import DataError, FileError
from tracker.base.notices import failure, notice
from tracker.session.mcap.chunks import MESSAGE, message_records, records, unpacked
from tracker.session.mcap.records import BAD_RECORD, LATEST, LIMIT, MAGIC, Damage, McapFile
from tracker.session.mcap.spans import LooseMessages, Span, Spans

_CHUNK = struct.Struct("<QQQI")
_FOOTER = 37  # bytes of the footer record and the magic bytes after it


@dataclass
class Contents:
    """The offsets of a file's contents."""

    profile: str = ""
    library: str = ""
    schemas: dict[int, Schema] = field(default_factory=dict)
    channels: dict[int, Channel] = field(default_factory=dict)
    spans: Spans = field(default_factory=Spans)
    attachments: list[tuple[int, int]] = field(default_factory=list)  # offset, length of records
    metadata: list[tuple[int, int]] = field(default_factory=list)
    counts: dict[int, int] | None = None  # messages by channel id
    finished: bool = False  # there is a summary
    damage: list[Damage] = field(default_factory=list)

    def define(self, opcode: int, body: bytes) -> None:
        """Takes a schema or channel record; ignores others."""
        stream = ReadDataStream(BytesIO(body))
        if opcode == Opcode.SCHEMA:
            schema = Schema.read(stream)
            self.schemas[schema.id] = schema
        elif opcode == Opcode.CHANNEL:
            channel = Channel.read(stream)
            self.channels[channel.id] = channel

    def read_header(self, file: McapFile, offset: int, length: int) -> None:
        try:
            header = Header.read(ReadDataStream(BytesIO(file.body(offset, length))))
        except BAD_RECORD as error:
            raise FileError(notice("session.header_damaged", path=file.path)) from error
        self.profile, self.library = header.profile, header.library


def read_contents(file: McapFile, scan: bool = False) -> Contents:
    """Returns the contents of ``file``; ``scan``: read all records even if there is a summary."""
    contents = Contents()
    damage: list[Damage] = []
    try:
        if not scan and _read_summary(file, contents):
            return contents
    except BAD_RECORD:
        damage = [Damage(summary_start(file), failure("check.summary_damaged"))]
    contents = Contents(finished=contents.finished or _footer(file) is not None, damage=damage)
    _Scan(file, contents).walk()
    return contents


def span_records(file: McapFile, span: Span) -> Iterator[tuple[int, bytes]]:
    """(opcode, content) of the records in a span. Raises FileError if it is damaged."""
    opcode, length = file.record(span.offset)
    if opcode not in (Opcode.CHUNK, Opcode.MESSAGE):
        raise file.damaged(span.offset, notice("session.no_chunk"))
    try:
        if opcode == Opcode.CHUNK:
            block = unpacked(file.body(span.offset, length))
        else:
            block = file.at(span.offset, min(span.length, LIMIT))
        yield from message_records(block, span.length)
    except ValueError as error:
        raise FileError(
            notice("session.chunk_damaged", path=file.path, offset=span.offset, why=error)
        ) from error


def _footer(file: McapFile) -> bytes | None:
    """The footer record and the magic bytes after it; None if the file was not finished."""
    tail = file.at(max(file.size - _FOOTER, 0), _FOOTER)
    ends = len(tail) == _FOOTER and tail[-8:] == MAGIC and tail[0] == Opcode.FOOTER
    return tail if ends else None


def summary_start(file: McapFile) -> int:
    """Returns the offset of the summary according to the footer; 0 without a summary."""
    tail = _footer(file)
    start = 0 if tail is None else struct.unpack("<Q", tail[9:17])[0]
    return start if start <= file.size - _FOOTER else 0


def _read_summary(file: McapFile, contents: Contents) -> bool:
    """Fills the contents from the summary; returns False without one, or without its index.

    Raises an error of `BAD_RECORD` if it is damaged.
    """
    tail, start = _footer(file), summary_start(file)
    if tail is None:
        return False
    contents.finished = True
    (start, _, crc), end = struct.unpack("<QQI", tail[9:29]), file.size - _FOOTER
    if start == 0:
        return False
    if not start or end - start > LIMIT:
        raise DataError(notice("data.offset"))
    block = file.at(start, end - start)
    if crc and zlib.crc32(tail[:25], zlib.crc32(block)) != crc:
        raise DataError(notice("data.checksum"))
    opcode, length = file.record(len(MAGIC))
    if opcode != Opcode.HEADER:
        raise DataError(notice("data.no_header"))
    contents.read_header(file, len(MAGIC), length)
    for opcode, body in records(block):
        _read_summary_record(file, contents, opcode, body)
    if not contents.spans.channels <= contents.channels.keys():
        return False  # the summary need not repeat them
    return len(contents.spans) > 0 or not any((contents.counts or {}).values())


def _read_summary_record(file: McapFile, contents: Contents, opcode: int, body: bytes) -> None:
    if opcode == Opcode.CHUNK_INDEX:
        start, end, offset, length, n = struct.unpack_from("<QQQQI", body)
        if offset + length > file.size or 36 + n > len(body) or end > LATEST:
            raise EOFError
        ids = frozenset(k for k, _ in struct.iter_unpack("<HQ", body[36 : 36 + n]))
        contents.spans.add(Span(start, end, offset, length, ids or None))
    elif opcode == Opcode.STATISTICS:
        contents.counts = dict(struct.iter_unpack("<HQ", body[46:]))
    elif opcode == Opcode.ATTACHMENT_INDEX:
        contents.attachments.append(struct.unpack_from("<QQ", body))
    elif opcode == Opcode.METADATA_INDEX:
        contents.metadata.append(struct.unpack_from("<QQ", body))
    else:
        contents.define(opcode, body)


class _Scan:
    """Scans the records from the start as far as they are whole."""

    def __init__(self, file: McapFile, contents: Contents) -> None:
        self._file, self._contents = file, contents
        self._loose = LooseMessages(contents.spans)
        self._closed: list[Span] = []  # chunks that were not opened, in the order of the file

    def walk(self) -> None:
        at = len(MAGIC)
        while True:
            opcode, length = self._file.record(at)
            if opcode in (0, Opcode.DATA_END, Opcode.FOOTER):
                break
            if opcode != Opcode.MESSAGE:
                self._loose.flush()
            self._visit(opcode, at, length)
            at += 9 + length
        self._loose.flush()
        if opcode != Opcode.DATA_END:
            self._contents.damage.append(Damage(at, failure("check.breaks_off")))

    def _visit(self, opcode: int, at: int, length: int) -> None:
        c = self._contents
        if opcode == Opcode.HEADER:
            c.read_header(self._file, at, length)
        elif opcode == Opcode.CHUNK:
            self._visit_chunk(at, length)
        elif opcode == Opcode.MESSAGE and length >= MESSAGE.size:
            log_time = MESSAGE.unpack(self._file.at(at + 9, MESSAGE.size))[2]
            self._loose.add(at, 9 + length, log_time)
        elif opcode == Opcode.ATTACHMENT:
            c.attachments.append((at, 9 + length))
        elif opcode == Opcode.METADATA:
            c.metadata.append((at, 9 + length))
        elif opcode in (Opcode.SCHEMA, Opcode.CHANNEL):
            try:
                c.define(opcode, self._file.body(at, length))
            except BAD_RECORD:
                c.damage.append(Damage(at, failure("check.definition")))

    def _visit_chunk(self, at: int, length: int) -> None:
        """Registers a chunk; it is opened only if it has channels that are still unknown. If it
        does not define them, earlier chunks are opened: a writer may define a channel at the end of
        a chunk and write its messages in a later one."""
        c = self._contents
        if length < _CHUNK.size:
            c.damage.append(Damage(at, failure("check.short_chunk")))
            return
        start, end, _, _ = _CHUNK.unpack(self._file.at(at + 9, _CHUNK.size))
        if end > LATEST:
            c.damage.append(Damage(at, failure("check.future_chunk")))
            return
        ids = self._indexed_channels(at + 9 + length)
        span = Span(start, end, at, 9 + length, ids or None)
        if ids and ids <= c.channels.keys():
            self._closed.append(span)
        else:
            try:
                self._define_from(span)
            except (FileError, *BAD_RECORD) as error:
                c.damage.append(Damage(at, failure("check.chunk", why=str(error))))
                return
            self._search_earlier_chunks(ids)
        c.spans.add(span)

    def _define_from(self, span: Span) -> None:
        """Raises an error of `BAD_RECORD`, or FileError, where the chunk is damaged."""
        for opcode, body in span_records(self._file, span):
            if opcode != Opcode.MESSAGE:
                self._contents.define(opcode, body)

    def _search_earlier_chunks(self, ids: frozenset[int]) -> None:
        """Open earlier chunks, the last one first and each once, until these channels are known."""
        while self._closed and not ids <= self._contents.channels.keys():
            with contextlib.suppress(FileError, *BAD_RECORD):  # reported when its messages are read
                self._define_from(self._closed.pop())

    def _indexed_channels(self, at: int) -> frozenset[int]:
        """Channel ids of the message indexes that follow a chunk."""
        ids: set[int] = set()
        while True:
            opcode, length = self._file.record(at)
            if opcode != Opcode.MESSAGE_INDEX or length < 2:
                return frozenset(ids)
            ids.add(struct.unpack("<H", self._file.at(at + 9, 2))[0])
            at += 9 + length
