"""Writes MCAP files of profile ``ros2`` whose chunks are closed by size and by time.

A thread of its own synchronises the file with the disk, which takes milliseconds on a disk and
tenths of a second on a memory card or a loaded one. Meanwhile the next chunks are written, and one
synchronisation for all of them follows.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from mcap.writer import CompressionType, Writer

from tracker import __version__
from tracker.base.errors import FileError
from tracker.base.files import DiskError
from tracker.base.notices import notice
from tracker.session.mcap.disk import WholeRecordFile
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.ros.definitions import definition


class SyncThread:
    """Calls ``sync``, which may raise DiskError, after `soon`; methods are for one thread."""

    def __init__(self, sync: Callable[[], None]) -> None:
        self._sync = sync
        self._requested, self._ending = threading.Event(), False
        self._error: DiskError | None = None
        self._thread = threading.Thread(target=self._run, name="glovetrack-sync", daemon=True)
        self._thread.start()

    def soon(self) -> None:
        """Request that everything written so far is synchronised. Raises DiskError of an earlier
        synchronisation."""
        if self._error is not None:
            raise self._error
        self._requested.set()

    def _run(self) -> None:
        while True:
            self._requested.wait()
            self._requested.clear()
            if self._ending:
                return
            try:
                self._sync()
            except DiskError as error:
                self._error = error
                return

    def end(self) -> None:
        """Wait for the current synchronisation and end the thread."""
        self._ending = True
        self._requested.set()
        self._thread.join()


COMPRESSION = {
    "lz4": CompressionType.LZ4,
    "zstd": CompressionType.ZSTD,
    "none": CompressionType.NONE,
}


MOST_CHANNELS = 65_535
"""Channels and schemas are numbered in 16 bits; schema 0 means no schema."""


class _Waiting(NamedTuple):
    """A message that has not been written to the file yet."""

    log_time: int
    channel: int
    stamp: int
    sequence: int
    data: bytes


class McapOutput:
    """An MCAP being written.

    ``chunk_ns``: the longest log time that a chunk spans and that may be unwritten. Late messages,
    after others of a later log time, go into chunks of their own. ``sync``: synchronise each chunk
    with the disk, against loss of power; ``sync_in_thread``: without waiting for it.
    """

    def __init__(
        self,
        path: Path,
        compression: str = "lz4",
        chunk_bytes: int = 64 * 1024,
        chunk_ns: int = 400_000_000,
        sync: bool = True,
        sync_in_thread: bool = False,
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
        self._syncing = SyncThread(self._file.sync) if sync and sync_in_thread else None
        self._schemas: dict[str, int] = {}
        self._channels: dict[str, int] = {}
        self._n_channels = self._n_schemas = 0
        self._chunk_bytes = chunk_bytes
        self._waiting: list[_Waiting] = []
        self._waiting_bytes = 0  # bytes of waiting messages
        self._newest = self._opened = 0  # latest log time of all; the same when waiting began

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
        self._n_schemas += 1
        if self._n_schemas > MOST_CHANNELS:
            raise FileError(notice("session.many_types", most=MOST_CHANNELS))
        return self._writer.register_schema(name, encoding, data)

    def add_channel(
        self, topic: str, encoding: str, schema_id: int, metadata: dict[str, str]
    ) -> int:
        self._n_channels += 1
        if self._n_channels > MOST_CHANNELS:
            raise FileError(notice("session.many_channels", most=MOST_CHANNELS))
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
        """Add one message; waiting ones are written first if they have waited long enough."""
        newest = max(self._newest, log_time)
        if self._waiting and newest - self._opened >= self._chunk_ns:
            self.close_chunk()
        if not self._waiting:
            self._opened = newest
        self._newest = newest
        # 0 replaces unknown times before 1970, which the format does not allow.
        self._waiting.append(
            _Waiting(max(log_time, 0), channel, max(stamp, 0), sequence, bytes(data))
        )
        self._waiting_bytes += len(data)
        if self._waiting_bytes > self._chunk_bytes:
            self.close_chunk()

    def close_chunk(self) -> None:
        """Writes buffered data to the disk."""
        self._write_waiting()
        if self._syncing is not None:
            self._syncing.soon()
        elif self._sync:
            self._file.sync()

    def _write_waiting(self) -> None:
        """Writes waiting messages in the order of log times, and of arrival if these are equal."""
        waiting, self._waiting, self._waiting_bytes = self._waiting, [], 0
        begun = None
        for m in sorted(waiting, key=lambda m: m.log_time):
            if begun is not None and m.log_time - begun >= self._chunk_ns:
                self._writer.flush()
                begun = None
            begun = m.log_time if begun is None else begun
            self._writer.add_message(m.channel, m.log_time, m.data, m.stamp, m.sequence)
        self._writer.flush()

    def finish(self) -> None:
        """Write the summary and close the file, the file itself in any case."""
        try:
            self._end_sync()
            self._write_waiting()
            self._writer.finish()
            if self._sync:
                self._file.sync()
        finally:
            self._file.close()

    def abandon(self) -> None:
        """Closes the file unfinished; `recover` can complete it."""
        self._end_sync()
        self._file.close()

    def _end_sync(self) -> None:
        syncing, self._syncing = self._syncing, None
        if syncing is not None:
            syncing.end()


class Copier:
    """Writes messages of ``source`` to ``out`` unchanged, with their channels and schemas."""

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

    def write(self, m: RawMessage) -> None:
        """A new message, on the source's channel where it has one of that topic and type."""
        channel = self._channels.get((m.topic, m.type))
        if channel is None:
            channel = self._channels[m.topic, m.type] = self._out.channel(m.topic, m.type)
        self._out.write(channel, m.log_time, m.publish_time, m.data, m.sequence)

    def copy(self, m: RawMessage) -> None:
        channel = self._channels[m.topic, m.type]
        self._out.write(channel, m.log_time, m.publish_time, m.data, m.sequence)
