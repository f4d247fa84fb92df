"""Crash logs, reported at the next start.

While the program runs there is ``running-PID.log``, into which Python's fault handler writes the
traceback of a hard crash, and this module each unhandled exception. A regular end removes the file
(or renames it to ``crash-….log`` if it is not empty); the file of a process that no longer exists
indicates a crash.
"""

from __future__ import annotations

import faulthandler
import logging
import os
import sys
import threading
import time
import traceback
from logging.handlers import RotatingFileHandler
from pathlib import Path
from types import TracebackType
from typing import TextIO

import platformdirs
import psutil
from PySide6.QtCore import QObject, Signal

from app.words import tr
from tracker import __version__
from tracker.base.logs import FORMAT

_log = logging.getLogger(__name__)
LOG_BYTES, LOG_FILES = 1_000_000, 3
CRASH_LOGS = 10
MOST_DIFFERENT = 100  # unhandled exceptions logged per run


def log_folder() -> Path:
    """Folder of the program's logs."""
    return Path(platformdirs.user_log_dir("glovetrack", appauthor=False))


def log_to_file(folder: Path) -> None:
    """Let Python's loggers write to ``glovetrack.log``, three files of 1 MB at most.

    `tracker.base.logs` sets the level.
    """
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    handler = RotatingFileHandler(
        folder / "glovetrack.log", maxBytes=LOG_BYTES, backupCount=LOG_FILES - 1, encoding="utf-8"
    )
    handler.setFormatter(logging.Formatter(FORMAT))
    logging.getLogger().addHandler(handler)


class CrashWatch(QObject):
    """Starts watching when created. ``found``: the log of a run that crashed, or None."""

    happened = Signal(str)  # a message about an unhandled exception

    def __init__(self, folder: Path) -> None:
        super().__init__()
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        self.folder = folder
        self.found = self._rename_old_logs()
        self._path = folder / f"running-{os.getpid()}.log"
        self._file: TextIO = self._path.open("w", encoding="utf-8")
        self._file.write(_heading())
        self._file.flush()
        self._start_size = self._path.stat().st_size
        self._seen: set[str] = set()
        self._hooks = sys.excepthook, threading.excepthook
        faulthandler.enable(self._file)
        sys.excepthook = self._caught
        threading.excepthook = lambda e: self._caught(
            e.exc_type, e.exc_value or e.exc_type(), e.exc_traceback
        )

    def _rename_old_logs(self) -> Path | None:
        """Rename logs of runs that have ended; returns the newest."""
        ended = [p for p in self.folder.glob("running-*.log") if not _is_running(p)]
        found = [_keep(p) for p in sorted(ended, key=lambda p: p.stat().st_mtime)]
        for old in sorted(self.folder.glob("crash-*.log"))[:-CRASH_LOGS]:
            old.unlink(missing_ok=True)
        return found[-1] if found else None

    def _caught(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        """Log an unhandled exception, show a message, and continue."""
        if issubclass(kind, KeyboardInterrupt):
            self._hooks[0](kind, error, trace)
            return
        text = "".join(traceback.format_exception(kind, error, trace))
        if text in self._seen or len(self._seen) >= MOST_DIFFERENT:
            return  # a failing timer fails sixty times a second
        self._seen.add(text)
        _log.error("Unhandled exception:\n%s", text)
        sys.stderr.write(text)
        self._file.write(f"{time.strftime('%Y-%m-%d %H:%M:%S')}\n{text}")
        self._file.flush()
        self.happened.emit(
            tr("Something went wrong inside Glovetrack ({}: {}).").format(kind.__name__, error)
        )

    def end(self) -> None:
        """The program ends regularly."""
        if self._file.closed:
            return
        sys.excepthook, threading.excepthook = self._hooks
        faulthandler.disable()
        self._file.close()
        if self._path.stat().st_size > self._start_size:
            _keep(self._path)
        else:
            self._path.unlink()


def _heading() -> str:
    created = psutil.Process().create_time()
    return f"{created}\nGlovetrack {__version__}, Python {sys.version.split()[0]}, {sys.platform}\n"


def _is_running(path: Path) -> bool:
    """Whether the process that wrote the file is still running; process ids are reused."""
    try:
        created = float(path.read_text("utf-8", "replace").partition("\n")[0])
        return abs(psutil.Process(int(path.stem.rpartition("-")[2])).create_time() - created) < 1.0
    except (ValueError, OSError, psutil.Error):
        return False


def _keep(path: Path) -> Path:
    """Rename the log to ``crash-….log`` with the time of its last change."""
    when = time.strftime("%Y-%m-%d_%H-%M-%S", time.localtime(path.stat().st_mtime))
    kept = path.with_name(f"crash-{when}-{path.stem.rpartition('-')[2]}.log")
    return path.replace(kept)
