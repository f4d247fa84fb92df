"""The recording of a live engine; a pause leaves a gap in the file."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.engines.engine import LivePart
from app.engines.protocols import RecordedFile, RecordingRequest
from app.words import error_text, notice_text, tr
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError, notice_of
from tracker.base.notices import Notice
from tracker.engine.kinds import settings_text
from tracker.live.recording import Recorder
from tracker.messages import Calibration, EngineState, Event, Message, Status
from tracker.session.description import SessionInfo
from tracker.vision.colours import profile_to_toml

if TYPE_CHECKING:
    from tracker.live.runner import LiveTracker

LONGEST_CLOSING = 100.0
"""s, longer than the time limit of the recorder's process; its file can be recovered then."""


class PausableRecorder:
    """Passes messages on to ``inner`` unless ``paused``; rare messages always."""

    def __init__(self, inner: Recorder) -> None:
        self._inner = inner
        self.paused = False
        self.written = 0  # messages so far
        self.broken = False  # nothing more is written; the engine has reported why
        self.problem = ""  # the reason, for when the engine is closed
        self._closed = threading.Event()
        self.figures: Mapping[str, float] = {}  # of the last status, for this recording

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        if isinstance(message, Status):
            self.figures = message.values
        if self.paused and not isinstance(message, Event | Calibration | EngineState):
            return True
        with self._watched():
            taken = self._inner.write(message, overloaded, side)
        self.written += 1
        return taken

    def flush(self) -> None:
        with self._watched():
            self._inner.flush()

    @property
    def closed(self) -> bool:
        """Whether the file is complete, or as complete as possible."""
        return self._closed.is_set()

    def wait(self, longest: float) -> bool:
        """Wait until it is `closed`, at most ``longest`` s; returns whether it is."""
        return self._closed.wait(longest)

    def close(self) -> None:
        try:
            with self._watched():
                self._inner.close()
        finally:
            self._closed.set()

    @contextmanager
    def _watched(self) -> Iterator[None]:
        try:
            yield
        except Exception as error:  # of any kind: the panel must not show a running recording
            self.broken, self.problem = True, error_text(error)
            raise


