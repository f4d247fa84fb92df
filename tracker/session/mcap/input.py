"""Reading an MCAP that may be damaged, unfinished, hostile or very long.

Nothing in the file is believed before it is checked against the file's size, and no record makes
the reader allocate more than `LIMIT` bytes. An index is taken from the summary, or made by walking
over the records where there is none, so that an unfinished file is read like a whole one.
"""

from __future__ import annotations

import os
import struct
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import IO, NamedTuple

import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.records import Attachment, Channel, Header, Metadata, Schema

from tracker.errors import FileError
from tracker.session.mcap.decompress import decompress
from tracker.session.mcap.spans import Run, Span, Spans

MAGIC = b"\x89MCAP0\r\n"
LIMIT = 256 * 2**20
INNOCENT = 4 * 2**20  # bytes that a chunk may unpack to whatever its packed size
MOST_SWELLING = 250  # times its packed size beyond that; sensors' data swell ten times at most
FOREVER = 2**64 - 1
_MESSAGE = struct.Struct("<HIQQ")
_CHUNK = struct.Struct("<QQQI")
_BAD_RECORD = (McapError, struct.error, ValueError, EOFError, IndexError, MemoryError)


class RawMessage(NamedTuple):
    """One message as stored; times in ns."""

    topic: str
    type: str
    log_time: int
    publish_time: int
    sequence: int
    data: bytes


class Damage(NamedTuple):
    """Something wrong with the file's bytes."""

    offset: int
    what: str


@dataclass
class Contents:
    """What is where in a file."""

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


