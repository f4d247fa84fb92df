"""Reading an MCAP that may be damaged, unfinished, hostile or very long."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import NamedTuple

from mcap.data_stream import ReadDataStream
from mcap.opcode import Opcode
from mcap.records import Attachment, Channel, Metadata

from tracker.base.damage import LeftOut
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.session.mcap.chunks import MESSAGE
from tracker.session.mcap.index import read_contents, span_records
from tracker.session.mcap.records import LATEST, LIMIT, McapFile
from tracker.session.mcap.spans import Span

FOREVER = 2**64 - 1
MOST_METADATA = 2**20  # bytes of one record


class RawMessage(NamedTuple):
    """One message as stored; times in ns."""

    topic: str
    type: str
    log_time: int
    publish_time: int
    sequence: int
    data: bytes


class McapInput:
    """An MCAP opened for reading. Raises FileError if it is not one.

    ``scan``: read all records even if there is a summary. ``left_out`` counts messages with damaged
    content, which decoders skip.
    """

    def __init__(self, path: Path, scan: bool = False) -> None:
        self._file = McapFile(path)
        self.path = self._file.path
        self.left_out = LeftOut(self.path)
        try:
            self.contents = read_contents(self._file, scan)
        except FileError:
            self.close()
            raise

    def close(self) -> None:
        self._file.close()

    def messages_in(self, span: Span, topics: frozenset[str] | None = None) -> list[RawMessage]:
        """Messages of a span in file order. Raises FileError if it is damaged."""
        out = []
        for opcode, body in span_records(self._file, span):
            if opcode != Opcode.MESSAGE:
                continue
            channel_id, sequence, log, publish = MESSAGE.unpack_from(body)
            if log > LATEST or publish > LATEST:
                raise self._file.damaged(span.offset, notice("session.far_future"))
            channel = self.contents.channels.get(channel_id)
            if channel is None or (topics is not None and channel.topic not in topics):
                continue
            kind = self.type_of(channel)
            out.append(
                RawMessage(channel.topic, kind, log, publish, sequence, body[MESSAGE.size :])
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
        """Raises FileError where one is damaged."""
        for entry in self.contents.attachments:
            yield self.attachment_at(entry)

    def attachment_at(self, entry: tuple[int, int]) -> Attachment:
        """One of ``contents.attachments``. Raises FileError if it is damaged."""
        offset, _ = entry
        body = self._checked_body(offset, Opcode.ATTACHMENT)
        with self._file.explained(offset):
            (crc,) = struct.unpack("<I", body[-4:])  # 0: no checksum
            record = Attachment.read(ReadDataStream(BytesIO(body)))
        if crc and zlib.crc32(body[:-4]) != crc:
            raise FileError(notice("session.attachment_damaged", path=self.path, offset=offset))
        return record

    def metadata(self) -> Iterator[Metadata]:
        """Raises FileError where one is damaged."""
        for entry in self.contents.metadata:
            yield self.metadata_at(entry)

    def metadata_at(self, entry: tuple[int, int]) -> Metadata:
        """One of ``contents.metadata``. Raises FileError if it is damaged."""
        offset, _ = entry
        body = self._checked_body(offset, Opcode.METADATA, MOST_METADATA)
        with self._file.explained(offset):
            return Metadata.read(ReadDataStream(BytesIO(body)))

    def _checked_body(self, offset: int, opcode: int, limit: int = LIMIT) -> bytes:
        found, length = self._file.record(offset)
        if found != opcode:
            raise self._file.damaged(offset)
        return self._file.body(offset, length, limit)