class Recording(QObject):
    """One file at a time; ``request`` is None while there is none.

    ``clock`` gives s; during a pause the recorded time continues, as in the file.
    """

    changed = Signal(bool)  # whether a file is being written
    begun = Signal()
    finished = Signal(object)  # its Path: it is closed now
    failed = Signal(str)

    def __init__(
        self, parent: QObject | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        super().__init__(parent)
        self._clock = clock
        self._open: LivePart | None = None  # that can be recorded
        self._live: LivePart | None = None  # that is recorded
        self._recorder: RecordedFile | None = None
        self._began = 0.0
        self._closing: tuple[Path, RecordedFile] | None = None  # its disk is slow
        self._left = False  # its engine is closed and does not report problems any more
        self.request: RecordingRequest | None = None
        self.refusal: Notice | None = None  # why the last one could not begin
        self.ended_by = ""  # why the last one ended, if the user did not end it

    @property
    def paused(self) -> bool:
        return self._recorder is not None and self._recorder.paused

    @property
    def written(self) -> int:
        """The number of messages in the file so far."""
        return self._recorder.written if self._recorder is not None else 0

    @property
    def figures(self) -> Mapping[str, float]:
        """The values of the file's last status: losses since the recording began."""
        return self._recorder.figures if self._recorder is not None else {}

    @property
    def begun_at(self) -> float:
        """Start time of the recording (s, monotonic clock)."""
        return self._began

    @property
    def elapsed(self) -> float:
        """s since the recording began; 0 without one."""
        return self._clock() - self._began if self.request is not None else 0.0

    def set_engine(self, live: LivePart | None) -> None:
        """Record this engine from the next `begin` on; None where there is none, or a replay."""
        self._open = live

    @property
    def is_possible(self) -> bool:
        """Whether a live engine is open; a replay cannot be recorded."""
        return self._open is not None

    def toggle(self, ask: Callable[[], RecordingRequest]) -> None:
        """End the file that is being written, or begin the one that ``ask`` returns."""
        if self.request is not None:
            self.end()
            return
        try:
            self.begin(ask())
        except GlovetrackError as error:
            self.refuse(error.notice)

    def begin(self, request: RecordingRequest) -> bool:
        """Begin a file; returns False and emits `failed` if that is impossible."""
        live = self._open
        if live is None or self.request is not None:
            return False
        self.refusal = None
        self.poll()
        if self._closing is not None:
            self.failed.emit(
                tr(
                    "{} is still being written. Wait until it is finished, then record again."
                ).format(self._closing[0].name)
            )
            return False
        try:
            self._recorder = live.make_recorder(request)
        except (GlovetrackError, OSError) as error:
            self.refuse(notice_of(error))
            return False
        self._live, self.request, self._began = live, request, self._clock()
        self.ended_by = ""
        live.engine.set_recorder(self._recorder)
        self.changed.emit(True)
        self.begun.emit()
        return True

    def refuse(self, why: Notice) -> None:
        """Report that a recording could not begin."""
        self.refusal = why
        self.failed.emit(notice_text(why))

    def toggle_pause(self) -> None:
        """Pause the file, or resume it."""
        self.pause(not self.paused)

    def pause(self, on: bool) -> None:
        """Pause the file, or (off) resume it."""
        if self._recorder is None or self._live is None:
            return
        self._recorder.paused = on
        if not on:
            self._live.engine.keep_state()  # it continued during the pause
        self.changed.emit(True)

    def poll(self) -> None:
        """End a recording whose file has failed; emit `finished` for one that is closed by now.

        Call it regularly.
        """
        if self._recorder is not None and self._recorder.broken:
            self.end(self._recorder.problem)
        if self._closing is not None and self._closing[1].closed:
            (path, recorder), self._closing = self._closing, None
            if self._left and recorder.problem:
                self.failed.emit(
                    tr("The recording could not be finished: {}").format(recorder.problem)
                )
            self.finished.emit(path)

    def leave(self) -> None:
        """The engine is closed now; a file on a slow disk is finished without it."""
        self.poll()
        self._left = True

    def wait(self) -> None:
        """Wait until no file is being written, at most `LONGEST_CLOSING`."""
        if self._closing is not None:
            self._closing[1].wait(LONGEST_CLOSING)
        self.poll()

    @property
    def closing(self) -> bool:
        """Whether a recording that has ended is still being written."""
        return self._closing is not None

    @property
    def file(self) -> Path | None:
        """The file that is being written, until it is closed."""
        if self.request is not None:
            return self.request.path
        return self._closing[0] if self._closing is not None else None

    def end(self, by: str = "") -> None:
        """End the file; the engine writes queued messages and closes it, possibly after the return.

        `poll` emits `finished` when it is closed. ``by``: the reason, if not the user's wish.
        """
        if self._live is None or self.request is None or self._recorder is None:
            return
        self.ended_by = by
        self._closing, self._left = (self.request.path, self._recorder), False
        self._live.engine.set_recorder(None)
        self._live = self._recorder = self.request = None
        self.changed.emit(False)
        self.poll()


def recorder_maker(
    tracker: LiveTracker,
    info: SessionInfo,
    record: Callable[[Path, SessionInfo], Recorder],
    clock: Callable[[], float] = monotonic,
) -> Callable[[RecordingRequest], PausableRecorder]:
    """Returns a function that begins a recording, with the present engine, settings and colours.

    ``record`` begins a file; ``clock`` gives s of the monotonic clock of ``info.anchor``.
    """

    def make_recorder(request: RecordingRequest) -> PausableRecorder:
        named = replace(
            info,
            anchor=info.anchor.at(clock()),
            participant=request.participant,
            notes=request.task,
            engine=tracker.settings.engine,
            settings_text=settings_text(tracker.settings),
            colours_text=profile_to_toml(tracker.profile),
        )
        return PausableRecorder(record(request.path, named))

    return make_recorder
