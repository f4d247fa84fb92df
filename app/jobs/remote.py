"""Remote control: the doors by which other programs ask, opened and closed as the user wants."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.engines.engine_host import EngineHost
from app.jobs.outputs import remembered
from app.jobs.remote_answers import RemoteAnswers
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan
from tracker.messages import Event
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.params import DOORS, RemoteParams, open_door, with_doors
from tracker.streaming.remote.reception import DoorCounts


class RemoteControl(QObject):
    """Opens the doors that are switched on; ``answers`` does what comes through them."""

    changed = Signal()

    def __init__(
        self,
        host: EngineHost,
        plan: RecordingPlan,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._store, self._tasks = host, store, tasks
        self.answers = RemoteAnswers(host, plan, self)
        self.params = remembered(RemoteParams, store.value.remote)
        self.problems: dict[str, str] = {}
        self._doors: dict[str, Door] = {}
        self._fresh: list[Door] = []  # open, and not yet taken over
        self._wanted: dict[str, int] = {}  # number of the latest wish for each
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
            door = open_door(name, params, self.answers.answer)
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

    def shut_down(self) -> None:
        """Close all doors; who still waits is told. After the last job."""
        self.answers.end()
        for door in (*self._doors.values(), *self._fresh):
            door.close()
        self._doors.clear()
        self._fresh.clear()
