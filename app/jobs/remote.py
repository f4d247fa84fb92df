"""Remote control: servers that receive requests of other programs, and the replies."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from app.engines.engine_host import EngineHost
from app.engines.protocols import GloveDevice
from app.jobs.connections import Connections
from app.jobs.openings import Openings
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan, duration_text
from app.words import shown
from tracker.base.clock import monotonic
from tracker.base.notices import notice, plain
from tracker.hand.names import CHAINS, SIDES
from tracker.messages import Event, WristPose
from tracker.streaming.connection import ConnectionSettings
from tracker.streaming.remote.contacts import ContactBook, motor_of
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Allowance, DoorCounts
from tracker.streaming.remote.registry import DoorKind, door_kinds, open_door, with_doors
from tracker.streaming.remote.request import Reply, Request, RequestError, parse

MOTOR_HZ = 50.0  # maximum rate of commands to one motor; more would only load the glove's line
MOTORS = tuple(CHAINS)
POLL_MS = 250  # interval of checks for contacts that are no longer updated
CLOSING = notice("remote.closing")


class RemoteAnswers(QObject):
    """Answers requests: start, stop, notes, state and vibration."""

    _came = Signal(object, object)  # Request, and the Future of its Reply

    def __init__(
        self, host: EngineHost, plan: RecordingPlan, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._host, self._plan = host, plan
        self._waiting: set[Future[Reply]] = set()
        self._motors = {
            (side, finger): Allowance(MOTOR_HZ, monotonic())
            for side in ("", *SIDES)
            for finger in MOTORS
        }
        self._felt = {"vibrate": self._vibrate, "contact": self._contact, "wrist": self._place}
        self._contacts = ContactBook()
        self._poll_timer = QTimer(self)
        self._poll_timer.setInterval(POLL_MS)
        self._poll_timer.timeout.connect(lambda: self._record(self._contacts.expired(monotonic())))
        self._poll_timer.start()
        self._ended = False
        self._came.connect(self._act, Qt.ConnectionType.QueuedConnection)

    def answer(self, request: Request) -> Future[Reply]:
        """Schedule the answer in the window's thread; thread-safe."""
        future: Future[Reply] = Future()
        if self._ended:
            future.set_result(Reply.refused(request.do, CLOSING, request.id))
        elif request.do in self._felt:
            future.set_result(replace(self._felt[request.do](request), id=request.id))
        else:
            self._waiting.add(future)
            future.add_done_callback(self._waiting.discard)
            self._came.emit(request, future)
        return future

    def answer_line(self, line: str) -> str:
        """Answer a request of this computer's user, received on the window's local socket."""
        try:
            request = parse(line, monotonic())
        except RequestError as error:
            return Reply.refused("", error.notice).as_json()
        if request is None:
            return Reply.refused("", notice("remote.not_request")).as_json()
        do = self._felt.get(request.do, self._do)
        return replace(do(request), id=request.id).as_json(with_folder=True)

    def _act(self, request: Request, future: Future[Reply]) -> None:
        if future.set_running_or_notify_cancel():  # false if the client no longer waits
            future.set_result(replace(self._do(request), id=request.id))

    def _do(self, request: Request) -> Reply:
        actions: dict[str, Callable[[Request], Reply]] = {
            "start": self._start,
            "stop": self._stop,
            "note": self._note,
            "status": self._status,
        }
        return actions[request.do](request)

    def _start(self, request: Request) -> Reply:
        recording, setup = self._host.recording, self._host.setup
        if recording.request is not None:
            file = recording.request.path.name
            return Reply.refused(request.do, notice("remote.recording_already", file=file))
        if setup is None or not self._host.running:
            return Reply.refused(request.do, notice("remote.no_device"))
        if setup.live is None:
            return Reply.refused(request.do, notice("remote.replayed"))
        problems: list[str] = []

        def listen(text: str) -> None:
            problems.append(text)

        self._host.error.connect(listen)
        try:
            self._host.recording.toggle(self._plan.request)
        finally:
            self._host.error.disconnect(listen)
        begun = recording.request
        if begun is None and recording.refusal is not None:
            return Reply.refused(request.do, recording.refusal)
        if begun is None:
            why = plain(" ".join(problems)) if problems else notice("remote.not_begun")
            return Reply.refused(request.do, why)
        return Reply(True, request.do, f"Recording {begun.path.name}.", begun.path)

    def _stop(self, request: Request) -> Reply:
        recording = self._host.recording
        if recording.request is None:
            return Reply.refused(request.do, notice("remote.not_recording"))
        path, elapsed = recording.request.path, recording.elapsed
        recording.end()
        text = f"{path.name} has ended after {duration_text(elapsed)}."
        if recording.closing:
            text += " It is still being written to its end."
        return Reply(True, request.do, text, path, {"duration_s": round(elapsed, 3)})

    def _note(self, request: Request) -> Reply:
        """Add a note, stamped with its arrival time."""
        if self._host.setup is None:
            return Reply.refused(request.do, notice("remote.nothing_open"))
        self._host.notes.add(request.text, request.t, request.data)
        taken = self._host.recording.request
        if taken is None:
            return Reply(True, request.do, "Noted in the log: nothing is being recorded.")
        return Reply(True, request.do, f"Noted in {taken.path.name}.", taken.path)

    def _status(self, request: Request) -> Reply:
        recording = self._host.recording
        more: dict[str, Any] = {
            "running": self._host.running,
            "recording": recording.request is not None,
            "paused": recording.paused,
            "duration_s": round(recording.elapsed, 3),
            **self._tracking(),
        }
        if recording.request is not None:
            path = recording.request.path
            return Reply(True, request.do, f"Recording {path.name}.", path, more)
        text = "Devices are running." if self._host.running else "Nothing is running."
        return Reply(True, request.do, text, None, more)

    def _tracking(self) -> dict[str, str]:
        """State of tracking of each hand, as `tracking_SIDE`."""
        view = self._host.snapshot()
        return {
            f"tracking_{hand.setup.side}": hand.estimate.tracking.name.lower()
            for hand in (view.hands if view is not None else ())
            if hand.estimate is not None
        }

    def _vibrate(self, request: Request) -> Reply:
        """Thread-safe, as the glove's link is."""
        glove = self._glove(request.side)
        if glove is None or not self._host.running:
            return Reply.refused(request.do, notice("remote.no_motors"))
        if not self._motors[request.side, request.finger].take(request.t):
            limit = notice("remote.motor_limit", rate_hz=MOTOR_HZ)
            return Reply.refused(request.do, limit)
        motor = MOTORS.index(request.finger)
        if not glove.vibrate(motor, request.amplitude, request.duration_ms):
            return Reply.refused(request.do, notice("remote.queue_full"))
        return Reply(True, request.do, f"The {request.finger} vibrates.")

    def _glove(self, side: str) -> GloveDevice | None:
        """The glove of the hand of ``side``, or of the first hand; None without motors."""
        setup = self._host.setup
        hands = setup.hands if setup is not None else ()
        found = [hand for hand in hands if side in ("", hand.hand.side)]
        return found[0].connection.device if found else None

    def _contact(self, request: Request) -> Reply:
        """Thread-safe. A contact vibrates while it lasts; its start and end are recorded."""
        setup = self._host.setup
        if setup is None or not self._host.running:
            return Reply.refused(request.do, notice("remote.not_running"))
        if not self._motors[request.side, request.finger].take(request.t):
            limit = notice("remote.contact_limit", rate_hz=MOTOR_HZ)
            return Reply.refused(request.do, limit)
        self._record(self._contacts.tell(request))
        if setup.connection.device is not None:
            strongest = self._contacts.strength(request.finger)
            setup.connection.device.vibrate(MOTORS.index(request.finger), *motor_of(strongest))
        word = "touches" if request.strength > 0 else "lets go of"
        return Reply(True, request.do, f"The {request.finger} {word} {request.object or 'it'}.")

    def _place(self, request: Request) -> Reply:
        """Thread-safe. Passes on the pose of a tracker on a hand."""
        pose, setup = request.data.get("pose"), self._host.setup
        hands = setup.hands if setup is not None and self._host.running else ()
        for hand in hands:
            if isinstance(pose, WristPose) and hand.side == pose.side and hand.live is not None:
                hand.live.hand.place(pose)
                return Reply(True, request.do, "")
        return Reply.refused(request.do, notice("remote.no_side"))

    def _record(self, events: list[Event]) -> None:
        """Add events to the recording, if there is one."""
        setup = self._host.setup
        if setup is not None and setup.live is not None:
            for event in events:
                setup.live.hand.record(event)

    def end(self) -> None:
        """Stop answering, and reply to clients that still wait."""
        self._poll_timer.stop()
        self._ended = True
        for future in list(self._waiting):
            if future.set_running_or_notify_cancel():
                future.set_result(Reply.refused("", CLOSING))


