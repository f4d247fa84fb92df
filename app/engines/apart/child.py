"""The process that tracks: it owns the devices, the engine and the recorder.

It ends when the window asks for that or has ended; a recording is finished first.
"""

from __future__ import annotations

import contextlib
import faulthandler
import logging
import os
import queue
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Sequence
from functools import partial
from multiprocessing.connection import Connection
from multiprocessing.reduction import ForkingPickler
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication

from app.engines.apart.messages import (
    LISTENER,
    Answered,
    EngineRequest,
    Estimated,
    Failed,
    HandFacts,
    Logged,
    Opened,
    Progressed,
    Received,
    Taken,
    thread_failed,
)
from app.engines.apart.news import Newsroom
from app.engines.apart.source import Source
from app.engines.engine import Built, EngineSetup
from app.engines.protocols import RecordingRequest
from app.platform.process_tuning import (
    collection_postponed,
    freeze_new_objects,
    freeze_permanent_objects,
    tune_process,
)
from app.platform.tasks import JobProgress
from app.platform.translation import install
from tracker.base.errors import GlovetrackError, notice_of
from tracker.base.urgency import UrgencyGuard, run_first
from tracker.fusion.engine import Engine
from tracker.messages import Estimate
from tracker.streaming.apart import EstimateLine, feed
from tracker.streaming.connection import StreamError
from tracker.streaming.streams import BACKLOG
from tracker.vision.colours import ColourProfile

_log = logging.getLogger(__name__)
IGNORED = ("SIGINT", "SIGHUP")
"""Signals of a terminal to all its processes: the window asks for the end."""

POLL_EVERY = 0.5  # s between checks whether to end
SHORTEST = 0.01  # s, between messages to the window
SETTLED = 3.0  # s after the start of tracking; then all modules and objects that it needs exist
END = "end"
"""A request to end."""

LONGEST_CLOSING = 100.0
"""s without progress after which the process ends although a device or a disk hangs."""


def serve(pipe: Connection, source: Source, language: str, crash: Path, waits: bool) -> None:
    """Runs until the window ends it; the file ``crash`` receives the traceback of a hard crash, and
    is removed at a regular end.

    ``waits``: it loads what ``source`` needs and waits for the source to open.
    """
    with crash.open("w", encoding="utf-8") as file, collection_postponed():
        faulthandler.enable(file)
        wanted = _awaited(pipe, source) if waits else source
        if wanted is not None:
            _serve(pipe, wanted, language)
        faulthandler.disable()
    crash.unlink(missing_ok=True)


def _awaited(pipe: Connection, source: Source) -> Source | None:
    """The source that the window wants to open; None when it has ended instead."""
    _ignore_signals()
    try:
        source.prepare()
    except GlovetrackError as error:  # `build` reports it
        _log.info("Not loaded in advance: %s", error)
    try:
        wanted: Source = pipe.recv()
    except (EOFError, OSError):
        return None
    return wanted


def _ignore_signals() -> None:
    for name in IGNORED:
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)


def _serve(pipe: Connection, source: Source, language: str) -> None:
    _ignore_signals()
    run_first()
    tune_process()
    install(QCoreApplication(sys.argv[:1]), language)
    line = Line(pipe)
    logging.getLogger().addHandler(LogToWindow(line))
    run(line, source)


def run(line: Line, source: Source) -> None:
    """Builds the engine and carries out requests until the window ends it."""
    try:
        built = source.build(JobProgress(lambda part, text: line.send(Progressed(part, text))))
    except Exception as error:  # noqa: BLE001 - the window reports whatever it is
        line.send(Answered(0, error=portable(error)))
        return
    freeze_permanent_objects()
    desk = Desk(built, line)
    try:
        desk.run()
    finally:
        desk.close()


class Line:
    """Sends messages from any thread; nothing once the window is gone."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe, self._out = pipe, EstimateLine(pipe)
        self._waiting: deque[bytes] = deque(maxlen=BACKLOG)  # estimates
        self._passing = threading.Lock()

    def send(self, message: object) -> None:
        """May wait for a window that does not read."""
        with contextlib.suppress(StreamError):  # its end is noticed on reading
            self._out.write(ForkingPickler.dumps(message))
        self._pass_estimates()

    def send_estimate(self, item: Estimated) -> None:
        """Never waits on Linux: what a window that hangs does not accept is sent with the next
        one, and the oldest of more than `BACKLOG` are discarded."""
        self._waiting.append(item.packed())
        self._pass_estimates()

    def _pass_estimates(self) -> None:
        if not self._passing.acquire(blocking=False):
            return
        try:
            while self._waiting and self._out.offer(self._waiting[0]):
                self._waiting.popleft()
        finally:
            self._passing.release()

    def receive(self) -> Any:
        """Waits for a message. Raises EOFError or OSError when the window has ended."""
        return self._pipe.recv()


class LogToWindow(logging.Handler):
    """Passes the log on to the window's."""

    def __init__(self, line: Line) -> None:
        super().__init__(logging.WARNING)
        self._line = line

    def emit(self, record: logging.LogRecord) -> None:
        self._line.send(Logged(record.name, record.levelno, self.format(record)))


