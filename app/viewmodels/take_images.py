"""The camera images of a recorded take, one at a time."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import FileError
from tracker.messages import StereoFrame
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader

LATEST = 0.3  # s before an instant within which an image still shows it
Image = NDArray[np.uint8]


class TakeImages:
    """Of one file, which is opened when it is first asked. For one thread at a time."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._reader: SessionReader | None = None

    def at(self, position: float) -> Image | None:
        """(h, w, 3) BGR of the left camera, or of the right one alone, where the take stands
        ``position`` s after its first measurement; None where it has none or it is damaged."""
        if self._reader is None:
            self._reader = SessionReader(self._path)
        reader = self._reader
        t = reader.anchor.monotonic(reader.span_ns[0]) + position
        try:
            found = [
                m
                for m in reader.packed_messages((StereoFrame,), t - LATEST, t + 1e-3)
                if isinstance(m, PackedFrame)
            ]
            frame = found[-1].unpack() if found else None
        except FileError:
            return None  # what is damaged is told by the replay
        if frame is None:
            return None
        return frame.left if frame.left is not None else frame.right

    def close(self) -> None:
        """Let go of the file."""
        if self._reader is not None:
            self._reader.close()
            self._reader = None
