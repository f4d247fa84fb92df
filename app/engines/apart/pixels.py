"""The pixels of the image that is shown, in memory that the window and the process share."""

from __future__ import annotations

from dataclasses import replace
from math import prod
from multiprocessing.shared_memory import SharedMemory

import numpy as np
from numpy.typing import NDArray

from app.engines.apart.messages import Pixels
from tracker.base.shared_memory import attached, forget_name, new_memory
from tracker.messages import StereoFrame

Image = NDArray[np.uint8]


class PixelWriter:
    """In the process that tracks: one image at a time, until the window has copied it."""

    def __init__(self) -> None:
        self._memory: SharedMemory | None = None

    def put(self, frame: StereoFrame) -> tuple[Pixels, str]:
        """Write the pixels of ``frame``; returns the rest, and the name of the memory if it is new.

        Raises NoSharedMemory.
        """
        left, right = frame.left, frame.right
        images = [image for image in (left, right) if image is not None]
        new = self._make_room(sum(image.size for image in images))
        start = 0
        for image in images:
            self._at(start, image.size)[:] = image.ravel()
            start += image.size
        shapes = (
            left.shape if left is not None else (),
            right.shape if right is not None else (),
        )
        return Pixels(replace(frame, left=None, right=None), shapes), new

    def _at(self, start: int, size: int) -> Image:
        assert self._memory is not None
        assert self._memory.buf is not None
        return np.frombuffer(self._memory.buf, np.uint8, size, start)

    def _make_room(self, size: int) -> str:
        if self._memory is not None and self._memory.size >= size:
            return ""
        self.close()
        self._memory = new_memory(max(size, 1))
        return self._memory.name

    def close(self) -> None:
        """Free the memory; the window's part of it remains until that is closed, too."""
        if self._memory is not None:
            forget_name(self._memory)
            self._memory.close()
            self._memory = None


class PixelReader:
    """In the window's process."""

    def __init__(self) -> None:
        self._memory: SharedMemory | None = None

    def open(self, name: str) -> None:
        """Use the memory ``name`` from now on."""
        self.close()
        self._memory = attached(name)

    def take(self, pixels: Pixels) -> StereoFrame:
        """Returns a copy of the image."""
        left, right = pixels.shapes
        return replace(
            pixels.frame, left=self._copy(0, left), right=self._copy(prod(left or (0,)), right)
        )

    def _copy(self, start: int, shape: tuple[int, ...]) -> Image | None:
        if not shape or self._memory is None or self._memory.buf is None:
            return None
        image = np.empty(shape, np.uint8)
        image.ravel()[:] = np.frombuffer(self._memory.buf, np.uint8, image.size, start)
        return image

    def close(self) -> None:
        """Release the memory."""
        if self._memory is not None:
            self._memory.close()
            self._memory = None
