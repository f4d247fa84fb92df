"""The window's end of the process that tracks."""

from __future__ import annotations

import atexit
import contextlib
import itertools
import logging
import os
import pickle
import tempfile
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeout
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from app.engines.apart.child import END, serve
from app.engines.apart.messages import (
    Answered,
    EngineRequest,
    Estimated,
    Failed,
    Logged,
    Opened,
    Progressed,
    Received,
    Taken,
    thread_failed,
)
from app.engines.apart.source import Source
from app.platform.tasks import JobProgress
from app.words import language
from tracker.base.child import start_child
from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, failure
from tracker.streaming.apart_estimate import MARK

ANSWER_WAIT = 10.0  # s for an answer, on a loaded computer
POLL_EVERY = 0.05  # s between checks whether opening was cancelled
FASTEST, SLOWEST = 1 / 60, 0.25  # s between news
T = TypeVar("T")
_log = logging.getLogger(__name__)


def process_ended() -> Notice:
    """The process has ended by itself."""
    return failure("engine.process_ended")


def _empty_file() -> Path:
    handle, name = tempfile.mkstemp(prefix="glovetrack-tracking-", suffix=".log")
    os.close(handle)
    return Path(name)


class Started(NamedTuple):
    """A process, our end of the pipe to it, and the file for the traceback of a crash."""

    pipe: Connection
    process: BaseProcess
    crash: Path


def start_process(source: Source, waits: bool = False) -> Started:
    """``waits``: it loads what ``source`` needs and waits until it is sent the source to open."""
    crash = _empty_file()
    pipe, process = start_child(
        "glovetrack-engine", serve, source, language(), crash, waits, daemon=False
    )
    return Started(pipe, process, crash)


