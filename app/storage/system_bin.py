"""Move sessions to the system's bin and back."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QFile

from app.storage.session_tags import tags_path
from tracker.base.errors import FileError
from tracker.base.files import disk_error
from tracker.base.notices import notice


@dataclass(frozen=True)
class Binned:
    """A session in the bin.

    ``moved``: pairs of the original path of each file and its path in the bin. If the system does
    not report the latter, it is None; the session can then be restored only with the file manager.
    """

    path: Path
    moved: tuple[tuple[Path, Path | None], ...]

    @property
    def can_be_restored(self) -> bool:
        return all(there is not None for _, there in self.moved)


def to_bin(path: Path) -> Binned:
    """Move a session and its tags to the bin. Raises FileError if there is no bin."""
    done, there = move_to_bin(path)
    if not done:
        raise FileError(notice("window.no_trash", file=path.name))
    moved = [(path, there)]
    if (tags := tags_path(path)).exists():
        moved.append((tags, move_to_bin(tags)[1]))
    return Binned(path, tuple(moved))


def move_to_bin(path: Path) -> tuple[bool, Path | None]:
    """Whether the file was moved, and its new path if the system reports it."""
    file = QFile(str(path))
    done = file.moveToTrash()
    there = Path(file.fileName()) if done and file.fileName() else None
    return done, there if there != path else None


def restore(binned: Sequence[Binned]) -> None:
    """Move sessions back to their original paths. Raises FileError; sessions restored by then
    stay."""
    for session in binned:
        if session.path.exists():
            raise FileError(notice("window.not_restored", file=session.path.name))
        for path, there in session.moved:
            if there is not None:
                _move_back(there, path)


def _move_back(there: Path, path: Path) -> None:
    try:
        shutil.move(there, path)
        # freedesktop.org's Trash specification 1.0: a description of each file is stored next to
        # them
        (there.parent.parent / "info" / f"{there.name}.trashinfo").unlink(missing_ok=True)
    except OSError as error:
        raise disk_error(path, error) from error
