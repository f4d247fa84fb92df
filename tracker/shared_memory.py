"""Memory that two processes share, with room behind it for certain.

Where the system gives less than is asked for, a plain `SharedMemory` ends the process that
writes to it, so the room is taken at once. `attached` memory has no name any more: whoever of
the two is killed, nothing of it is left behind.
"""

from __future__ import annotations

import os
from contextlib import suppress
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path

from tracker.errors import GlovetrackError

_FOLDER = Path("/dev/shm")  # where Linux keeps it


class NoSharedMemory(GlovetrackError):
    """The system has no room left for it."""


def new_memory(size: int) -> SharedMemory:
    """``size`` bytes (at least; zero at first) under a new name. Raises NoSharedMemory."""
    try:
        memory = SharedMemory(create=True, size=size)
    except OSError as error:
        raise _no_room(size) from error
    try:
        _take_room(memory, size)
    except OSError as error:
        memory.close()
        forget_name(memory)
        raise _no_room(size) from error
    return memory


def attached(name: str) -> SharedMemory:
    """The memory that another process made and named; its name is gone then."""
    memory = SharedMemory(name=name)
    forget_name(memory)
    return memory


def forget_name(memory: SharedMemory) -> None:
    """Nobody attaches to it any more; it lasts as long as someone has it open."""
    with suppress(FileNotFoundError):  # the other one was first
        memory.unlink()


def _take_room(memory: SharedMemory, size: int) -> None:
    """macOS and Windows count it when it is made."""
    place = _FOLDER / memory.name
    if hasattr(os, "posix_fallocate") and place.exists():
        handle = os.open(place, os.O_RDWR)
        try:
            os.posix_fallocate(handle, 0, size)
        finally:
            os.close(handle)


def _no_room(size: int) -> NoSharedMemory:
    return NoSharedMemory(
        f"The system has no {size / 1e6:.0f} MB of shared memory left, in which images are handed "
        f"from one process to the other."
    )
