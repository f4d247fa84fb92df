"""The shared memory: created by the stream, attached to by the window and the command."""

from __future__ import annotations

import mmap
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

from extensions.openxr.layout import SIZE, VERSION
from tracker.base.notices import notice
from tracker.streaming.connection import StreamError

if sys.platform != "win32":
    import fcntl

ELSEWHERE = "GLOVETRACK_OPENXR_MEMORY"
"""Environment variable with another path (on Windows: another name) of the memory."""
FOLDER = Path("/dev/shm")
TRIES = 10
LOCK_TRIES, LOCK_PAUSE = 20, 0.05  # s


def memory_name() -> str:
    """Path of the memory, different for each user and version of the layout; on Windows its name,
    which belongs to the user's session."""
    given = os.environ.get(ELSEWHERE, "")
    if given:
        return given
    if sys.platform == "win32":
        return f"Local\\glovetrack-openxr-{VERSION}"
    return str(FOLDER / f"glovetrack-openxr-{VERSION}-{os.getuid()}")


class OpenXrMemory:
    """The memory of the one program that writes to it, zeros at first.

    ``buffer`` has `SIZE` bytes. `close` removes the name; what has the memory open keeps it.
    Raises StreamError if the system has no such memory or another program uses it.
    """

    def __init__(self, name: str = "") -> None:
        self.name = name or memory_name()
        self._remove: Callable[[], None]
        if sys.platform == "win32":
            self.buffer = mmap.mmap(-1, SIZE, tagname=self.name)
            self._remove = _nothing
        else:
            handle = _locked(Path(self.name))
            self.buffer = mmap.mmap(handle, SIZE)
            self._remove = lambda: _unlink(Path(self.name), handle)
        self.buffer[:] = bytes(SIZE)

    @property
    def is_closed(self) -> bool:
        return self.buffer.closed

    def close(self) -> None:
        """May be called again. Arrays on ``buffer`` must be gone."""
        if not self.is_closed:
            self.buffer.close()
            self._remove()


def attach(name: str = "") -> mmap.mmap | None:
    """The memory of a program, to read; None if there is none of this user's."""
    name = name or memory_name()
    if sys.platform == "win32":
        return mmap.mmap(-1, SIZE, tagname=name, access=mmap.ACCESS_READ)
    try:
        handle = os.open(name, os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except OSError:
        return None
    try:
        found = os.fstat(handle)
        if found.st_uid != os.getuid() or found.st_size != SIZE:
            return None
        return mmap.mmap(handle, SIZE, access=mmap.ACCESS_READ)
    finally:
        os.close(handle)


def _nothing() -> None:
    """Windows removes a name with its last handle."""


def _locked(path: Path) -> int:
    """Descriptor of the file, created if necessary, locked and with room for all of it.

    A program that was killed leaves the file behind, without a lock: layers still have it open and
    read it again. Raises StreamError.
    """
    for _ in range(TRIES):
        handle = _opened(path)
        if _is_at(path, handle):
            return handle
        os.close(handle)  # removed by its program before we had the lock
    raise StreamError(notice("openxr.memory_removed", path=path))


def _opened(path: Path) -> int:
    if sys.platform == "win32" or not hasattr(os, "posix_fallocate"):
        raise StreamError(notice("openxr.system"))
    handle = -1
    try:
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC, 0o600)
        if os.fstat(handle).st_uid != os.getuid():
            raise StreamError(notice("openxr.other_user", path=path))
        _lock(handle)
        os.ftruncate(handle, SIZE)
        os.posix_fallocate(handle, 0, SIZE)
    except BlockingIOError as error:
        os.close(handle)
        raise StreamError(notice("openxr.occupied")) from error
    except (OSError, StreamError) as error:
        if handle >= 0:
            os.close(handle)
        if isinstance(error, StreamError):
            raise
        raise StreamError(notice("file.not_created", path=path, why=error.strerror)) from error
    return handle


def _lock(handle: int) -> None:
    """Wait a second at most: a stream that is opened again with other options may find the one
    before still open. Raises BlockingIOError."""
    for k in range(LOCK_TRIES):
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return
        except BlockingIOError:
            if k == LOCK_TRIES - 1:
                raise
            time.sleep(LOCK_PAUSE)


def _is_at(path: Path, handle: int) -> bool:
    """Whether an open file still has its name."""
    try:
        return os.path.samestat(path.stat(follow_symlinks=False), os.fstat(handle))
    except FileNotFoundError:
        return False


def _unlink(path: Path, handle: int) -> None:
    """Remove the name while we have the lock, and give that up."""
    path.unlink(missing_ok=True)
    os.close(handle)