def portable(error: Exception) -> Exception:
    """An error that can be sent: one of ours or of the system unchanged, another one as text."""
    if isinstance(error, GlovetrackError | OSError):
        return error
    _log.error("A request to the engine failed", exc_info=error)
    return GlovetrackError(notice_of(error))


def facts_of(setup: EngineSetup) -> HandFacts:
    """What the window receives of a hand once."""
    camera, connection = setup.camera, setup.connection
    return HandFacts(
        setup.name,
        setup.hand,
        setup.glove,
        camera.without_devices(),
        connection.without_device(),
        setup.profile,
        connection.device.report() if connection.device is not None else None,
        camera.controls is not None,
        camera.device.fps if camera.device is not None else None,
        setup.simulated,
        setup.application,
        setup.missing,
        setup.anchor,
    )


class Desk:
    """Carries out requests. Those that may wait have threads of their own, the others one."""

    def __init__(self, built: Built, line: Line) -> None:
        self._setup, self._line = built.setup, line
        self._room = Newsroom(built.setup)
        self._ended, self._closed = threading.Event(), threading.Event()
        self._taken = threading.Event()
        self._pause = 0.0
        self._reporter = threading.Thread(target=self._report, name="glovetrack-news", daemon=True)
        self._arrival: dict[int, tuple[float, float]] = {}  # of the last estimate, by hand
        self._requests: queue.SimpleQueue[EngineRequest | None] = queue.SimpleQueue()
        self._targets: dict[str, object] = {"engine": _EngineTarget(self._setup, self._room)}
        self._targets["files"] = _Files(self._setup, self._room)
        self._targets["streams"] = self._streams = _Streams(self._setup)
        self._targets["wearer"] = _Wearer(built.send)
        if self._setup.camera.controls is not None:
            self._targets["controls"] = self._setup.camera.controls
        for number, hand in enumerate(self._setup.hands):
            self._add_hand(number, hand)
        facts = tuple(facts_of(hand) for hand in self._setup.hands)
        line.send(Opened(facts, built.begins, built.scene))

    def _add_hand(self, number: int, setup: EngineSetup) -> None:
        if setup.live is None:
            return
        self._targets[f"hand {setup.side}"] = setup.live.hand
        if setup.connection.device is not None:
            self._targets[f"glove {setup.side}"] = setup.connection.device
        for name, listener in setup.listeners.items():
            self._targets[LISTENER.format(setup.side, name)] = listener
        setup.live.hand.follow(partial(self._follow, number))
        setup.live.hand.subscribe(partial(self._pass_on, number))

    def _follow(self, number: int, estimate: Estimate, t_arrival: float) -> None:
        """Called before `_pass_on` unless there is no packet or image behind the estimate."""
        self._arrival[number] = estimate.t, t_arrival

    def _pass_on(self, number: int, estimate: Estimate) -> None:
        t, t_arrival = self._arrival.get(number, (float("nan"), 0.0))
        arrival = t_arrival if t == estimate.t else None
        self._line.send_estimate(Estimated(number, estimate, arrival))

    def run(self) -> None:
        """Returns when the window asks for the end, or has ended."""
        threading.Thread(target=self._work, name="glovetrack-requests", daemon=True).start()
        self._reporter.start()
        try:
            while True:
                message = self._line.receive()
                if message == END:
                    return
                if isinstance(message, Taken):
                    self._pause = message.pause
                    self._taken.set()
                elif message.urgent:
                    self._answer(message)
                elif message.waits:
                    threading.Thread(target=self._answer, args=(message,), daemon=True).start()
                else:
                    self._requests.put(message)
        except (EOFError, OSError):
            return

    def close(self) -> None:
        """Stop tracking, finish a recording, free the devices."""
        threading.Thread(target=self._end_at_last, name="glovetrack-end", daemon=True).start()
        self._ended.set()
        self._requests.put(None)
        self._reporter.join()
        self._streams.end()
        try:
            self._setup.engine.stop()
            self._send_update()  # whether files are complete
        finally:
            self._setup.close()
            self._room.pixels.close()
            self._closed.set()

    def _end_at_last(self) -> None:
        """End although a device or a disk hangs: nothing was written for `LONGEST_CLOSING`."""
        written = -1
        while (now := sum(file.written for file in self._room.files.values())) > written:
            written = now
            if self._closed.wait(LONGEST_CLOSING):
                return
        os._exit(1)

    def _work(self) -> None:
        while (request := self._requests.get()) is not None:
            self._answer(request)

    def _answer(self, request: EngineRequest) -> None:
        try:
            target = self._targets[request.target]
            if request.method == "command":
                self._command(request)
                return
            result = getattr(target, request.method)(*request.args, **request.kwargs)
        except Exception as error:  # noqa: BLE001 - raised in the window, or logged there
            if request.number:
                self._line.send(Answered(request.number, error=portable(error)))
            else:
                _log.exception("%s of %s failed", request.method, request.target)
            return
        if request.number:
            self._line.send(Answered(request.number, result))

    def _command(self, request: EngineRequest) -> None:
        """A command to an engine is answered when its thread has carried it out."""
        side = request.target.removeprefix("hand ")
        live = self._setup.seen_from(side).live
        assert live is not None
        work: Callable[[Engine], object] = request.args[0]
        live.hand.command(work, lambda result: self._line.send(Answered(request.number, result)))

    def _report(self) -> None:
        """Send what is new whenever the window has taken what was sent before."""
        settling, guard = SETTLED, UrgencyGuard()
        while not self._ended.is_set():
            guard.check()
            if not self._taken.wait(POLL_EVERY):
                continue
            self._taken.clear()
            if self._ended.wait(self._pause) or not self._send_update():
                return
            if settling > 0 and self._setup.tracked.latest_estimate() is not None:
                settling -= max(self._pause, SHORTEST)
                if settling <= 0:
                    freeze_new_objects()

    def _send_update(self) -> bool:
        """Returns whether they could be collected; otherwise the window has to stop tracking, or it
        would show that all is well."""
        try:
            news = Received(*self._room.news())
        except Exception as error:  # noqa: BLE001 - of any device
            _log.exception("The news could not be collected")
            self._line.send(Failed(thread_failed("news", error)))
            return False
        self._line.send(news)
        return True