class McapInput:
    """An MCAP opened for reading. Raises FileError if it is none.

    ``scan``: walk over all records even if there is a summary.
    """

    def __init__(self, path: Path, scan: bool = False) -> None:
        self.path = Path(path)
        self._file = _open(self.path)
        try:
            self._size = os.fstat(self._file.fileno()).st_size
            if self._at(0, len(MAGIC)) != MAGIC:
                raise FileError(f"{self.path} is not an MCAP file.")
            self.contents = Contents()
            if scan or not self._read_summary():
                self.contents = Contents(finished=self.contents.finished)
                self._scan()
        except FileError:
            self.close()
            raise

    def close(self) -> None:
        self._file.close()

    def _at(self, offset: int, length: int) -> bytes:
        self._file.seek(offset)
        return self._file.read(length)

    def _record(self, offset: int) -> tuple[int, int]:
        """Opcode and content length of the record at ``offset``; (0, 0) past the last whole one."""
        head = self._at(offset, 9)
        if len(head) < 9:
            return 0, 0
        opcode, length = struct.unpack("<BQ", head)
        return (opcode, length) if offset + 9 + length <= self._size else (0, 0)

    def _body(self, offset: int, length: int) -> bytes:
        if length > LIMIT:
            raise FileError(f"{self.path} holds a record of {length} bytes: it is damaged.")
        return self._at(offset + 9, length)

    def _read_summary(self) -> bool:
        """Fill the contents from the summary; False where there is none that can be trusted."""
        tail = self._at(max(self._size - 37, 0), 37)
        if len(tail) < 37 or tail[-8:] != MAGIC or tail[0] != Opcode.FOOTER:
            return False
        start, _, crc = struct.unpack("<QQI", tail[9:29])
        end = self._size - 37
        self.contents.finished = True
        if not 0 < start <= end or end - start > LIMIT:
            return False
        block = self._at(start, end - start)
        if crc and zlib.crc32(tail[:25], zlib.crc32(block)) != crc:
            return False
        opcode, length = self._record(len(MAGIC))
        if opcode != Opcode.HEADER:
            return False
        self._take_header(len(MAGIC), length)
        try:
            self._parse_summary(block)
        except _BAD_RECORD:
            return False
        return len(self.contents.spans) > 0 or not any((self.contents.counts or {}).values())

    def _parse_summary(self, block: bytes) -> None:
        at = 0
        while at + 9 <= len(block):
            opcode, length = struct.unpack_from("<BQ", block, at)
            body = block[at + 9 : at + 9 + length]
            if len(body) < length:
                raise EOFError
            self._take_summary(opcode, body)
            at += 9 + length

    def _take_summary(self, opcode: int, body: bytes) -> None:
        c = self.contents
        if opcode == Opcode.CHUNK_INDEX:
            start, end, offset, length, n = struct.unpack_from("<QQQQI", body)
            if offset + length > self._size or 36 + n > len(body):
                raise EOFError
            ids = frozenset(k for k, _ in struct.iter_unpack("<HQ", body[36 : 36 + n]))
            c.spans.add(Span(start, end, offset, length, ids or None))
        elif opcode == Opcode.STATISTICS:
            c.counts = dict(struct.iter_unpack("<HQ", body[46:]))
        elif opcode == Opcode.ATTACHMENT_INDEX:
            c.attachments.append(struct.unpack_from("<QQ", body))
        elif opcode == Opcode.METADATA_INDEX:
            c.metadata.append(struct.unpack_from("<QQ", body))
        else:
            self._take_definition(opcode, body)

    def _take_definition(self, opcode: int, body: bytes) -> None:
        stream = ReadDataStream(BytesIO(body))
        if opcode == Opcode.SCHEMA:
            schema = Schema.read(stream)
            self.contents.schemas[schema.id] = schema
        elif opcode == Opcode.CHANNEL:
            channel = Channel.read(stream)
            self.contents.channels[channel.id] = channel

    def _take_header(self, offset: int, length: int) -> None:
        try:
            header = Header.read(ReadDataStream(BytesIO(self._body(offset, length))))
        except _BAD_RECORD as error:
            raise FileError(f"{self.path} is not an MCAP file: its header is damaged.") from error
        self.contents.profile, self.contents.library = header.profile, header.library

    def _scan(self) -> None:
        """Walk over the records from the start as far as they are whole."""
        c, at, run = self.contents, len(MAGIC), Run()
        while True:
            opcode, length = self._record(at)
            if opcode in (0, Opcode.DATA_END, Opcode.FOOTER):
                break
            if opcode != Opcode.MESSAGE:
                run.flush(c.spans)
            self._visit(opcode, at, length, run)
            at += 9 + length
        run.flush(c.spans)
        if opcode != Opcode.DATA_END:
            c.damage.append(Damage(at, "the file breaks off here"))

    def _visit(self, opcode: int, at: int, length: int, run: Run) -> None:
        c = self.contents
        if opcode == Opcode.HEADER:
            self._take_header(at, length)
        elif opcode == Opcode.CHUNK:
            self._visit_chunk(at, length)
        elif opcode == Opcode.MESSAGE and length >= _MESSAGE.size:
            log_time = _MESSAGE.unpack(self._at(at + 9, _MESSAGE.size))[2]
            run.add(c.spans, at, 9 + length, log_time)
        elif opcode == Opcode.ATTACHMENT:
            c.attachments.append((at, 9 + length))
        elif opcode == Opcode.METADATA:
            c.metadata.append((at, 9 + length))
        elif opcode in (Opcode.SCHEMA, Opcode.CHANNEL):
            try:
                self._take_definition(opcode, self._body(at, length))
            except _BAD_RECORD:
                c.damage.append(Damage(at, "a definition is damaged"))

    def _visit_chunk(self, at: int, length: int) -> None:
        """Note a chunk; it is opened only if it speaks of channels that are still unknown."""
        if length < _CHUNK.size:
            self.contents.damage.append(Damage(at, "a chunk is too short"))
            return
        start, end, _, _ = _CHUNK.unpack(self._at(at + 9, _CHUNK.size))
        ids = self._indexed_channels(at + 9 + length)
        span = Span(start, end, at, 9 + length, ids or None)
        if not ids or not ids <= self.contents.channels.keys():
            try:
                for opcode, body in self._inside(span):
                    if opcode != Opcode.MESSAGE:
                        self._take_definition(opcode, body)
            except (FileError, *_BAD_RECORD) as error:
                self.contents.damage.append(Damage(at, f"a chunk cannot be read ({error})"))
                return
        self.contents.spans.add(span)

    def _indexed_channels(self, at: int) -> frozenset[int]:
        """Channel ids of the message indexes that follow a chunk."""
        ids: set[int] = set()
        while True:
            opcode, length = self._record(at)
            if opcode != Opcode.MESSAGE_INDEX or length < 2:
                return frozenset(ids)
            ids.add(struct.unpack("<H", self._at(at + 9, 2))[0])
            at += 9 + length

    def _inside(self, span: Span) -> Iterator[tuple[int, bytes]]:
        """(opcode, content) of the records in a span. Raises FileError if it is damaged."""
        opcode, length = self._record(span.offset)
        if opcode == Opcode.CHUNK:
            block = self._chunk_data(span.offset, length)
        elif opcode == Opcode.MESSAGE:
            block = self._at(span.offset, min(span.length, LIMIT))
        else:
            raise FileError(f"{self.path} is damaged at byte {span.offset}: there is no chunk.")
        at = 0
        while at + 9 <= len(block):
            opcode, size = struct.unpack_from("<BQ", block, at)
            if at + 9 + size > len(block):
                raise FileError(f"{self.path} is damaged in the chunk at byte {span.offset}.")
            yield opcode, block[at + 9 : at + 9 + size]
            at += 9 + size

    def _chunk_data(self, offset: int, length: int) -> bytes:
        body = self._body(offset, length)
        where = f"{self.path} is damaged in the chunk at byte {offset}"
        try:
            _, _, size, crc, n = struct.unpack_from("<QQQII", body)
            name = body[32 : 32 + n].decode()
            packed = body[40 + n :]
            if size > LIMIT or size > max(INNOCENT, MOST_SWELLING * len(packed)):
                raise FileError(f"{where}: it says it holds {size} bytes.")
            data = decompress(name, packed, size)
        except (*_BAD_RECORD, RuntimeError, zstandard.ZstdError) as error:
            raise FileError(f"{where}: {error}.") from error
        if len(data) != size:
            raise FileError(f"{where}: it holds another amount of data than it says.")
        if crc and zlib.crc32(data) != crc:
            raise FileError(f"{where}: its checksum is wrong.")
        return data

    def messages_in(self, span: Span, topics: frozenset[str] | None = None) -> list[RawMessage]:
        """Messages of a span in file order. Raises FileError if it is damaged."""
        out = []
        for opcode, body in self._inside(span):
            if opcode != Opcode.MESSAGE or len(body) < _MESSAGE.size:
                continue
            channel_id, sequence, log, publish = _MESSAGE.unpack_from(body)
            channel = self.contents.channels.get(channel_id)
            if channel is None or (topics is not None and channel.topic not in topics):
                continue
            kind = self.type_of(channel)
            out.append(
                RawMessage(channel.topic, kind, log, publish, sequence, body[_MESSAGE.size :])
            )
        return out

    def type_of(self, channel: Channel) -> str:
        """Type name of a channel's messages, empty if unknown."""
        schema = self.contents.schemas.get(channel.schema_id)
        return schema.name if schema is not None else ""

    def spans_with(
        self, topics: frozenset[str] | None, start: int = 0, end: int = FOREVER, back: bool = False
    ) -> Iterator[Span]:
        """Spans between two log times that may hold one of ``topics``, by start or backwards."""
        ids = None
        if topics is not None:
            ids = {i for i, c in self.contents.channels.items() if c.topic in topics}
        indices = self.contents.spans.between(start, end)
        for i in indices[::-1] if back else indices:
            span = self.contents.spans[int(i)]
            if ids is None or span.channels is None or not ids.isdisjoint(span.channels):
                yield span

    def attachments(self) -> Iterator[Attachment]:
        for offset, _ in self.contents.attachments:
            body = self._checked_body(offset, Opcode.ATTACHMENT)
            with self._in_words(offset):
                record = Attachment.read(ReadDataStream(BytesIO(body)))
            yield record

    def metadata(self) -> Iterator[Metadata]:
        for offset, _ in self.contents.metadata:
            body = self._checked_body(offset, Opcode.METADATA)
            with self._in_words(offset):
                extra = Metadata.read(ReadDataStream(BytesIO(body)))
            yield extra

    @contextmanager
    def _in_words(self, offset: int) -> Iterator[None]:
        try:
            yield
        except _BAD_RECORD as error:
            raise FileError(f"{self.path} is damaged at byte {offset}.") from error

    def _checked_body(self, offset: int, opcode: int) -> bytes:
        found, length = self._record(offset)
        if found != opcode:
            raise FileError(f"{self.path} is damaged at byte {offset}.")
        body = self._body(offset, length)
        if (
            opcode == Opcode.ATTACHMENT
            and zlib.crc32(body[:-4]) != struct.unpack("<I", body[-4:])[0]
        ):
            raise FileError(
                f"{self.path} is damaged: the attachment at byte {offset} is not whole."
            )
        return body


def _open(path: Path) -> IO[bytes]:
    try:
        return path.open("rb")
    except FileNotFoundError as error:
        raise FileError(f"There is no file {path}.") from error
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error.strerror}.") from error
