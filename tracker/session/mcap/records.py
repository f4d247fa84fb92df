"""Reads records of an MCAP file by offset, validated before use.

Every length is checked against the file's size before use, and no record makes the reader allocate
more than `LIMIT` bytes.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, NamedTuple

from mcap.exceptions import McapError

from tracker.base.errors import FileError
from tracker.base.files import check_regular
from tracker.base.notices import Notice, notice

MAGIC = b"\x89MCAP0\r\n"
LIMIT = 256 * 2**20
BAD_RECORD = (
    *(McapError, struct.error, ValueError, EOFError, IndexError, MemoryError, OverflowError),
)
"""Errors that parsing a damaged record raises."""
LATEST = 2**63 - 1
"""ns since 1970 (the year 2262): the last instant that anything here can count to."""
_HEAD = struct.Struct("<BQ")


class Damage(NamedTuple):
    """Something wrong with the file's bytes."""

    offset: int
    what: Notice


class McapFile:
    """An MCAP file opened for reading. Raises FileError if it is not one."""

    def __init__(self, path: Path) -> None:
        self.path = Path(path)
        self._file = _open(self.path)
        self.size = os.fstat(self._file.fileno()).st_size
        if self.at(0, len(MAGIC)) != MAGIC:
            self.close()
            raise FileError(notice("session.not_mcap", path=self.path))

    def close(self) -> None:
        self._file.close()

    def at(self, offset: int, length: int) -> bytes:
        """Bytes from ``offset`` on; fewer where the file ends."""
        self._file.seek(offset)
        return self._file.read(length)

    def record(self, offset: int) -> tuple[int, int]:
        """Opcode and content length of the record at ``offset``; (0, 0) past the last whole one."""
        head = self.at(offset, _HEAD.size)
        if len(head) < _HEAD.size:
            return 0, 0
        opcode, length = _HEAD.unpack(head)
        return (opcode, length) if offset + _HEAD.size + length <= self.size else (0, 0)

    def body(self, offset: int, length: int, limit: int = LIMIT) -> bytes:
        """Content of the record at ``offset``. Raises FileError if it is longer than ``limit``."""
        if length > limit:
            raise FileError(notice("session.record_size", path=self.path, size_bytes=length))
        return self.at(offset + _HEAD.size, length)

    def damaged(self, offset: int, why: Notice | None = None) -> FileError:
        """Returns the error to raise for the record at ``offset``."""
        if why is None:
            return FileError(notice("session.damaged_at", path=self.path, offset=offset))
        return FileError(notice("session.damaged_why", path=self.path, offset=offset, why=why))

    @contextmanager
    def explained(self, offset: int) -> Iterator[None]:
        """Converts errors with the record at ``offset`` to a FileError."""
        try:
            yield
        except BAD_RECORD as error:
            raise self.damaged(offset) from error


def _open(path: Path) -> IO[bytes]:
    try:
        check_regular(path)
        return path.open("rb")
    except FileNotFoundError as error:
        raise FileError(notice("file.missing", path=path)) from error
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
