"""A small file that was removed and can be restored."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice


@dataclass(frozen=True)
class RemovedFile:
    """``data``: what the file contained."""

    path: Path
    data: bytes

    def put_back(self) -> None:
        """Write it again. Raises FileError, also if the file exists again."""
        if self.path.exists():
            raise FileError(notice("window.exists_again", file=self.path.name))
        write_with_folder(self.path, self.data)


def remove_file(path: Path) -> RemovedFile:
    """Remove a file, reading it into memory. Raises FileError if it is too large."""
    try:
        data = path.read_bytes()
        path.unlink()
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(notice("window.not_removed", name=path.stem, why=reason)) from error
    return RemovedFile(path, data)
