"""Commands on session files: rename, tag, recover, crop, delete, show the folder."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Protocol, TypeVar

from PySide6.QtCore import QObject, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QWidget

from app.engines.host_parts import CurrentEngine, ErrorSignal, RecordingPart
from app.jobs.derived_sessions import crop_job, recover_job
from app.platform.tasks import TaskOwner
from app.storage.session_tags import read_tags, tags_of_text, write_tags
from app.storage.system_bin import Binned, restore, to_bin
from app.viewmodels.recording import duration_text
from app.viewmodels.recording_report import rename
from app.widgets.question import question
from app.words import error_text
from tracker.base.errors import FileError, GlovetrackError
from tracker.base.notices import notice

T = TypeVar("T")


class FilesHost(CurrentEngine, ErrorSignal, RecordingPart, Protocol):
    """What the files use of the engine host."""


class SessionFiles(QObject):
    """Runs the commands; ``changed``: the contents of the folder have changed."""

    changed = Signal()
    renamed = Signal(object, object)  # the old Path and the new one
    binned = Signal(object)  # the `Binned` sessions
    restored = Signal(object)  # the Paths of restored files
    made = Signal(object, str)  # the Path of a new session, and a message
    removed = Signal(str, object)  # a message about tags, and a function that undoes the change

    def __init__(self, host: FilesHost, tasks: TaskOwner, parent: QWidget) -> None:
        super().__init__(parent)
        self._host, self._tasks, self._window = host, tasks, parent

    def ask_name(self, path: Path) -> None:
        title = self.tr("Rename {}").format(path.name)
        dialog = question(self._window, title, self.tr("Name"), path.stem)
        dialog.textValueSelected.connect(lambda name: self.rename(path, name))
        dialog.open()

    def ask_tags(self, paths: Sequence[Path]) -> None:
        """Ask for tags, starting with those of the first session, and set them for all."""
        words = self.tr("Tags, separated by commas")
        title = self.tr("Tags of {}").format(paths[0].name)
        if len(paths) > 1:
            title = self.tr("Tags of {} sessions").format(len(paths))
        dialog = question(self._window, title, words, ", ".join(read_tags(paths[0])))
        dialog.textValueSelected.connect(lambda text: self.tag(paths, text))
        dialog.open()

    def rename(self, path: Path, name: str) -> Path | None:
        """Rename a session in its folder and keep it selected. Returns None after reporting why
        that is not possible."""

        def work() -> Path:
            new = rename(self._free(path), name)
            self.renamed.emit(path, new)
            return new

        return self._try(work)

    def tag(self, paths: Sequence[Path], text: str) -> None:
        """Replace the tags of all these sessions."""

        before = {path: read_tags(path) for path in paths}
        wanted = tags_of_text(text)
        self._put_tags(dict.fromkeys(paths, wanted))
        dropped = sorted({tag for tags in before.values() for tag in tags} - set(wanted))
        if dropped:
            message = self.tr("Tags removed: {}.").format(", ".join(dropped))
            self.removed.emit(message, partial(self._put_tags, before))

    def _put_tags(self, tags: Mapping[Path, Sequence[str]]) -> None:
        """Restore the tags of each session that still exists under its name."""

        def write() -> None:
            for path, words in tags.items():
                if path.exists():
                    write_tags(path, words)

        self._try(write)

    def bin(self, paths: Sequence[Path]) -> None:
        """Move sessions to the system's bin without asking; `restore` undoes it."""
        moved: list[Binned] = []

        def move() -> None:
            for path in paths:
                moved.append(to_bin(self._free(path)))

        self._try(move)
        if moved:
            self.binned.emit(tuple(moved))

    def restore(self, binned: Sequence[Binned]) -> None:
        """Restore sessions from the bin and select them."""

        def move() -> bool:
            restore(binned)
            return True

        if self._try(move):
            self.restored.emit([session.path for session in binned])

    def recover(self, path: Path) -> None:
        """Create a complete file from an interrupted recording; the original is not changed."""
        title = self.tr("Recovering {}").format(path.stem)
        self._tasks.run(title, recover_job(path), ended=self.changed.emit)

    def crop(self, path: Path, part: tuple[float, float]) -> None:
        """Create a session of a range (s of the replay), in the background."""

        def done(out: Path) -> None:
            length = duration_text(part[1] - part[0])
            text = self.tr("{} contains the selected {} of {}.").format(out.name, length, path.name)
            self.made.emit(out, text)

        title = self.tr("Cropping {}").format(path.name)
        self._tasks.run(title, crop_job(path, part), done, self.changed.emit)

    def _free(self, path: Path) -> Path:
        """Raises FileError if a session is open or being recorded."""
        setup, request = self._host.setup, self._host.recording.request
        if request is not None and request.path == path:
            raise FileError(notice("window.being_recorded", file=path.name))
        if setup is not None and setup.player is not None and setup.player.path == path:
            raise FileError(notice("window.is_open", file=path.name))
        return path

    def _try(self, work: Callable[[], T]) -> T | None:
        made = None
        try:
            made = work()
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
        self.changed.emit()
        return made


def open_folder(folder: Path) -> None:
    """Open a folder in the file manager, or a page in the browser."""
    QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder)))