class _EngineTarget:
    """Requests to the engine of all hands."""

    def __init__(self, setup: EngineSetup, room: Newsroom) -> None:
        assert setup.live is not None
        self._engine, self._room = setup.live.engine, room
        self.start, self.stop, self.note = self._engine.start, self._engine.stop, self._engine.note
        self.set_engine, self.keep_state = self._engine.set_engine, self._engine.keep_state

    def set_profile(self, profile: ColourProfile) -> None:
        self._engine.set_profile(profile)
        self._room.profiles += 1

    def record_into(self, key: int) -> None:
        """Record into the file of `_Files.open`; 0: end the recording."""
        self._engine.set_recorder(self._room.files[key] if key else None)


class _Files:
    """Recordings, by the numbers that the window gives them."""

    def __init__(self, setup: EngineSetup, room: Newsroom) -> None:
        self._setup, self._room = setup, room

    def open(self, side: str, key: int, request: RecordingRequest) -> None:
        """Begin a file. Raises GlovetrackError or OSError."""
        live = self._setup.seen_from(side).live
        assert live is not None
        self._room.files = {**self._room.files, key: live.make_recorder(request)}

    def pause(self, key: int, on: bool) -> None:
        self._room.files[key].paused = on

    def write(self, key: int, *args: Any) -> bool:
        return self._room.files[key].write(*args)

    def flush(self, key: int) -> None:
        self._room.files[key].flush()

    def close(self, key: int) -> None:
        self._room.files[key].close()

    def forget(self, key: int) -> None:
        self._room.files = {k: file for k, file in self._room.files.items() if k != key}


class _Streams:
    """Passes estimates to the process of the streams."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self._changing = threading.Lock()
        self._line: EstimateLine | None = None
        self._ends: list[Callable[[], None]] = []

    def begin(self, line: Connection, sides: Sequence[str]) -> None:
        self.end()
        with self._changing:
            self._line = EstimateLine(line)
            self._ends = [
                feed(self._setup.seen_from(side).tracked, self._line, k)
                for k, side in enumerate(sides)
            ]

    def end(self) -> None:
        with self._changing:
            for end in self._ends:
                end()
            if self._line is not None:
                self._line.close()
            self._line, self._ends = None, []


class _Wearer:
    """A simulated wearer."""

    def __init__(self, send: Callable[..., None]) -> None:
        self.send = send
