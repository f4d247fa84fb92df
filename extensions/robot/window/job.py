"""The robot hand of the window: its process and the recipients of its states.

Estimates of a live hand arrive in the engine's thread, those of a replayed hand when the window
refreshes. The robot's answers arrive in the thread that reads its pipe; there motors are driven and
states are sent and recorded without blocking. The window shows the latest state.
"""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal

from app.engines.engine import EngineSetup
from app.engines.host_parts import CurrentEngine, HandChanges, RunState
from app.engines.protocols import CommandedHand
from app.engines.snapshot import Snapshot
from app.jobs.connections import remembered
from app.storage.settings import SettingsOf
from app.words import error_text, notice_text
from extensions.robot.command import ENGAGE, RELEASE, RESET, SCALE, RobotCommand
from extensions.robot.library import need_mujoco
from extensions.robot.payload import state_payload
from extensions.robot.process import Answer, RobotFailed, RobotMoved, RobotProcess, RobotReady
from extensions.robot.settings import RobotSettings, settings_of
from extensions.robot.window.view_model import RobotFigures, RobotView
from tracker.base.clock import monotonic
from tracker.base.errors import FileError, GlovetrackError
from tracker.messages import Array, Estimate, RobotModel, RobotState
from tracker.session.decode_robot import read_robot, robot_model, robot_names
from tracker.session.reader import SessionReader
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.publisher import LOOPBACK

LATENCIES = 500  # the last 5 s


class RobotHost(CurrentEngine, HandChanges, RunState, Protocol):
    """What the connection uses of the engine host."""


class StoredRobot(Protocol):
    """The settings of the robot hand that the window stores."""

    @property
    def robot(self) -> dict[str, Any]: ...

    @property
    def robot_fingers(self) -> dict[str, Any]: ...

    @property
    def robot_port(self) -> int: ...


