"""The one object between the window and the engine.

Panels never touch the engine: they read a `Snapshot` and call this object, and it tells them of
events by signal.
"""

from __future__ import annotations

import dataclasses
import logging
import time
from collections import deque
from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Signal

from app.engines.engine import EngineSetup, RecordingRequest
from app.engines.notes import Notes
from app.engines.recording import Recording
from app.engines.snapshot import Snapshot, nearest
from app.platform.tasks import JobProgress, TaskOwner
from tracker.errors import GlovetrackError
from tracker.fusion.engine import Engine
from tracker.messages import Estimate, Message, Status
from tracker.vision.colours import ColourProfile

_log = logging.getLogger(__name__)
SetupFactory = Callable[[JobProgress], EngineSetup]
STATUS_PERIOD = 0.1  # s
CLOSING = 0.3  # s that the end of a file is waited for; a slow disk finishes it while one goes on
RECENT_ESTIMATES = 60
"""One second at the window's rate: more than any image is late."""


class EngineHost(QObject):
    """Owns the engine, the recording and the jobs that make and end them."""

    opened = Signal(object)  # EngineSetup
    closed = Signal()
    running_changed = Signal(bool)
    profile_changed = Signal(object)  # ColourProfile
    engine_changed = Signal(str)
    happened = Signal(object)  # Event
    error = Signal(str)

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._setup: EngineSetup | None = None
        self.recording = Recording(self)
        self.recording.failed.connect(self.error)
        self.notes = Notes(self._tell_note, self)
        self.recording.begun.connect(self.notes.begin)
        self.recording.finished.connect(lambda _path: self.notes.end())
        self._recent: deque[Estimate] = deque(maxlen=RECENT_ESTIMATES)
        self._status: Status | None = None
        self._status_due = 0.0
        self._factory: tuple[str, SetupFactory] | None = None
        self._spent = False  # the engine has been stopped and cannot start again
        self.running = False
        self.opening = False
        self._ended = False

    # --- life of the engine

    @property
    def setup(self) -> EngineSetup | None:
        return self._setup

    def open(self, title: str, factory: SetupFactory, start: bool = True) -> None:
        """Build an engine in the background (it compiles, opens ports) and start it."""
        if self.opening:
            return
        self.shut_down()
        self.opening = True
        self._factory = (title, factory)
        self._tasks.run(title, factory, lambda setup: self.adopt(setup, start), self._opening_ended)

    def _opening_ended(self) -> None:
        self.opening = False

    def adopt(self, setup: EngineSetup, start: bool = True) -> None:
        """Take over a built engine."""
        self.opening = False
        if self._ended:
            setup.engine.stop()
            setup.close()
            return
        self.shut_down()
        self._setup = setup
        self._spent = False
        self.opened.emit(setup)
        if start:
            self.start()

    def start(self) -> None:
        """Start the engine; one that was stopped before is built anew."""
        if self._setup is None or self.running:
            return
        if self._spent and self._factory is not None:
            self.open(*self._factory)
            return
        try:
            self._setup.engine.start()
        except GlovetrackError as error:
            self.error.emit(str(error))
            return
        self.running = True
        self.running_changed.emit(True)

    def stop(self) -> None:
        if self._setup is None or not self.running:
            return
        self.recording.end()
        self._setup.engine.stop(CLOSING)
        self.recording.leave()
        self.running = False
        self._spent = True
        self.running_changed.emit(False)

    def shut_down(self) -> None:
        """Stop, close the file, free the devices. Safe to call at any time."""
        self.stop()
        if self._setup is None:
            return
        setup, self._setup = self._setup, None
        if not self._spent:
            setup.engine.stop()  # one that never ran holds its devices too
        self._recent.clear()
        self._status = None
        setup.close()
        self.closed.emit()

    def end(self) -> None:
        """Shut down for good: an engine still being built is freed when it comes.

        Waits for the disk, where a file is not whole yet.
        """
        self._ended = True
        self.shut_down()
        self.recording.wait()

    # --- what the user asks

    def record(self, request: RecordingRequest) -> bool:
        """Begin a file; False, with an `error`, where that is impossible."""
        return self._setup is not None and self.recording.begin(self._setup, request)

    def toggle_recording(self, ask: Callable[[], RecordingRequest]) -> None:
        """End the file that is being written, or begin the one that ``ask`` tells of."""
        if self.recording.request is not None:
            self.recording.end()
            return
        try:
            self.record(ask())
        except GlovetrackError as error:
            self.error.emit(str(error))

    def toggle_pause(self) -> None:
        self.recording.pause(not self.recording.paused)

    def _tell_note(self, text: str, t: float, data: Mapping[str, object]) -> None:
        if self._setup is not None:
            self._setup.engine.note(text, t, data)

    def set_profile(self, profile: ColourProfile) -> None:
        """Look for these colours from now on."""
        if self._setup is not None:
            self._setup.engine.set_profile(profile)
            self._setup = dataclasses.replace(self._setup, profile=profile)
        self.profile_changed.emit(profile)

    def set_engine(self, name: str) -> None:
        """Track with another engine from now on."""
        if self._setup is None:
            return
        try:
            self._setup.engine.set_engine(name)
        except GlovetrackError as error:  # half a rig does not serve every engine
            self.error.emit(str(error))
            return
        self.engine_changed.emit(name)

    def command(self, work: Callable[[Engine], None]) -> bool:
        """Do something to the engine in its own thread; False where there is none to take it."""
        if self._setup is None or self._setup.command is None:
            return False
        self._setup.command(work)
        return True

    # --- what panels see

    def recent(self) -> list[Message]:
        """Samples and estimates of the last seconds, in the order of their arrival."""
        if self._setup is None:
            return []
        found: list[Message] = [*self._setup.engine.recent_imu(), *self._recent]
        return sorted(found, key=lambda m: getattr(m, "t_arrival", m.t))

    def _status_of(self, setup: EngineSetup) -> Status:
        """A few times a second: its medians and percentiles cost more than the rest of a look."""
        now = time.monotonic()
        if self._status is None or now >= self._status_due:
            self._status, self._status_due = setup.engine.status(), now + STATUS_PERIOD
        return self._status

    def snapshot(self) -> Snapshot | None:
        """The latest of everything, and the events since the last call by signal."""
        self.recording.look()
        setup = self._setup
        if setup is None:
            return None
        for event in setup.engine.take_events():
            self.happened.emit(event)
        if self._spent and setup.player is None:
            return Snapshot(setup=setup, running=False)  # what was live is no more
        estimate = setup.engine.latest_estimate()
        if estimate is not None and (not self._recent or self._recent[-1].t != estimate.t):
            self._recent.append(estimate)
        triple = setup.engine.latest_frame()
        frame, blobs, result = triple if triple is not None else (None, None, None)
        return Snapshot(
            setup=setup,
            running=self.running,
            estimate=estimate,
            estimate_at_frame=nearest(self._recent, frame.t) if frame is not None else estimate,
            frame=frame,
            blobs=blobs,
            result=result,
            calibration=setup.engine.calibration(),
            status=self._status_of(setup),
            imu=setup.engine.recent_imu(),
        )
