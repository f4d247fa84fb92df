"""Images in transit to the recorder's process: slots in shared memory, one image pair each.

The first byte of each slot's mark is 1 while the pair is in transit; the sender sets it, the
encoder clears it. One thread writes; any thread of the other process clears.
"""

from __future__ import annotations

from multiprocessing.shared_memory import SharedMemory
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.shared_memory import NoSharedMemory, RoomFor, attached, forget_name, sparse_memory
from tracker.messages import CameraPose, StereoFrame

MOST_BYTES = 134_000_000
"""For all places together: 24 pairs at 1280×720, 0.4 s at 60 a second."""
MOST_SLOTS, FEWEST_SLOTS = 24, 2

Image = NDArray[np.uint8]
Shape = tuple[int, ...]


class SlotsOpened(NamedTuple):
    """New memory of the following images."""

    number: int
    name: str
    slots: int
    slot_bytes: int


class ImageInSlot(NamedTuple):
    """A `StereoFrame` whose images are in shared memory: ``shapes`` of left and right."""

    memory: int  # number of the SlotsOpened
    slot: int
    t: float
    t_arrival: float
    shapes: tuple[Shape | None, Shape | None]
    pose: CameraPose | None
    exposure: int  # index of the StereoFrame


class ImageSlots:
    """The sending side; ``opened`` is called with new memory, to be sent to the receiving side.

    The lowest free slot is used, so memory is used only as far as images accumulate. Raises
    NoSharedMemory if there is no room for the first.
    """

    def __init__(self, number: int, slot_bytes: int) -> None:
        slots = min(MOST_SLOTS, max(FEWEST_SLOTS, MOST_BYTES // max(slot_bytes, 1)))
        self._memory = sparse_memory(slots * (slot_bytes + 1))
        self._room, self._ready = RoomFor(self._memory), 0  # slots with reserved memory
        self.opened = SlotsOpened(number, self._memory.name, slots, slot_bytes)
        try:
            self._room.reserve(0, slots)
            self._make_ready()
        except NoSharedMemory:
            self.close()
            raise

    def _make_ready(self) -> None:
        at = self.opened.slots + self._ready * self.opened.slot_bytes
        self._room.reserve(at, self.opened.slot_bytes)
        self._ready += 1

    def put(self, frame: StereoFrame) -> ImageInSlot | None:
        """Copies the images into a free slot; returns None without one."""
        slot = self._free_slot()
        if slot is None:
            return None
        memory, at = _bytes(self._memory), self.opened.slots + slot * self.opened.slot_bytes
        shapes: list[Shape | None] = []
        for image in (frame.left, frame.right):
            shapes.append(None if image is None else image.shape)
            if image is not None:
                np.copyto(np.ndarray(image.shape, np.uint8, memory, at), image)
                at += image.nbytes
        memory[slot] = 1
        left, right = shapes
        return ImageInSlot(
            self.opened.number,
            slot,
            frame.t,
            frame.t_arrival,
            (left, right),
            frame.pose,
            frame.index,
        )

    def _free_slot(self) -> int | None:
        marks = _bytes(self._memory)
        slot = next((i for i in range(self.opened.slots) if not marks[i]), None)
        if slot == self._ready:
            try:
                self._make_ready()
            except NoSharedMemory:
                return None  # used slots become free again
        return slot

    def close(self) -> None:
        """Free the memory once the other side has freed it, too."""
        forget_name(self._memory)  # if the other side has not attached to it
        self._room.close()
        self._memory.close()


class SlotReader:
    """The receiving side."""

    def __init__(self, opened: SlotsOpened) -> None:
        self._opened, self._memory = opened, attached(opened.name)

    def images(self, image: ImageInSlot) -> dict[str, Image]:
        """(h, w, 3) BGR by camera, still in shared memory: valid until `free`."""
        at = self._opened.slots + image.slot * self._opened.slot_bytes
        out = {}
        for camera, shape in zip(("left", "right"), image.shapes, strict=True):
            if shape is not None:
                out[camera] = np.ndarray(shape, np.uint8, _bytes(self._memory), at)
                at += out[camera].nbytes
        return out

    def free(self, image: ImageInSlot) -> None:
        """Frees a slot."""
        _bytes(self._memory)[image.slot] = 0

    def close(self) -> None:
        self._memory.close()


def _bytes(memory: SharedMemory) -> memoryview:
    if memory.buf is None:
        raise ValueError("the shared memory is closed")
    return memory.buf


def bytes_of(frame: StereoFrame) -> int:
    """Returns the bytes that both images need."""
    return sum(i.nbytes for i in (frame.left, frame.right) if i is not None)
