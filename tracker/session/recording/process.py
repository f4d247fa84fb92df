"""The window's interface to the recorder's process."""

from __future__ import annotations

import os
import socket
import struct
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Protocol

from tracker.base.callbacks import ignore
from tracker.base.child import start_child
from tracker.base.errors import FileError, GlovetrackError
from tracker.base.notices import notice
from tracker.messages import EngineState, Message, StereoFrame
from tracker.session import engine_state
from tracker.session.description import SessionInfo
from tracker.session.recording.child import serve
from tracker.session.recording.image_slots import ImageSlots, bytes_of
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
    alone,
)
from tracker.session.writer import RecorderParams, SessionRecorder


class Process(Protocol):
    """What `RemoteRecorder` requires of a recorder's process."""

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
    """Like `tracker.session.writer.SessionRecorder`, but in another process; for one thread.

    Messages are sent in batches, with `flush`. Raises FileError, from any method, when writing has
    failed or the process has ended; NoSharedMemory from `write` if there is no room for images.
    """

    def __init__(self, process: Process, images: bool, release: Callable[[], None]) -> None:
        self._process, self._wants_images, self._release = process, images, release
        self.path = process.path
        self._batch: list[Item] = []
        self._slots: list[ImageSlots] = []
        self._failed = self._closed = False

    @property
    def pid(self) -> int:
        """The id of the process that writes."""
        return self._process.pid

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        """Queues one message; returns False for an image without a free slot."""
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
            return replace(frame, left=None, right=None)  # with the camera's pose
        if not self._slots or self._slots[-1].opened.slot_bytes < size:
            self._slots.append(ImageSlots(len(self._slots), size))
            self._batch.append(self._slots[-1].opened)
        return self._slots[-1].put(frame)

    def flush(self) -> None:
        """Sends the queued messages, which are then safe if this process is killed."""
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


BEGIN_TIMEOUT = 30.0  # s, enough for a process that is just starting on a loaded machine
SEND_TIMEOUT = 30  # s, for a delayed process; normally it reads immediately
END_TIMEOUT = 60.0  # s, for a slow disk
LEAVE_TIMEOUT = 5.0  # s, for an idle process


class RecorderProcess:
    """Writes one recording after the other; called by one thread at a time.

    ``prepare`` is pickled, and called in the process first.
    """

    def __init__(self, prepare: Callable[[], object] = ignore) -> None:
        self._pipe, self._process = start_child("glovetrack-recorder", serve, prepare)
        _limit_sending(self._pipe)
        self._reported: RecordingFailed | None = None
        self._left = False
        self.path = Path()

    @property
    def pid(self) -> int:
        return self._process.pid or 0

    @property
    def alive(self) -> bool:
        """Whether it can begin a recording."""
        return not self._pipe.closed and self._process.is_alive()

    def begin(self, begin: Begin) -> Path:
        """Open a file and return its path. Raises FileError as `SessionRecorder` does."""
        self.path, self._reported = begin.path, None
        self._send(begin)
        reply = self._reply(BEGIN_TIMEOUT)
        if isinstance(reply, Begun):
            self.path = reply.path
            return self.path
        if isinstance(reply, RecordingFailed):
            raise reply.error
        raise self._ended()

    def send(self, items: list[Any]) -> None:
        """Send a batch; may wait for the process. Raises errors of the process."""
        self.check()
        self._send(items)

    def check(self) -> None:
        """Raises errors of the process."""
        while self._reported is None and self._reply_waits(0.0):
            reply = self._reply(0.0)
            if isinstance(reply, RecordingFailed):
                self._reported = reply
                raise reply.error

    def end(self) -> None:
        """Waits until the file is closed. Raises errors of the process that were not raised yet."""
        self._send(End())
        failed: RecordingFailed | None = None
        while True:
            reply = self._reply(END_TIMEOUT)
            if isinstance(reply, Ended):
                break
            if not isinstance(reply, RecordingFailed):
                raise self._ended()
            failed = reply
        if failed is not None and self._reported is None:
            raise failed.error

    def _send(self, what: object) -> None:
        try:
            self._pipe.send(what)
        except OSError as error:
            raise self._ended() from error

    def _reply(self, timeout: float) -> Any:
        """Returns the next reply; None if there is none in time."""
        try:
            return self._pipe.recv() if self._reply_waits(timeout) else None
        except (EOFError, OSError) as error:
            raise self._ended() from error

    def _reply_waits(self, timeout: float) -> bool:
        try:
            return self._pipe.poll(timeout)
        except OSError as error:
            raise self._ended() from error

    def _ended(self) -> FileError:
        """Handles a process that has ended or does not respond; the latter ends when its disk
        responds."""
        with suppress(OSError):
            self._pipe.close()
        self._process.join(0.5)
        self._left = self._process.is_alive()
        code = self._process.exitcode or 0
        if self._left:
            why = "does not answer any more"
        else:
            why = f"was ended by signal {-code}" if code < 0 else f"has ended (exit code {code})"
        there = f" What it has written is in {self.path}; Recover makes it whole."
        return FileError(
            notice("recording.process_ended", why=why, there=there if self.path.is_file() else "")
        )

    def close(self) -> None:
        """End the process, which has no open file or does not respond."""
        with suppress(OSError):
            self._pipe.close()
        if self._left:
            return
        if self._process.is_alive():
            self._process.terminate()
        self._process.join(LEAVE_TIMEOUT)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()


def _limit_sending(pipe: Connection) -> None:
    """Limits the time to wait for the other side to read to `SEND_TIMEOUT`. Not on Windows."""
    if os.name == "posix":
        with socket.socket(fileno=os.dup(pipe.fileno())) as end:
            limit = struct.pack("ll", SEND_TIMEOUT, 0)
            end.setsockopt(socket.SOL_SOCKET, socket.SO_SNDTIMEO, limit)


class RecorderProcesses:
    """Keeps a process ready for the next recording, and more if several recordings run at once.

    Methods may be called from any thread.
    """

    def __init__(self, prepare: Callable[[], object] = ignore) -> None:
        self._prepare = prepare
        self._lock = threading.Lock()
        self._idle: list[RecorderProcess] = []
        self._closed = False

    def warm(self) -> None:
        """Start a process in advance, so that a recording begins immediately."""
        with self._lock:
            self._idle = [p for p in self._idle if p.alive]
            if not self._idle and not self._closed:
                self._idle.append(RecorderProcess(self._prepare))

    def record(
        self,
        path: Path,
        info: SessionInfo,
        params: RecorderParams | None = None,
        companion: Callable[[SessionRecorder], Sink] = alone,
    ) -> RemoteRecorder:
        """Begin a recording as `SessionRecorder` does, in another process."""
        self.warm()
        with self._lock:
            process = self._idle.pop() if self._idle else RecorderProcess(self._prepare)
        params = replace(params or RecorderParams(), sync_in_thread=True)
        try:
            process.begin(Begin(Path(path), info, params, companion))
        except GlovetrackError:
            self._return_process(process)
            raise
        return RemoteRecorder(
            process, params.images != "none", lambda: self._return_process(process)
        )

    def _return_process(self, process: RecorderProcess) -> None:
        """Takes back a process whose recording has ended or failed."""
        with self._lock:
            wanted = process.alive and not self._idle and not self._closed
            if wanted:
                self._idle.append(process)
        if not wanted:
            process.close()
            self.warm()

    def close(self) -> None:
        """End all idle processes; one that records ends with its recording."""
        with self._lock:
            self._closed, waiting, self._idle = True, self._idle, []
        for process in waiting:
            process.close()
