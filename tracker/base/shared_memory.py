"""Memory that two processes share, with room behind it for certain.

Where the system gives less than is asked for, a plain `SharedMemory` ends the process that
writes to it, so room is taken before. `attached` memory has no name any more: whoever of the two
is killed, nothing of it is left behind.
"""

from __future__ import annotations

import os
from contextlib import suppress
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice

_FOLDER = Path("/dev/shm")  # where Linux keeps it


class NoSharedMemory(GlovetrackError):
    """The system has no room left for it."""


class RoomFor:
    """Takes room for parts of a memory; made while that has its name, and usable afterwards.

    macOS and Windows count the whole when it is made: there it does nothing.
    """

    def __init__(self, memory: SharedMemory) -> None:
        path = _FOLDER / memory.name
        counts = hasattr(os, "posix_fallocate") and path.exists()
        self._handle = os.open(path, os.O_RDWR) if counts else -1

    def reserve(self, start: int, size: int) -> None:
        """``size`` bytes from ``start`` on may be written to. Raises NoSharedMemory."""
        if self._handle < 0:
            return
        try:
            os.posix_fallocate(self._handle, start, size)
        except OSError as error:
            raise _no_room(size) from error

    def close(self) -> None:
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1


def new_memory(size: int) -> SharedMemory:
    """``size`` bytes (at least; zero at first) with room for all. Raises NoSharedMemory."""
    memory = sparse_memory(size)
    room = RoomFor(memory)
    try:
        room.reserve(0, size)
    except NoSharedMemory:
        forget_name(memory)
        memory.close()
        raise
    finally:
        room.close()
    return memory


def sparse_memory(size: int) -> SharedMemory:
    """``size`` bytes, to be written to where a `RoomFor` has taken room. Raises NoSharedMemory."""
    try:
        return SharedMemory(create=True, size=size)
    except OSError as error:
        raise _no_room(size) from error


def attached(name: str) -> SharedMemory:
    """Opens the memory that another process created, and removes its name."""
    memory = SharedMemory(name=name)
    forget_name(memory)
    return memory


def forget_name(memory: SharedMemory) -> None:
    """Remove its name; it exists as long as a process has it open."""
    with suppress(FileNotFoundError):  # the other one was first
        memory.unlink()


def _no_room(size: int) -> NoSharedMemory:
    return NoSharedMemory(notice("system.shared_memory_full", needed_mb=size / 1000000.0))