class RobotLink(QObject):
    """Runs one robot while it is switched on and an engine is open."""

    changed = Signal()
    failed = Signal(str)
    _failure_received = Signal(str)

    def __init__(
        self, host: RobotHost, store: SettingsOf[StoredRobot], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._host, self._store = host, store
        self.settings = remembered(RobotSettings, store.value.robot)
        self.port = store.value.robot_port
        self.on = False
        self.engaged = True
        self.view: RobotView | None = None
        """What to draw; None before the robot has started."""
        self._process: RobotProcess | None = None
        self._followed: CommandedHand | None = None
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
        self._failure_received.connect(self._fail, Qt.ConnectionType.QueuedConnection)

    # --- commands of the user

    def switch(self, on: bool) -> None:
        """Start or stop the robot."""
        self.on = on
        if on:
            self._follow()
        else:
            self.shut_down()
        self.changed.emit()

    def change(self, **changes: object) -> None:
        """Change and store settings; a running robot restarts with them. Links of fingers are
        stored for each robot hand. Raises ConfigError."""
        stored = self._store.value.robot_fingers
        if "model" in changes:
            changes = {"fingers": stored.get(str(changes["model"]), ""), **changes}
        self.settings = replace(self.settings, **changes)  # type: ignore[arg-type]
        fingers = {**stored, self.settings.model: self.settings.fingers}
        self._store.update(robot=asdict(self.settings), robot_fingers=fingers)
        if self._process is not None:
            self.shut_down()
            self._follow()
        self.changed.emit()

    def scale(self, value: float) -> None:
        """Set the scale of the palm's motion, effective immediately. Raises ConfigError."""
        self.settings = replace(self.settings, motion_scale=value)
        self._store.update(robot=asdict(self.settings))
        self._ask(RobotCommand(SCALE, value))

    def engage(self, on: bool) -> None:
        """Engage or release the clutch."""
        self._ask(RobotCommand(ENGAGE if on else RELEASE))

    def reset(self) -> None:
        """Return the robot and the objects to their initial poses."""
        self._ask(RobotCommand(RESET))

    def send_to(self, port: int) -> None:
        """Send states by UDP to a port of this computer; 0 switches that off."""
        self.port = port
        self._store.update(robot_port=port)
        self._open_socket()

    def _ask(self, command: RobotCommand) -> None:
        if self._process is not None and self._playback is None:
            self._process.ask(command)

    @property
    def replays(self) -> bool:
        """Whether the robot on screen is a recorded one."""
        return self._playback is not None

    @property
    def figures(self) -> RobotFigures:
        """The robot's status for the panel."""
        view, process = self.view, self._process
        missed = process.missed if process is not None else 0
        return RobotFigures.of(self.on, view, list(self._took), missed, self.replays)

    # --- start and stop

    def _follow(self) -> None:
        """Start following if the robot is switched on and there is a hand."""
        setup = self._host.setup
        if not self.on or setup is None:
            return
        if self._process is None:
            self._begin(setup)
        if setup.live is not None and self._process is not None:
            self._followed = setup.live.hand
            self._followed.follow(self._process.feed)

    def _change_hand(self) -> None:
        """Restart with the side of the hand that is shown now."""
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
            glove = setup.connection.device
            self._touch = TouchMotors(glove.vibrate) if glove is not None else None
            self._process = RobotProcess(settings, setup.hand, names, self._receive)
        except GlovetrackError as error:
            self._fail(error_text(error))

    def _open_socket(self) -> None:
        before, self._socket = self._socket, None
        if before is not None:
            before.close()
        if self.port and self.on:
            self._socket = DatagramSocket("robot", LOOPBACK, self.port)

    def shut_down(self) -> None:
        """Stop the robot, if any; called before the window closes."""
        process, self._process = self._process, None
        followed, self._followed = self._followed, None
        if followed is not None:
            followed.unfollow()
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

    # --- a replayed hand

    def look(self, view: Snapshot | None) -> None:
        """Feed the hand of a replay; called at each refresh of the window."""
        process = self._process
        if process is None or view is None or view.setup.live is not None:
            return
        estimate = view.estimate
        if estimate is None or estimate.t == self._shown_t:
            return
        self._shown_t = estimate.t
        shown: Estimate | RobotState | None = estimate
        if self._playback is not None:
            try:
                shown = self._playback.at(estimate.t)
            except GlovetrackError as error:  # the file is damaged at this position
                self._fail(error_text(error))
                return
        if shown is not None:
            process.feed(shown, 0.0)

    # --- answers of the robot, in the thread that reads its pipe

    def _receive(self, answer: Answer, took: float) -> None:
        if isinstance(answer, RobotFailed):
            self._failure_received.emit(notice_text(answer.why))
        elif isinstance(answer, RobotReady):
            self._model = answer.model
            self.view = RobotView(answer.shape, answer.model)
        elif isinstance(answer, RobotMoved):
            self._took.append(took)
            self._distribute(answer)
        elif self.view is not None:
            self.view.show(answer.state, answer.placed, float("nan"))

    def _distribute(self, moved: RobotMoved) -> None:
        followed = self._followed
        for output in moved.outputs:
            message = output
            if isinstance(output, RobotState):
                self._act(output)
                message = replace(output, t_sent=monotonic())
                self.engaged = output.engaged
                if self.view is not None:
                    self.view.show(output, moved.placed, moved.error)
            if followed is not None:
                followed.record(message)

    def _act(self, state: RobotState) -> None:
        """Drive the motors and send the state."""
        if self._touch is not None:
            self._touch.feel(state.t, state.force)
        out, model = self._socket, self._model
        if out is not None and model is not None:
            payload = state_payload(state, model.joint_names, model.objects)
            try:
                out.send(json.dumps(payload, separators=(",", ":")).encode())
            except OSError:
                return  # no receiver or a full buffer: the next state is newer anyway


# ---- haptic feedback: forces on the robot's fingertips become commands to the glove's motors

AGAIN = 0.05  # s between commands to a motor while a tip presses
LASTS_MS = 80  # longer than `AGAIN`, so that a motor does not pause while a tip presses
LEAST_FORCE, MOST_FORCE = 0.1, 8.0  # N: threshold and full amplitude
LEAST, MOST = 60, 255  # amplitudes at which a motor starts to turn and turns fastest
SUDDEN = 1.5  # times the last force: sent at once

Vibrate = Callable[[int, int, int], object]
"""Takes the motor's channel (thumb 0), amplitude 0..255 and duration in ms."""


class TouchMotors:
    """Sends fingertip forces to motors, at most 20 times a second each unless a force grows."""

    def __init__(self, vibrate: Vibrate) -> None:
        self._vibrate = vibrate
        self._sent_at = np.full(5, -np.inf)
        self._sent = np.zeros(5)

    def feel(self, t: float, force: Array) -> None:
        """Take the forces (5,) N at ``t`` s, thumb first."""
        for channel, newton in enumerate(force):
            if newton < LEAST_FORCE:
                self._sent[channel] = 0.0
                continue
            grew = newton > SUDDEN * self._sent[channel]
            if grew or t - self._sent_at[channel] >= AGAIN or t < self._sent_at[channel]:
                self._sent_at[channel], self._sent[channel] = t, newton
                self._vibrate(channel, amplitude(float(newton)), LASTS_MS)


def amplitude(newton: float) -> int:
    """Amplitude of a force. It grows with the square root, as the sensation does (Stevens)."""
    share = min(max(newton - LEAST_FORCE, 0.0) / (MOST_FORCE - LEAST_FORCE), 1.0)
    return round(LEAST + (MOST - LEAST) * share**0.5)


# ---- states of the recorded robot of a replayed session, for the instant that is shown

LEAD = 0.1  # s before the instant at which reading starts
JUMP = 2.0  # s: for larger steps ahead the reader seeks instead of reading on
SAME = 1e-6  # s


class RobotPlayback:
    """Reads the first robot of a session; fast for successive instants."""

    def __init__(self, reader: SessionReader, name: str) -> None:
        self._reader, self._name = reader, name
        self.model: RobotModel = robot_model(reader, name)
        self._coming: Iterator[RobotState] = iter(())
        self._last: RobotState | None = None
        self._next: RobotState | None = None
        self._t = float("inf")

    @staticmethod
    def of(path: Path) -> RobotPlayback | None:
        """None if the session has no robot or does not describe it."""
        reader = SessionReader(path)
        try:
            names = robot_names(reader)
            if names:
                return RobotPlayback(reader, names[0])
        except FileError:
            reader.close()
            return None
        reader.close()
        return None

    def at(self, t: float) -> RobotState | None:
        """The last state at or before ``t`` s; None before the first."""
        if not self._t <= t < self._t + JUMP:
            found = read_robot(self._reader, self._name, t - LEAD)
            self._coming = (m for m in found if isinstance(m, RobotState))
            self._last, self._next = None, next(self._coming, None)
        self._t = t
        while self._next is not None and self._next.t <= t + SAME:
            self._last, self._next = self._next, next(self._coming, None)
        return self._last

    def close(self) -> None:
        self._reader.close()
