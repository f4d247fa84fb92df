"""The only object between the window and the engine.

Panels never access the engine: they read a `Snapshot` and call this object, which emits signals.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable, Mapping
from typing import TypeVar

from PySide6.QtCore import QObject, Signal

from app.engines.apart.messages import ENDED
from app.engines.engine import EngineSetup
from app.engines.notes import Notes
from app.engines.recording import Recording
from app.engines.snapshot import EngineSnapshots, Snapshot
from app.platform.tasks import JobProgress, TaskOwner
from app.words import error_text, notice_text
from tracker.base.callbacks import ignore
from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice
from tracker.fusion.engine import Engine
from tracker.messages import Message
from tracker.vision.colours import ColourProfile

_log = logging.getLogger(__name__)
SetupFactory = Callable[[JobProgress], EngineSetup]
T = TypeVar("T")
REVIVE_EVERY = 20.0  # s; a process that ends sooner is not started again
CLOSING = 0.3  # s to wait for the end of a file; with a slow disk it is finished in the background


class EngineHost(QObject):
    """Owns the engine, the recording and the jobs that open and close them."""

    opened = Signal(object)  # EngineSetup
    hand_changed = Signal(object)  # EngineSetup: the same engine, seen from its other hand
    closed = Signal()
    running_changed = Signal(bool)
    profile_changed = Signal(object)  # ColourProfile
    profile_followed = Signal()  # the engine has adapted it; ``setup`` has it
    engine_changed = Signal(str)
    happened = Signal(object)  # Event
    error = Signal(str)

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._setup: EngineSetup | None = None
        self.recording = Recording(self)
        self.recording.failed.connect(self.error)
        self.notes = Notes(self._write_note, self)
        self.recording.begun.connect(self.notes.begin)
        self.recording.finished.connect(lambda _path: self.notes.end())
        self._snapshots = EngineSnapshots()
        self._factory: tuple[str, SetupFactory] | None = None
        self._spent = False  # the engine has been stopped and cannot start again
        self.running = False
        self.opening = False
        self._ended = False
        self._revived = float("-inf")  # s, when tracking that had stopped was started again

    # --- life of the engine

    @property
    def setup(self) -> EngineSetup | None:
        return self._setup

    def open(
        self, title: str, factory: SetupFactory, start: bool = True, keep: bool = False
    ) -> None:
        """Build an engine in the background (it compiles, opens ports) and start it.

        ``keep``: the present engine runs until the new one is ready, and remains if that cannot be
        built or a recording has begun meanwhile.
        """
        if self.opening:
            return
        if not keep:
            self.shut_down()
        self.opening = True

        def built(setup: EngineSetup) -> None:
            if keep and self.recording.request is not None:
                self._refuse(title, setup)
                return
            self._factory = (title, factory)
            self.adopt(setup, start)

        self._tasks.run(title, factory, built, self._opening_ended)

    def _refuse(self, title: str, setup: EngineSetup) -> None:
        """Close a built engine that would interrupt a recording."""
        self.opening = False
        setup.engine.stop()
        setup.close()
        self.error.emit(self.tr("{} was not opened, because a recording has begun.").format(title))

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
        self.recording.set_engine(setup.live)
        self._spent = False
        self.opened.emit(setup)
        if start:
            self.start()

    def start(self) -> None:
        """Start the engine; one that was stopped before is built again."""
        if self._setup is None or self.running:
            return
        if self._spent and self._factory is not None:
            self.open(*self._factory)
            return
        try:
            self._setup.engine.start()
        except GlovetrackError as error:
            self.error.emit(error_text(error))
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

    def _end_failed(self, why: Notice) -> None:
        """Stop after a thread of the engine has failed, and show why; a process that has ended is
        started again, unless it ends all the time."""
        self.stop()
        now = time.monotonic()
        since, self._revived = now - self._revived, now
        if why.code == ENDED and since >= REVIVE_EVERY:
            self.error.emit(
                self.tr("Tracking has stopped. {} It starts again.").format(notice_text(why))
            )
            self.start()
            return
        self.error.emit(
            self.tr("Tracking has stopped. {} Start it again.").format(notice_text(why))
        )

    def shut_down(self) -> None:
        """Stop, close the file, free the devices. Safe to call at any time."""
        self.stop()
        if self._setup is None:
            return
        setup, self._setup = self._setup, None
        self.recording.set_engine(None)
        if not self._spent:
            setup.engine.stop()  # it has its devices open even if it never ran
        self._snapshots = EngineSnapshots()
        setup.close()
        self.closed.emit()

    def end(self) -> None:
        """Shut down at the end of the program: an engine still being built is closed when ready.

        Waits until the file is complete.
        """
        self._ended = True
        self.shut_down()
        self.recording.wait()

    # --- requests of the user

    def _write_note(self, text: str, t: float, data: Mapping[str, object]) -> None:
        if self._setup is not None:
            self._setup.engine.note(text, t, data)

    def set_profile(self, profile: ColourProfile) -> None:
        """Search these colours from now on."""
        if self._setup is not None:
            self._setup.engine.set_profile(profile)
            self._setup = self._setup.with_profile(profile)
        self.profile_changed.emit(profile)

    def _follow_colours(self, setup: EngineSetup) -> EngineSetup:
        """Use colours that the engine has adapted."""
        profile = setup.engine.profile
        if profile == setup.profile:
            return setup
        self._setup = setup.with_profile(profile)
        self.profile_changed.emit(profile)
        self.profile_followed.emit()
        return self._setup

    def set_engine(self, name: str) -> None:
        """Track with another engine from now on."""
        if self._setup is None or self._setup.live is None:
            return
        try:
            self._setup.live.engine.set_engine(name)
        except GlovetrackError as error:  # incomplete devices do not support every engine
            self.error.emit(error_text(error))
            return
        self.engine_changed.emit(name)

    def show_hand(self, side: str) -> None:
        """Show the hand of this side in the panels, if there are two."""
        if self._setup is not None and self._setup.seen_from(side) is not self._setup:
            self._setup = self._setup.seen_from(side)
            self.recording.set_engine(self._setup.live)
            self.hand_changed.emit(self._setup)

    def command(
        self,
        work: Callable[[Engine], T],
        side: str = "",
        answer: Callable[[T], None] = ignore,
    ) -> bool:
        """Run ``work`` on the thread of the engine, for the hand shown or of ``side``, and pass the
        result to ``answer`` in another thread; returns False without a live engine.

        ``work`` is a function of a module, or a `partial` of one: the engine may be in another
        process.
        """
        setup = self._setup
        if setup is not None and side:
            setup = setup.seen_from(side)
        if setup is None or setup.live is None:
            return False
        setup.live.hand.command(work, answer)
        return True

    # --- data for panels

    def recent(self) -> list[Message]:
        """Samples and estimates of the hand shown, of the last seconds, in the order of arrival."""
        if self._setup is None:
            return []
        snapshots = self._snapshots.of(self._setup.side)
        found: list[Message] = [*self._setup.tracked.recent_imu(), *snapshots.recent]
        return sorted(found, key=lambda m: getattr(m, "t_arrival", m.t))

    def snapshot(self) -> Snapshot | None:
        """The latest data of all streams; emits the events since the last call."""
        self.recording.poll()
        setup = self._setup
        if setup is None:
            return None
        setup = self._follow_colours(setup)
        for event in setup.engine.drain_events():
            self.happened.emit(event)
        live = setup.live
        if self.running and live is not None and live.engine.failure:
            self._end_failed(live.engine.failure)
        if self._spent and live is not None:
            return Snapshot(setup=setup, running=False)  # live data are not valid any more
        return self._snapshots.take(setup, self.running)
