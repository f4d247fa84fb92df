"""A small file of the user's that was removed and can be put back."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from app.words import tr
from tracker.base.errors import FileError
from tracker.base.files import write_kept


@dataclass(frozen=True)
class RemovedFile:
    """``data``: what the file contained."""

    path: Path
    data: bytes

    def put_back(self) -> None:
        """Write it again. Raises FileError, also where there is another one of its name by now."""
        if self.path.exists():
            raise FileError(
                tr("{} exists again; it is not replaced by the removed one.").format(self.path.name)
            )
        write_kept(self.path, self.data)


def remove_file(path: Path) -> RemovedFile:
    """Remove a file that is small enough for memory. Raises FileError."""
    try:
        data = path.read_bytes()
        path.unlink()
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(tr("{} was not removed: {}.").format(path.stem, reason)) from error
    return RemovedFile(path, data)
