"""The file of a recording: only whole records, on a disk that may fill up or be disconnected."""

from __future__ import annotations

import contextlib
import os
from datetime import UTC, datetime
from pathlib import Path

from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.files import disk_error, free_path, name_part
from tracker.base.notices import notice


class WholeRecordFile:
    """A new file in which every ``write`` is complete or absent.

    Bytes are passed to the operating system immediately, so that a killed process loses none.
    Raises FileError if the file exists already or cannot be written.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._size = 0
        try:
            self._fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o644)
        except FileExistsError as error:
            raise FileError(notice("recording.exists", path=path)) from error
        except OSError as error:
            raise disk_error(path, error) from error

    def write(self, data: bytes) -> int:
        view = memoryview(data)
        try:
            while view:
                view = view[os.write(self._fd, view) :]
        except OSError as error:
            self._remove_partial()
            raise disk_error(self._path, error) from error
        self._size += len(data)
        return len(data)

    def _remove_partial(self) -> None:
        """Removes the rest of a failed write, unless the disk is disconnected."""
        with contextlib.suppress(OSError):
            os.ftruncate(self._fd, self._size)
            os.lseek(self._fd, self._size, os.SEEK_SET)

    def tell(self) -> int:
        return self._size

    def flush(self) -> None:
        """Does nothing: writes are not buffered."""

    def sync(self) -> None:
        """Synchronises the file with the disk, against loss of power."""
        try:
            os.fsync(self._fd)
        except OSError as error:
            raise disk_error(self._path, error) from error

    def close(self) -> None:
        if self._fd >= 0:
            fd, self._fd = self._fd, -1
            try:
                os.close(fd)
            except OSError as error:
                raise disk_error(self._path, error) from error


def automatic_path(folder: Path, wall_ns: int, label: str = "") -> Path:
    """A path that no file in ``folder`` has: ``2026-11-21_05-17-03[_label].mcap`` (UTC)."""
    stem = datetime.fromtimestamp(wall_ns // NS, UTC).strftime("%Y-%m-%d_%H-%M-%S")
    part = name_part(label)[:40]
    return free_path(folder / (f"{stem}_{part}.mcap" if part else f"{stem}.mcap"))
