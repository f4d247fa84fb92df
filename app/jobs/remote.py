"""Remote control: what other programs ask is done as if the user had pressed the key.

Requests come in the threads of their doors. All but vibration, which is to be felt at once, are
done in the window's own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from dataclasses import asdict, replace
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from app.engines.engine_host import EngineHost
from app.jobs.outputs import remembered
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan, duration_text
from tracker.clock import monotonic
from tracker.hand.names import CHAINS
from tracker.messages import Event
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.params import DOORS, RemoteParams, open_door, with_doors
from tracker.streaming.remote.reception import Allowance, DoorCounts
from tracker.streaming.remote.request import Reply, Request, RequestError, parse

MOTOR_HZ = 50.0  # commands to one motor; more only fill the glove's line
MOTORS = tuple(CHAINS)
CLOSING = "The window is closing."


class RemoteControl(QObject):
    """Opens the doors that are switched on, and does what comes through them."""

    changed = Signal()
    _came = Signal(object, object)  # Request, and the Future of its Reply

    def __init__(
        self,
        host: EngineHost,
        plan: RecordingPlan,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._plan, self._store, self._tasks = host, plan, store, tasks
        self.params = remembered(RemoteParams, store.value.remote)
        self.problems: dict[str, str] = {}
        self._doors: dict[str, Door] = {}
        self._fresh: list[Door] = []  # open, and not yet taken over
        self._wanted: dict[str, int] = {}  # number of the latest wish for each
        self._waiting: set[Future[Reply]] = set()
        self._motors = {finger: Allowance(MOTOR_HZ, monotonic()) for finger in MOTORS}
        self._ended = False
        self._came.connect(self._act, Qt.ConnectionType.QueuedConnection)
        self._open_all()

    # --- what the user asks

    def switch(self, name: str, on: bool) -> None:
        """Open or close one door, now and after the next start."""
        changes: dict[str, Any] = {name: on}
        self._change(replace(self.params, **changes), [name])

    def use(self, words: str, host: str = "") -> None:
        """Open what the command line asks for; not remembered unless something is changed."""
        if words or host:
            self.params = with_doors(self.params, words, host)
            self._open_all()

    def move(self, host: str) -> None:
        """To another of this computer's addresses; what is open is opened again there."""
        self._change(replace(self.params, host=host), [n for n in DOORS if self.is_on(n)])

    def set_port(self, name: str, port: int) -> None:
        changes: dict[str, Any] = {f"{name}_port": port}
        self._change(replace(self.params, **changes), [name] if self.is_on(name) else [])

    def is_on(self, name: str) -> bool:
        return bool(getattr(self.params, name))

    def counts(self, name: str) -> DoorCounts | None:
        """Of a door that is open; None where it is not."""
        door = self._doors.get(name)
        return door.counts() if door is not None else None

    def _change(self, params: RemoteParams, names: Sequence[str]) -> None:
        self.params = params
        self._store.update(remote=asdict(params))
        for name in names:
            self._apply(name)

    # --- doors

    def _open_all(self) -> None:
        for name in filter(self.is_on, DOORS):
            self._apply(name)

    def _apply(self, name: str) -> None:
        """Close what is open and open it as it is wanted now; both may wait, so they are a job."""
        wish = self._wanted[name] = self._wanted.get(name, 0) + 1
        self.problems.pop(name, None)
        before, params, on = self._doors.pop(name, None), self.params, self.is_on(name)

        def job(progress: JobProgress) -> Door | None:
            progress(-1.0, name)
            if before is not None:
                before.close()
            if not on:
                return None
            door = open_door(name, params, self.answer)
            self._fresh.append(door)
            return door

        title = self.tr("Remote control by {}").format(name)
        done, failed = partial(self._opened, name, wish), partial(self._failed, name)
        self._tasks.run(title, job, done=done, failed=failed)
        self.changed.emit()

    def _opened(self, name: str, wish: int, door: Door | None) -> None:
        if door is None or door not in self._fresh:
            return
        self._fresh.remove(door)
        if wish != self._wanted[name]:
            door.close()
            return
        self._doors[name] = door
        self._say(self.tr("Remote control by {} is open.").format(door.counts().name))
        self.changed.emit()

    def _failed(self, name: str, text: str) -> None:
        self.problems[name] = text
        self.changed.emit()

    def _say(self, text: str) -> None:
        self._host.happened.emit(Event(0.0, "device", text))

    # --- what is asked from outside

    def answer(self, request: Request) -> Future[Reply]:
        """Do it soon, in the window's thread; from any thread."""
        future: Future[Reply] = Future()
        if self._ended:
            future.set_result(Reply(False, request.do, CLOSING, id=request.id))
        elif request.do == "vibrate":
            future.set_result(replace(self._vibrate(request), id=request.id))
        else:
            self._waiting.add(future)
            future.add_done_callback(self._waiting.discard)
            self._came.emit(request, future)
        return future

    def answer_line(self, line: str) -> str:
        """A request of this computer's user, by the window's own local socket."""
        try:
            request = parse(line, monotonic())
        except RequestError as error:
            return Reply(False, "", str(error)).as_json()
        if request is None:
            return Reply(False, "", "That is an answer, not a request.").as_json()
        do = self._vibrate if request.do == "vibrate" else self._do
        return replace(do(request), id=request.id).as_json(with_folder=True)

    def _act(self, request: Request, future: Future[Reply]) -> None:
        if future.set_running_or_notify_cancel():  # nobody waits any more: it is not done
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
            name = recording.request.path.name
            return Reply(False, request.do, f"{name} is being recorded already.")
        if setup is None or not self._host.running:
            return Reply(False, request.do, "Nothing can be recorded: no device is running.")
        if setup.make_recorder is None:
            return Reply(False, request.do, "A session that is replayed cannot be recorded.")
        problems: list[str] = []

        def listen(text: str) -> None:
            problems.append(text)

        self._host.error.connect(listen)
        try:
            self._host.toggle_recording(self._plan.request)
        finally:
            self._host.error.disconnect(listen)
        begun = recording.request
        if begun is None:
            return Reply(False, request.do, " ".join(problems) or "The recording did not begin.")
        return Reply(True, request.do, f"Recording {begun.path.name}.", begun.path)

    def _stop(self, request: Request) -> Reply:
        recording = self._host.recording
        if recording.request is None:
            return Reply(False, request.do, "Nothing is being recorded.")
        path, elapsed = recording.request.path, recording.elapsed
        recording.end()
        text = f"{path.name} has ended after {duration_text(elapsed)}."
        if recording.closing:
            text += " It is still being written to its end."
        return Reply(True, request.do, text, path, {"duration_s": round(elapsed, 3)})

    def _note(self, request: Request) -> Reply:
        """Stamped with its arrival, however busy the window was."""
        if self._host.setup is None:
            return Reply(False, request.do, "There is nothing to note it in: nothing is open.")
        self._host.notes.add(request.text, request.t)
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
        }
        if recording.request is not None:
            path = recording.request.path
            return Reply(True, request.do, f"Recording {path.name}.", path, more)
        text = "Devices are running." if self._host.running else "Nothing is running."
        return Reply(True, request.do, text, None, more)

    def _vibrate(self, request: Request) -> Reply:
        """From any thread, as the glove's link takes it."""
        setup = self._host.setup
        if setup is None or setup.vibrate is None or not self._host.running:
            return Reply(False, request.do, "No glove with motors is running.")
        if not self._motors[request.finger].take(request.t):
            limit = f"A motor takes at most {MOTOR_HZ:.0f} requests a second."
            return Reply(False, request.do, limit)
        setup.vibrate(MOTORS.index(request.finger), request.amplitude, request.duration_ms)
        return Reply(True, request.do, f"The {request.finger} vibrates.")

    def shut_down(self) -> None:
        """Close all doors; who still waits is told. After the last job."""
        self._ended = True
        for future in list(self._waiting):
            if future.set_running_or_notify_cancel():
                future.set_result(Reply(False, "", CLOSING))
        for door in (*self._doors.values(), *self._fresh):
            door.close()
        self._doors.clear()
        self._fresh.clear()
