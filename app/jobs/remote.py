"""Remote control: the doors by which other programs ask, opened and closed as the user wants."""

from __future__ import annotations

from functools import partial
from typing import Any

from PySide6.QtCore import QObject

from app.engines.engine_host import EngineHost
from app.jobs.connections import Connections
from app.jobs.openings import Openings
from app.jobs.remote_answers import RemoteAnswers
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan
from tracker.messages import Event
from tracker.streaming.connection import ConnectionSettings
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import DoorCounts
from tracker.streaming.remote.registry import DoorKind, door_kinds, open_door, with_doors


class RemoteControl(Connections[DoorKind[Any], ConnectionSettings]):
    """Opens the doors that are switched on; ``answers`` does what comes through them."""

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
        """Open what the command line asks for; not remembered unless something is changed."""
        if words or host:
            self.settings = with_doors(self.settings, words, host)
            self._open_all()

    def counts(self, name: str) -> DoorCounts | None:
        """Of a door that is open; None where it is not."""
        door = self._openings.get(name)
        return door.counts() if door is not None else None

    def _open_all(self) -> None:
        for name in self._on():
            self._apply(name)

    def _apply(self, name: str) -> None:
        kind = self.kinds[name]
        make = partial(open_door, kind, self.settings.options(kind), self.answers.answer)
        title = self.tr("Remote control by {}").format(name)
        self._openings.renew(name, title, make if self.is_on(name) else None, self._take)

    def _take(self, door: Door) -> bool:
        words = self.tr("Remote control by {} is open.").format(door.counts().name)
        self._host.happened.emit(Event(0.0, "device", words))
        return True

    def shut_down(self) -> None:
        """Close all doors; who still waits is told. After the last job."""
        self.answers.end()
        self._openings.shut_down()
