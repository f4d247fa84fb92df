"""The robot hand that follows: its process, what it says and who is told of it.

A live hand is heard of in the engine's thread, a replayed one with the window's look at it. What
the robot says comes in the thread of its process's pipe: there motors run, states are sent and
recorded, none of which waits; the window takes the latest.
"""

from __future__ import annotations

import json
from collections import deque
from dataclasses import asdict, replace

from PySide6.QtCore import QObject, Qt, Signal

from app.engines.engine import EngineSetup, FollowedHand
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.jobs.connections import remembered
from app.storage.settings import SettingsStore
from extensions.robot.command import ENGAGE, RELEASE, RESET, SCALE, RobotCommand
from extensions.robot.library import need_mujoco
from extensions.robot.payload import state_payload
from extensions.robot.process import Answer, RobotFailed, RobotMoved, RobotProcess, RobotReady
from extensions.robot.settings import RobotSettings, settings_of
from extensions.robot.touch import TouchMotors
from extensions.robot.window.playback import RobotPlayback
from extensions.robot.window.view_model import RobotFigures, RobotView
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.messages import Estimate, RobotModel, RobotState
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.publisher import LOOPBACK

LATENCIES = 500  # the last 5 s


class RobotLink(QObject):
    """One robot at a time, while it is switched on and an engine is open."""

    changed = Signal()
    failed = Signal(str)
    _heard_failure = Signal(str)

    def __init__(
        self, host: EngineHost, store: SettingsStore, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._host, self._store = host, store
        self.settings = remembered(RobotSettings, store.value.robot)
        self.port = store.value.robot_port
        self.on = False
        self.engaged = True
        self.view: RobotView | None = None
        """What there is to draw; None before the robot is there."""
        self._process: RobotProcess | None = None
        self._followed: FollowedHand | None = None
        self._playback: RobotPlayback | None = None
        self._model: RobotModel | None = None
        self._touch: TouchMotors | None = None
        self._socket: DatagramSocket | None = None
        self._took: deque[float] = deque(maxlen=LATENCIES)
        self._shown_t = -1.0
        host.opened.connect(lambda _setup: self._follow())
        host.closed.connect(self.shut_down)
        host.running_changed.connect(lambda on: self._follow() if on else None)
        host.hand_changed.connect(lambda _setup: self._change_hand())
        self._heard_failure.connect(self._fail, Qt.ConnectionType.QueuedConnection)

    # --- what the user asks

    def switch(self, on: bool) -> None:
        """Let a robot follow, or none."""
        self.on = on
        if on:
            self._follow()
        else:
            self.shut_down()
        self.changed.emit()

    def change(self, **changes: object) -> None:
        """Another setting, now and after the next start; what runs begins anew with it.

        Raises ConfigError.
        """
        self.settings = replace(self.settings, **changes)  # type: ignore[arg-type]
        self._store.update(robot=asdict(self.settings))
        if self._process is not None:
            self.shut_down()
            self._follow()
        self.changed.emit()

    def scale(self, value: float) -> None:
        """Of the palm's motion, at once. Raises ConfigError."""
        self.settings = replace(self.settings, motion_scale=value)
        self._store.update(robot=asdict(self.settings))
        self._ask(RobotCommand(SCALE, value))

    def engage(self, on: bool) -> None:
        """The clutch."""
        self._ask(RobotCommand(ENGAGE if on else RELEASE))

    def reset(self) -> None:
        """Robot and things to where they began."""
        self._ask(RobotCommand(RESET))

    def send_to(self, port: int) -> None:
        """Send states by UDP to a port of this computer, 0: to none."""
        self.port = port
        self._store.update(robot_port=port)
        self._open_socket()

    def _ask(self, command: RobotCommand) -> None:
        if self._process is not None and self._playback is None:
            self._process.ask(command)

    @property
    def replays(self) -> bool:
        """Whether the robot that is shown is a recorded one."""
        return self._playback is not None

    @property
    def figures(self) -> RobotFigures:
        """How it does."""
        view, process = self.view, self._process
        missed = process.missed if process is not None else 0
        return RobotFigures.of(self.on, view, list(self._took), missed, self.replays)

    # --- its life

    def _follow(self) -> None:
        """Begin, where it is wanted and there is a hand to follow."""
        setup = self._host.setup
        if not self.on or setup is None:
            return
        if self._process is None:
            self._begin(setup)
        if setup.followed is not None and self._process is not None:
            self._followed = setup.followed
            self._followed.follow(self._process.feed)

    def _change_hand(self) -> None:
        """A robot of the other side for the hand that is shown now."""
        if self.on:
            self.shut_down()
            self._follow()

    def _begin(self, setup: EngineSetup) -> None:
        try:
            need_mujoco()
            player = setup.player
            self._playback = RobotPlayback.of(player.path) if player is not None else None
            settings = replace(self.settings, side=setup.hand.side)
            if self._playback is not None:
                settings = settings_of(self._playback.model.settings)
            names = setup.glove.keypoint_names(setup.hand)
            self._open_socket()
            self._touch = TouchMotors(setup.vibrate) if setup.vibrate is not None else None
            self._process = RobotProcess(settings, setup.hand, names, self._heard)
        except GlovetrackError as error:
            self._fail(str(error))

    def _open_socket(self) -> None:
        before, self._socket = self._socket, None
        if before is not None:
            before.close()
        if self.port and self.on:
            self._socket = DatagramSocket("robot", LOOPBACK, self.port)

    def shut_down(self) -> None:
        """The robot goes, if there is one; so it does before the window."""
        process, self._process = self._process, None
        followed, self._followed = self._followed, None
        if followed is not None:
            followed.follow(None)
        if process is not None:
            process.close()
        playback, self._playback = self._playback, None
        if playback is not None:
            playback.close()
        if self._socket is not None:
            self._socket.close()
            self._socket = None
        self.view = self._model = None
        self._took.clear()
        self._shown_t = -1.0
        self.changed.emit()

    def _fail(self, text: str) -> None:
        self.on = False
        self.shut_down()
        self.failed.emit(text)

    # --- a hand that is replayed

    def look(self, view: Snapshot | None) -> None:
        """With each look of the window: a replay tells its hand so."""
        process = self._process
        if process is None or view is None or view.setup.followed is not None:
            return
        estimate = view.estimate
        if estimate is None or estimate.t == self._shown_t:
            return
        self._shown_t = estimate.t
        shown: Estimate | RobotState | None = estimate
        if self._playback is not None:
            try:
                shown = self._playback.at(estimate.t)
            except GlovetrackError as error:  # the file is damaged here
                self._fail(str(error))
                return
        if shown is not None:
            process.feed(shown, 0.0)

    # --- what it says, in the thread of its pipe

    def _heard(self, answer: Answer, took: float) -> None:
        if isinstance(answer, RobotFailed):
            self._heard_failure.emit(answer.text)
        elif isinstance(answer, RobotReady):
            self._model = answer.model
            self.view = RobotView(answer.shape, answer.model)
        elif isinstance(answer, RobotMoved):
            self._took.append(took)
            self._tell(answer)
        elif self.view is not None:
            self.view.show(answer.state, answer.placed, float("nan"))

    def _tell(self, moved: RobotMoved) -> None:
        followed = self._followed
        for said in moved.said:
            message = said
            if isinstance(said, RobotState):
                self._act(said)
                message = replace(said, t_told=monotonic())
                self.engaged = said.engaged
                if self.view is not None:
                    self.view.show(said, moved.placed, moved.error)
            if followed is not None:
                followed.record(message)

    def _act(self, state: RobotState) -> None:
        """Motors and streams."""
        if self._touch is not None:
            self._touch.feel(state.t, state.force)
        out, model = self._socket, self._model
        if out is not None and model is not None:
            said = state_payload(state, model.joint_names, model.objects)
            try:
                out.send(json.dumps(said, separators=(",", ":")).encode())
            except OSError:
                return  # nobody there, or no room: the next one is newer