class EngineProcess:
    """Opens ``source`` in a process, which may be ``started`` already and have received the source.
    Methods may be called from any thread.

    ``on_estimate`` and ``on_update`` are called in a thread of it; ``on_failure``, there, too, with
    the reason when it fails, and ``on_end`` when the process has ended.
    """

    def __init__(self, source: Source, started: Started | None = None) -> None:
        self.source = source
        self._pipe, self._process, self._crash = started or start_process(source)
        self._sending = threading.Lock()
        self._numbers = itertools.count(1)
        self._waiting: dict[int, Future[Any]] = {}
        self._answers: dict[int, Callable[[Any], None]] = {}
        self._opened: Future[Opened] = Future()
        self._progress = 0.0, ""
        self._looked = time.monotonic()
        self.period = FASTEST  # s between two refreshes of the window
        self.ended = threading.Event()
        self.on_estimate: Callable[[Estimated], None] = lambda _: None
        self.on_update: Callable[[Received], None] = lambda _: None
        self.on_failure: Callable[[Notice], None] = lambda _: None
        self.on_end: Callable[[], None] = lambda: None
        atexit.register(self.close)  # or the end of the program would wait for the process
        self._thread = threading.Thread(
            target=self._read, name="glovetrack-engine-news", daemon=True
        )
        self._thread.start()

    @property
    def pid(self) -> int:
        return self._process.pid or 0

    # --- opening and closing

    def wait_opened(self, progress: JobProgress) -> Opened:
        """Waits until the engine is built. Raises what building it has raised, and Cancelled."""
        while True:
            try:
                return self._opened.result(POLL_EVERY)
            except FutureTimeout:
                progress(*self._progress)

    def begin_updates(self) -> None:
        """Receive news from now on."""
        self._send(Taken(0.0))

    def close(self) -> None:
        """Ends it; a recording is finished in the background. May be called again."""
        if self._opened.done():
            self._send(END)
        else:
            self.kill()

    def kill(self) -> None:
        """Ends it at once."""
        self._process.kill()

    # --- requests

    def tell(self, target: str, method: str, *args: Any, **kwargs: Any) -> None:
        """Calls a method there, without waiting for it."""
        self._send(EngineRequest(0, target, method, args, kwargs))

    def tell_now(self, target: str, method: str, *args: Any) -> bool:
        """As `tell`, before what was asked for earlier; returns whether it was sent."""
        return self._send(EngineRequest(0, target, method, args, urgent=True))

    def ask(
        self,
        target: str,
        method: str,
        *args: Any,
        wait: float = ANSWER_WAIT,
        parallel: bool = False,
        **kwargs: Any,
    ) -> Any:
        """Calls a method there; returns its result or raises its exception.

        ``parallel``: it may take long, so other requests do not wait for it. Raises DeviceError if
        there is no answer within ``wait`` s.
        """
        number, future = next(self._numbers), Future[Any]()
        self._waiting[number] = future
        try:
            if not self._send(EngineRequest(number, target, method, args, kwargs, parallel)):
                raise DeviceError(process_ended())
            return future.result(wait)
        except FutureTimeout as error:
            raise DeviceError(failure("engine.process_silent")) from error
        finally:
            self._waiting.pop(number, None)

    def ask_or(self, default: T, target: str, method: str, *args: Any) -> T:
        """As `ask` with ``parallel``, but ``default`` if the process has ended or is silent."""
        try:
            found: T = self.ask(target, method, *args, parallel=True)
        except DeviceError as error:
            _log.info("%s of %s: %s", method, target, error)
            return default
        return found

    def ask_later(
        self, target: str, method: str, *args: Any, answer: Callable[[Any], None]
    ) -> None:
        """Calls a method there; ``answer`` receives the result in another thread."""
        number = next(self._numbers)
        self._answers[number] = answer
        self._send(EngineRequest(number, target, method, args, waits=True))

    def _send(self, item: object) -> bool:
        with self._sending:
            if self.ended.is_set():
                return False
            try:
                self._pipe.send(item)
            except (OSError, ValueError):
                return False
            return True

    def refreshed(self) -> None:
        """The window has been refreshed: news are worth sending as often as that."""
        now = time.monotonic()
        self.period = min(max(now - self._looked, FASTEST), SLOWEST)
        self._looked = now

    # --- what arrives

    def _read(self) -> None:
        while (data := self._received()) is not None:
            try:
                if data.startswith(MARK):
                    self.on_estimate(Estimated.unpacked(data))
                else:
                    self._take(pickle.loads(data))
            except Exception as error:  # noqa: BLE001 - of any listener: tracking stops visibly
                _log.exception("A message of the process could not be processed")
                self.on_failure(thread_failed("news", error))
        self.ended.set()
        atexit.unregister(self.close)
        with self._sending:
            self._pipe.close()
        for future in (*self._waiting.values(), self._opened):
            if not future.done():
                future.set_exception(DeviceError(process_ended()))
        self._log_crash()
        self.on_end()

    def _log_crash(self) -> None:
        """A crash in compiled code leaves a traceback, which goes to the log of the window."""
        with contextlib.suppress(FileNotFoundError):  # a regular end
            if text := self._crash.read_text("utf-8", errors="replace"):
                _log.error("The tracking process has crashed:\n%s", text)
            self._crash.unlink()

    def _received(self) -> bytes | None:
        """The next message; None when the process has ended."""
        try:
            return self._pipe.recv_bytes()
        except (EOFError, OSError):
            return None

    def _take(self, item: object) -> None:
        match item:
            case Received():
                self.on_update(item)
                self._send(Taken(0.8 * self.period))
            case Answered():
                self._answer(item)
            case Progressed():
                self._progress = item.fraction, item.text
            case Opened():
                self._opened.set_result(item)
            case Failed():
                self.on_failure(item.why)
            case Logged():
                logging.getLogger(item.name).log(item.level, "%s", item.text)

    def _answer(self, item: Answered) -> None:
        future = self._waiting.get(item.number) if item.number else self._opened
        if future is None:
            self._answer_later(item)
        elif item.error is not None:
            future.set_exception(item.error)
        else:
            future.set_result(item.result)

    def _answer_later(self, item: Answered) -> None:
        answer = self._answers.pop(item.number, None)
        if item.error is not None:
            _log.error("A request to the process failed", exc_info=item.error)
        elif answer is not None:
            answer(item.result)
