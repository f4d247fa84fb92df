"""A small file that was removed and can be restored."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from app.words import tr
from tracker.base.errors import FileError
from tracker.base.files import write_with_folder


@dataclass(frozen=True)
class RemovedFile:
    """``data``: what the file contained."""

    path: Path
    data: bytes

    def put_back(self) -> None:
        """Write it again. Raises FileError, also if the file exists again."""
        if self.path.exists():
            raise FileError(
                tr("{} exists again; it is not replaced by the removed one.").format(self.path.name)
            )
        write_with_folder(self.path, self.data)


def remove_file(path: Path) -> RemovedFile:
    """Remove a file, reading it into memory. Raises FileError if it is too large."""
    try:
        data = path.read_bytes()
        path.unlink()
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(tr("{} was not removed: {}.").format(path.stem, reason)) from error
    return RemovedFile(path, data)
