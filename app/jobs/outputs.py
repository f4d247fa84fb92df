"""The live outputs of the window: which run, on what, and what became of the estimates sent.

Each output is attached to the engine by itself, so that one can be switched without the others.
Opening one resolves names and binds ports, closing one waits for what it is sending: both are
jobs, never the window's own work.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from PySide6.QtCore import QObject, Signal

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsStore, sessions_folder
from tracker.config import from_dict
from tracker.files import free_path
from tracker.messages import Event, Validity
from tracker.streaming.attach import Attachment, attach
from tracker.streaming.haptics import HapticPublisher, Sphere
from tracker.streaming.params import STREAMS, StreamParams, Worn, open_for_hands
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.streams import StreamCounts

HAPTICS = "haptics"
TOUCHING = "index_tip"
_log = logging.getLogger(__name__)
P = TypeVar("P")


@dataclass(frozen=True)
class HapticRule:
    """Fingertips that enter the sphere vibrate. ``center`` in m in G; empty where it has none."""

    on: bool = False
    radius: float = 0.03  # m
    center: tuple[float, ...] = ()


class Outputs(QObject):
    """Follows the session: what is switched on runs while an engine runs."""

    changed = Signal()

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._store, self._tasks = host, store, tasks
        self.params = remembered(StreamParams, store.value.streams)
        self.rule = remembered(HapticRule, store.value.haptics)
        self._attached: dict[str, list[Attachment]] = {}  # one for each hand
        self._fresh: list[list[Publisher]] = []  # open, and not yet attached
        self._wanted: dict[str, int] = {}  # number of the latest wish for each output
        self.problems: dict[str, str] = {}
        host.running_changed.connect(self._follow)
        host.closed.connect(lambda: self._follow(False))

    # --- what the user asks

    def switch(self, name: str, on: bool) -> None:
        """Turn one output on or off, now and after the next start."""
        changes: dict[str, Any] = {name: on}
        self._change(replace(self.params, **changes), [name])

    def use(self, asked: StreamParams) -> None:
        """Turn on what the command line asks for; not remembered unless something is changed."""
        for name in (n for n in STREAMS if getattr(asked, n)):
            port = f"{name}_port"
            changes: dict[str, Any] = {name: True}
            for more in (port, f"{name}_file"):
                if hasattr(asked, more):
                    changes[more] = getattr(asked, more)
            self.params = replace(self.params, **changes)
        if asked.host != StreamParams.host:
            self.params = replace(self.params, host=asked.host)
        if asked.joints != StreamParams.joints:
            self.params = replace(self.params, joints=asked.joints)

    def move(self, host: str) -> None:
        """To or at another address; what runs is opened again there."""
        self._change(replace(self.params, host=host), [n for n in STREAMS if self.is_on(n)])

    def set_joints(self, joints: str) -> None:
        """Send our keypoints or OpenXR's joints; what runs is opened again with them."""
        self._change(replace(self.params, joints=joints), [n for n in STREAMS if self.is_on(n)])

    def set_port(self, name: str, port: int) -> None:
        changes: dict[str, Any] = {f"{name}_port": port}
        self._change(replace(self.params, **changes), [name] if self.is_on(name) else [])

    def set_file(self, path: Path) -> None:
        """Where the Isaac record goes; what is being written ends."""
        self._change(replace(self.params, isaac_file=str(path)), ["isaac"])

    @property
    def isaac_file(self) -> Path:
        """As chosen, or beside the recordings; where it is there already a number is added."""
        usual = sessions_folder(self._store.value) / "hands.mcap"
        return Path(self.params.isaac_file) if self.params.isaac_file else usual

    def _change(self, params: StreamParams, names: Sequence[str]) -> None:
        self.params = params
        self._store.update(streams=asdict(params))
        for name in names:
            self._apply(name)

    def set_rule(self, rule: HapticRule) -> None:
        """Another sphere, or none; one that has no place yet stands at the index fingertip."""
        if rule.on and not rule.center:
            rule = replace(rule, center=self.fingertip())
        if rule.on and not rule.center:
            rule = replace(rule, on=False)
            self._host.error.emit(self.tr("The index fingertip is not seen: there is no place."))
        self.rule = rule
        self._store.update(haptics={**asdict(rule), "center": list(rule.center)})
        self._apply(HAPTICS)

    def fingertip(self) -> tuple[float, ...]:
        """Where the index fingertip is now, m in G; empty where that is not known."""
        setup = self._host.setup
        estimate = setup.tracked.latest_estimate() if setup is not None else None
        if setup is None or estimate is None:
            return ()
        row = setup.glove.keypoint_names(setup.hand).index(TOUCHING)
        if estimate.keypoint_state[row] == Validity.LOST:
            return ()
        return tuple(float(x) for x in estimate.keypoints[row])

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> None:
        """Let one motor run, to feel whether it does."""
        setup = self._host.setup
        if setup is not None and setup.vibrate is not None:
            setup.vibrate(channel, amplitude, duration_ms)

    @property
    def can_vibrate(self) -> bool:
        setup = self._host.setup
        return setup is not None and setup.vibrate is not None and self._host.running

    def is_on(self, name: str) -> bool:
        return self.rule.on if name == HAPTICS else bool(getattr(self.params, name))

    def counts(self, name: str) -> StreamCounts | None:
        """Of an output that runs; None where it does not."""
        attached = self._attached.get(name)
        return attached[0].counts()[0] if attached else None

    # --- opening and closing

    def _follow(self, running: bool) -> None:
        for name in (*STREAMS, HAPTICS):
            if running:
                self._apply(name)
            else:
                self._close(name)

    def _apply(self, name: str) -> None:
        """Close what runs and open it as it is wanted now, where an engine runs."""
        self._close(name)
        setup = self._host.setup
        if not self.is_on(name) or setup is None or not self._host.running:
            return
        if name == HAPTICS and setup.vibrate is None:
            return
        wish = self._wanted[name]

        def opened(publishers: list[Publisher]) -> None:
            self._opened(name, wish, setup, publishers)

        def job(progress: JobProgress) -> list[Publisher]:
            progress(-1.0, name)
            publishers = self._publishers(name, setup)
            self._fresh.append(publishers)
            return publishers

        self._tasks.run(
            self.tr("Opening {}").format(name),
            job,
            done=opened,
            failed=lambda text: self._failed(name, text),
        )

    def _publishers(self, name: str, setup: EngineSetup) -> list[Publisher]:
        """Open one output, of each hand. Raises StreamError in words."""
        if name == HAPTICS:
            sphere = Sphere(np.array(self.rule.center), self.rule.radius)
            return [_haptic(hand, sphere) for hand in setup.hands]
        switches: dict[str, Any] = {n: n == name for n in STREAMS}
        alone = replace(self.params, **switches)
        if name == "isaac":
            self.isaac_file.parent.mkdir(parents=True, exist_ok=True)
            alone = replace(alone, isaac_file=str(free_path(self.isaac_file)))
        return open_for_hands(alone, [Worn(hand.hand, hand.glove) for hand in setup.hands])[0]

    def _opened(
        self, name: str, wish: int, setup: EngineSetup, publishers: list[Publisher]
    ) -> None:
        """Attach them, unless something else is wanted by now, or the window has closed them."""
        if publishers not in self._fresh:
            return
        self._fresh.remove(publishers)
        now = self._host.setup
        if wish != self._wanted[name] or now is None or now.engine is not setup.engine:
            _close_all(publishers)
            return
        self._attached[name] = [
            attach(hand.tracked, [publisher], say=self._say)
            for hand, publisher in zip(setup.hands, publishers, strict=True)
        ]
        self._say(self.tr("The stream {} runs.").format(publishers[0].name))
        self.changed.emit()

    def _failed(self, name: str, text: str) -> None:
        self.problems[name] = text
        self.changed.emit()

    def _close(self, name: str) -> None:
        self._wanted[name] = self._wanted.get(name, 0) + 1
        self.problems.pop(name, None)
        attached = self._attached.pop(name, None)
        if attached is not None:
            title = self.tr("Closing {}").format(name)
            self._tasks.run(title, lambda _progress: _close_all(attached))
        self.changed.emit()

    def _say(self, text: str) -> None:
        """May be called from an output's thread."""
        self._host.happened.emit(Event(0.0, "device", text))

    def shut_down(self) -> None:
        """After the last job: close what one has opened and nobody took."""
        for publishers in self._fresh:
            _close_all(publishers)
        self._fresh.clear()


def _close_all(parts: Sequence[Attachment | Publisher]) -> None:
    for part in parts:
        part.close()


def _haptic(setup: EngineSetup, sphere: Sphere) -> Publisher:
    """A glove without motors feels nothing."""
    vibrate = setup.vibrate or (lambda channel, amplitude, duration_ms: None)
    return HapticPublisher(Names.of(setup.hand, setup.glove), [sphere], vibrate)


def remembered(kind: type[P], data: dict[str, Any]) -> P:
    """Params from what was remembered; what is unknown or of a wrong type keeps its default."""
    return from_dict(kind, data, lambda key, why: _log.info("%s %s", key, why))