class RemoteControl(Connections[DoorKind[Any], ConnectionSettings]):
    """Opens the servers that are switched on; ``answers`` handles their requests."""

    def __init__(
        self,
        host: EngineHost,
        plan: RecordingPlan,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QObject | None = None,
    ) -> None:
        settings = ConnectionSettings(store.value.remote)
        super().__init__(door_kinds(), settings, store, "remote", parent)
        self._host = host
        self.answers = RemoteAnswers(host, plan, self)
        self._openings: Openings[Door] = Openings(tasks, self.changed.emit)
        self.problems = self._openings.problems
        self.wanted.connect(self._apply)
        self._open_all()

    def use(self, words: str, host: str = "") -> None:
        """Open the servers that the command line requests; stored only if a setting is changed."""
        if words or host:
            self.settings = with_doors(self.settings, words, host)
            self._open_all()

    def counts(self, name: str) -> DoorCounts | None:
        """Statistics of an open server; None if it is not open."""
        door = self._openings.get(name)
        return door.counts() if door is not None else None

    def door(self, name: str) -> Door | None:
        """An open server; None if it is not open."""
        return self._openings.get(name)

    def _open_all(self) -> None:
        for name in self._on():
            self._apply(name)

    def _apply(self, name: str) -> None:
        kind = self.kinds[name]
        make = partial(open_door, kind, self.settings.options(kind), self.answers.answer)
        title = self.tr("Remote control over {}").format(name)
        if self.is_on(name):
            self._openings.renew(name, title, make, self._take)
        else:
            self._openings.close(name, title)
        self.changed.emit()

    def _take(self, door: Door) -> bool:
        words = self.tr("Remote control over {} is open.").format(shown(door.counts().name))
        self._host.happened.emit(Event(0.0, "device", words))
        return True

    def shut_down(self) -> None:
        """Close all servers and reply to clients that still wait. After the last job."""
        self.answers.end()
        self._openings.shut_down()
