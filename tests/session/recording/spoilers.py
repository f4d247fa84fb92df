"""Preparations of a recorder's process: disks that are small, slow or defective."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass

from tracker.session.mcap import disk
from tracker.session.recording import child


@dataclass(frozen=True)
class SmallFiles:
    """Limits the size of files to ``limit`` bytes, as ``ulimit -f``."""

    limit: int

    def __call__(self) -> None:
        import resource

        # Python 3.11 would write half of a compiled module there (CPython issue 126606).
        sys.dont_write_bytecode = True
        resource.setrlimit(resource.RLIMIT_FSIZE, (self.limit, self.limit))


@dataclass(frozen=True)
class FullDisk:
    """``room`` bytes can be written, including part of the last write, as on a full disk."""

    room: int

    def __call__(self) -> None:
        write, left = os.write, [self.room]

        def limited(handle: int, data: bytes) -> int:
            if left[0] < len(data):
                write(handle, bytes(data)[: left[0]])
                raise OSError(28, "No space left on device")
            left[0] -= len(data)
            return write(handle, data)

        disk.os.write = limited  # type: ignore[assignment]


@dataclass(frozen=True)
class SlowDisk:
    """Synchronising to the disk takes ``s``; writing to the system's memory does not."""

    s: float

    def __call__(self) -> None:
        sync = os.fsync
        disk.os.fsync = lambda handle: (time.sleep(self.s), sync(handle))[1]


@dataclass(frozen=True)
class BrokenSync:
    """The disk fails when synchronised, from the ``after``-th time on."""

    after: int

    def __call__(self) -> None:
        count = [0]

        def fails(handle: int) -> None:
            count[0] += 1
            if count[0] > self.after:
                raise OSError(5, "Input/output error")

        disk.os.fsync = fails


@dataclass(frozen=True)
class SlowEncoder:
    """Each image takes ``s`` to compress."""

    s: float

    def __call__(self) -> None:
        encode: Callable[..., bytes] = child.encode_image

        def slow(*args: object) -> bytes:
            time.sleep(self.s)
            return encode(*args)

        child.encode_image = slow
