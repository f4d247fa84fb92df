"""The recorder's process: waits for recordings to begin, and writes one after the other.

It ends when the pipe is closed, also because the window was killed: messages received until then
are written, and the file is finished.
"""

from __future__ import annotations

import queue
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from enum import Enum, auto
from functools import partial
from multiprocessing.connection import Connection
from typing import Any

from tracker.base.errors import FileError, GlovetrackError, notice_of
from tracker.session.images import PackedFrame, encode_image
from tracker.session.recording.image_slots import Image, ImageInSlot, SlotReader, SlotsOpened
from tracker.session.recording.wire import (
    Begin,
    Begun,
    End,
    Ended,
    Item,
    OfHand,
    PackedState,
    RecordingFailed,
    Sink,
)
from tracker.session.ros.sensors import ImageMessage
from tracker.session.writer import SessionRecorder, load_describer

THREADS = 2


class ImageCompression:
    """``done`` is called, in one of the threads, whenever a pair is ready to be taken."""

    def __init__(self, kind: str, quality: int, done: Callable[[], None]) -> None:
        self._kind, self._quality, self._done = kind, quality, done
        self._pool = ThreadPoolExecutor(THREADS, "glovetrack-images")
        self._waiting: deque[Future[PackedFrame]] = deque()

    def put(self, reader: SlotReader, image: ImageInSlot) -> None:
        """Starts compressing a pair; its slot is free again afterwards."""
        future = self._pool.submit(self._compressed, reader, image)
        self._waiting.append(future)
        future.add_done_callback(lambda _: self._done())

    def _compressed(self, reader: SlotReader, image: ImageInSlot) -> PackedFrame:
        try:
            parts = {
                camera: ImageMessage(0, "", self._kind, self._encoded(pixels))
                for camera, pixels in reader.images(image).items()
            }
        finally:
            reader.free(image)
        return PackedFrame(image.t, image.t_arrival, parts, image.pose, image.exposure)

    def _encoded(self, image: Image) -> bytes:
        return encode_image(image, self._kind, self._quality)

    def finished(self) -> Iterator[PackedFrame]:
        """Yields the pairs that are ready, in their original order."""
        while self._waiting and self._waiting[0].done():
            yield self._waiting.popleft().result()

    def finish_all(self) -> Iterator[PackedFrame]:
        """Waits for all pairs and yields them in their original order."""
        while self._waiting:
            yield self._waiting.popleft().result()

    def close(self) -> None:
        """Discard pairs whose compression has not begun."""
        self._pool.shutdown(cancel_futures=True)


MOST_WAITING = 2000
"""Batches, more than a minute of them; a slower disk blocks the window's side."""


class _Signal(Enum):
    ENDS = auto()  # the window's process has ended, or has requested the end
    IMAGE = auto()  # an image pair is compressed


class _Inbox:
    """Messages from the pipe, read immediately: the pipe is small, and the window may be killed."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe = pipe
        self._items: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self._room = threading.Semaphore(MOST_WAITING)
        threading.Thread(target=self._read, name="glovetrack-pipe", daemon=True).start()

    def _read(self) -> None:
        try:
            while True:
                self._items.put(self._pipe.recv())
                self._room.acquire()
        except (EOFError, OSError):
            self._items.put(_Signal.ENDS)

    def get(self) -> Any:
        """Returns the next item; waits for it."""
        item = self._items.get()
        if not isinstance(item, _Signal):
            self._room.release()
        return item

    def post(self, what: _Signal) -> None:
        """Adds an item; may be called from any thread or signal handler."""
        self._items.put(what)


def serve(pipe: Connection, prepare: Callable[[], object]) -> None:
    """Run until the pipe closes; ``prepare`` is called first."""
    inbox = _Inbox(pipe)
    for name in ("SIGINT", "SIGHUP"):  # intended for the window, which then ends this process
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: inbox.post(_Signal.ENDS))
    prepare()
    load_describer()
    while (item := inbox.get()) is not _Signal.ENDS:
        if isinstance(item, Begin) and not _recorded(item, pipe, inbox):
            return


def _recorded(begin: Begin, pipe: Connection, inbox: _Inbox) -> bool:
    """Writes one recording; returns False if this process has to end afterwards."""
    try:
        recorder = SessionRecorder(begin.path, begin.info, begin.params)
    except (GlovetrackError, OSError) as error:
        _reply(pipe, RecordingFailed(_as_glovetrack_error(error)))
        return True
    _reply(pipe, Begun(recorder.path))
    recording = _Recording(recorder, begin, pipe, inbox)
    goes_on = recording.run()
    if goes_on:
        _reply(pipe, Ended())
    return goes_on


def _reply(pipe: Connection, what: object) -> None:
    with suppress(OSError):  # the window has ended
        pipe.send(what)


def _as_glovetrack_error(error: Exception) -> GlovetrackError:
    return error if isinstance(error, GlovetrackError) else FileError(notice_of(error))


class _Recording:
    """Writes the messages of the inbox until the end, or until writing fails."""

    def __init__(
        self, recorder: SessionRecorder, begin: Begin, pipe: Connection, inbox: _Inbox
    ) -> None:
        self._recorder, self._pipe, self._inbox = recorder, pipe, inbox
        self._sink: Sink = begin.companion(recorder)
        self._readers: dict[int, SlotReader] = {}
        p = begin.params
        self._images = ImageCompression(p.images, p.jpeg_quality, lambda: inbox.post(_Signal.IMAGE))
        self._failed = False

    def run(self) -> bool:
        """Writes until the end; returns whether the window is still connected."""
        try:
            while True:
                item = self._inbox.get()
                if isinstance(item, End) or item is _Signal.ENDS:
                    self._guarded(self._finish)
                    return isinstance(item, End)
                self._guarded(partial(self._process, item))
        finally:
            self._images.close()
            for reader in self._readers.values():
                reader.close()

    def _guarded(self, work: Callable[[], None]) -> None:
        """Calls ``work`` unless something has failed before; reports failures to the window."""
        if self._failed:
            return
        try:
            work()
        except (GlovetrackError, OSError) as error:
            self._failed = True
            _reply(self._pipe, RecordingFailed(_as_glovetrack_error(error)))

    def _process(self, item: list[Item] | _Signal) -> None:
        if isinstance(item, list):
            for message in item:
                self._write(message)
        for frame in self._images.finished():
            self._recorder.write_packed(frame)

    def _write(self, item: Item) -> None:
        match item:
            case ImageInSlot():
                self._images.put(self._readers[item.memory], item)
            case SlotsOpened():
                self._readers[item.number] = SlotReader(item)
            case PackedState():
                self._recorder.write_state(item.t, item.data)
            case OfHand():
                self._sink.write(item.message, side=item.side)
            case _:
                self._sink.write(item)

    def _finish(self) -> None:
        for frame in self._images.finish_all():
            self._recorder.write_packed(frame)
        self._sink.close()
