"""A recorder whose writing happens in another process: here, messages are only handed over."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Protocol

from tracker.base.errors import GlovetrackError
from tracker.messages import EngineState, Message, StereoFrame
from tracker.session import engine_state
from tracker.session.recording.image_slots import ImageSlots, bytes_of
from tracker.session.recording.wire import Item, OfHand, PackedState


class Process(Protocol):
    """What `RemoteRecorder` wants of a recorder's process."""

    @property
    def path(self) -> Path: ...

    @property
    def pid(self) -> int: ...

    @property
    def alive(self) -> bool: ...

    def send(self, items: list[Item]) -> None: ...

    def check(self) -> None: ...

    def end(self) -> None: ...


MOST_TOGETHER = 256  # messages in a batch


class RemoteRecorder:
    """As `tracker.session.writer.SessionRecorder`, in another process; for one thread.

    Messages go there in batches, with `flush`. Raises FileError, from any method, when writing has
    failed there or the process is gone; NoSharedMemory from `write` where images have no room.
    """

    def __init__(self, process: Process, images: bool, release: Callable[[], None]) -> None:
        self._process, self._wants_images, self._release = process, images, release
        self.path = process.path
        self._batch: list[Item] = []
        self._slots: list[ImageSlots] = []
        self._failed = self._closed = False

    @property
    def pid(self) -> int:
        """Of the process that writes."""
        return self._process.pid

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        """Take one message; False where it is an image that there is no room for."""
        item: Item | None = OfHand(side, message) if side else message
        if isinstance(message, StereoFrame):
            item = None if overloaded else self._image(message)
        elif isinstance(message, EngineState):
            item = PackedState(message.t, engine_state.pack(message.engine, message.state))
        if item is None:
            return False
        self._batch.append(item)
        if len(self._batch) >= MOST_TOGETHER:
            self.flush()
        return True

    def _image(self, frame: StereoFrame) -> Item | None:
        size = bytes_of(frame) if self._wants_images else 0
        if size == 0:
            return replace(frame, left=None, right=None)  # where the camera was is kept
        if not self._slots or self._slots[-1].opened.slot_bytes < size:
            self._slots.append(ImageSlots(len(self._slots), size))
            self._batch.append(self._slots[-1].opened)
        return self._slots[-1].put(frame)

    def flush(self) -> None:
        """Hand over what was taken: from then on it does not depend on this process."""
        batch, self._batch = self._batch, []
        try:
            if batch:
                self._process.send(batch)
            else:
                self._process.check()
        except GlovetrackError:
            self._failed = True
            raise

    def close(self) -> None:
        """Finish the file; waits for it. Calling it again does nothing."""
        if self._closed:
            return
        self._closed = True
        try:
            self._end()
        finally:
            for slots in self._slots:
                slots.close()
            self._release()

    def _end(self) -> None:
        try:
            if not self._failed:
                self.flush()
        finally:
            if self._process.alive:
                self._process.end()
