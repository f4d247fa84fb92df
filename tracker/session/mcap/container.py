"""Writing an MCAP of profile ``ros2`` whose chunks close by size and by time."""

from __future__ import annotations

from pathlib import Path

from mcap.writer import CompressionType, Writer

from tracker import __version__
from tracker.session.mcap.disk import WholeRecordFile
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.ros.definitions import definition

COMPRESSION = {
    "lz4": CompressionType.LZ4,
    "zstd": CompressionType.ZSTD,
    "none": CompressionType.NONE,
}


class McapOutput:
    """An MCAP being written. ``chunk_ns``: the longest log time that may stay unwritten."""

    def __init__(
        self,
        path: Path,
        compression: str = "lz4",
        chunk_bytes: int = 64 * 1024,
        chunk_ns: int = 400_000_000,
        sync: bool = True,
    ) -> None:
        self._file = WholeRecordFile(path)
        self._writer = Writer(
            self._file,  # type: ignore[arg-type]
            chunk_size=chunk_bytes,
            compression=COMPRESSION[compression],
            enable_data_crcs=True,
        )
        self._writer.start("ros2", f"glovetrack {__version__}")
        self._chunk_ns, self._sync = chunk_ns, sync
        self._schemas: dict[str, int] = {}
        self._channels: dict[str, int] = {}
        self._opened: int | None = None  # log time of the first message since the last close

    @property
    def size(self) -> int:
        """Bytes in the file so far."""
        return self._file.tell()

    def attach(self, name: str, text: str, log_time: int) -> None:
        self._writer.add_attachment(0, log_time, name, "application/toml", text.encode())

    def attach_bytes(self, name: str, media_type: str, data: bytes, log_time: int) -> None:
        self._writer.add_attachment(0, log_time, name, media_type, data)

    def metadata(self, name: str, values: dict[str, str]) -> None:
        self._writer.add_metadata(name, values)

    def add_schema(self, name: str, encoding: str, data: bytes) -> int:
        return self._writer.register_schema(name, encoding, data)

    def add_channel(
        self, topic: str, encoding: str, schema_id: int, metadata: dict[str, str]
    ) -> int:
        return self._writer.register_channel(topic, encoding, schema_id, metadata)

    def channel(self, topic: str, type_name: str) -> int:
        """The id of a ROS 2 topic; registered with its definition at first use."""
        if topic not in self._channels:
            if type_name not in self._schemas:
                text = definition(type_name).encode()
                self._schemas[type_name] = self.add_schema(type_name, "ros2msg", text)
            self._channels[topic] = self.add_channel(
                topic, "cdr", self._schemas[type_name], {"offered_qos_profiles": ""}
            )
        return self._channels[topic]

    def write(self, channel: int, log_time: int, stamp: int, data: bytes, sequence: int) -> None:
        """Add one message; closes the chunk first if this one would make it too long."""
        if self._opened is not None and log_time - self._opened >= self._chunk_ns:
            self.close_chunk()
        if self._opened is None:
            self._opened = log_time
        # 0 stands for unknown times before 1970, which the format cannot hold.
        self._writer.add_message(channel, max(log_time, 0), data, max(stamp, 0), sequence)

    def close_chunk(self) -> None:
        """Write what is held back, down to the disk."""
        self._writer.flush()
        self._opened = None
        if self._sync:
            self._file.sync()

    def finish(self) -> None:
        """Write the summary and close the file, the file itself in any case."""
        try:
            self._writer.finish()
            if self._sync:
                self._file.sync()
        finally:
            self._file.close()

    def abandon(self) -> None:
        """Close the file as it is; `recover` makes a regular one of it."""
        self._file.close()


class Copier:
    """Writes messages of ``source`` to ``out`` as they are, with their channels and schemas."""

    def __init__(self, source: McapInput, out: McapOutput) -> None:
        contents = source.contents
        self._out = out
        schemas = {
            s.id: out.add_schema(s.name, s.encoding, s.data) for s in contents.schemas.values()
        }
        self._channels = {
            (c.topic, source.type_of(c)): out.add_channel(
                c.topic, c.message_encoding, schemas.get(c.schema_id, 0), dict(c.metadata)
            )
            for c in contents.channels.values()
        }

    def copy(self, m: RawMessage) -> None:
        channel = self._channels[m.topic, m.type]
        self._out.write(channel, m.log_time, m.publish_time, m.data, m.sequence)
