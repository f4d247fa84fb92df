"""A robot in a process of its own, so that tracking and window never wait for it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, NamedTuple

from extensions.robot.command import RobotCommand
from extensions.robot.settings import RobotSettings
from tracker.base.child import start_child
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.base.urgency import run_soon
from tracker.hand.model import HandModel
from tracker.messages import Estimate, RobotModel, RobotState

if TYPE_CHECKING:
    from extensions.robot.driver import Said
    from extensions.robot.look import Placed, RobotShape

END_WAIT = 2.0  # s
STARTING = 0.0  # in place of a time of arrival: the process is not there yet


@dataclass(frozen=True)
class RobotReady:
    """The robot is there, and looks so."""

    model: RobotModel
    shape: RobotShape


@dataclass(frozen=True)
class RobotFailed:
    """It is not, or no more; ``text`` says why."""

    text: str


class RobotMoved(NamedTuple):
    """What one hand brought: all that was said, and where everything is; the farthest tip's way to
    its target, m."""

    said: list[Said]
    placed: Placed
    error: float


class RobotShown(NamedTuple):
    """Where everything is in a recorded state."""

    state: RobotState
    placed: Placed


Answer = RobotReady | RobotFailed | RobotMoved | RobotShown
Item = Estimate | RobotCommand | RobotState | None


class RobotProcess:
    """Methods may be called from any thread and never wait; ``heard`` is called in a thread of its
    own with each `Answer`, and with the s from a hand's arrival to it (0 where there is none)."""

    def __init__(
        self,
        settings: RobotSettings,
        hand: HandModel,
        keypoint_names: tuple[str, ...],
        heard: Callable[[Answer, float], None],
    ) -> None:
        self._heard = heard
        name = "glovetrack-robot"
        self._pipe, self._process = start_child(name, serve, settings, hand, keypoint_names)
        self._lock = threading.Lock()
        self._latest: tuple[Estimate | RobotState, float] | None = None
        self._arrival: float | None = STARTING  # of what was sent and not answered
        self._ending = False
        self.missed = 0
        """Hands that were overtaken by a newer one."""
        self._thread = threading.Thread(target=self._receive, name="glovetrack-robot", daemon=True)
        self._thread.start()

    @property
    def pid(self) -> int:
        return self._process.pid or 0

    def feed(self, hand: Estimate | RobotState, t_arrival: float) -> None:
        """The newest hand, or a recorded state to be shown; it came at ``t_arrival`` s.

        It is sent from here, not by a thread of its own that would wait for its turn. One is under
        way at a time, which the pipe always has room for.
        """
        with self._lock:
            self.missed += self._latest is not None
            self._latest = hand, t_arrival
            self._send_latest()

    def ask(self, command: RobotCommand) -> None:
        """Have a command done before the next hand."""
        with self._lock:
            self._send(command)

    def close(self) -> None:
        """End the process; waits until it has ended. May be called again."""
        with self._lock:
            if not self._ending:
                self._ending = True
                self._send(None)
                if self._arrival == STARTING:  # it would hear that in some seconds
                    self._process.kill()
        if self._thread is not threading.current_thread():
            self._thread.join(END_WAIT)
        self._process.join(END_WAIT)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()
        self._pipe.close()

    def _send_latest(self) -> None:
        if self._latest is not None and self._arrival is None:
            (hand, self._arrival), self._latest = self._latest, None
            self._send(hand)

    def _send(self, item: Item) -> None:
        with suppress(OSError):  # it has gone: who receives tells
            self._pipe.send(item)

    def _receive(self) -> None:
        run_soon()
        while True:
            try:
                answer = self._pipe.recv()
            except (EOFError, OSError):
                if not self._ending:
                    self._heard(RobotFailed("The robot's process has ended."), 0.0)
                return
            self._heard(answer, self._answered(answer))

    def _answered(self, answer: Answer) -> float:
        """s since the hand came that is answered; the next one may go."""
        if isinstance(answer, RobotFailed):
            return 0.0
        with self._lock:
            arrival, self._arrival = self._arrival, None
            self._send_latest()
        return monotonic() - arrival if arrival else 0.0


def serve(
    pipe: Connection, settings: RobotSettings, hand: HandModel, keypoint_names: tuple[str, ...]
) -> None:
    """Runs in the process until it is told to end, or who began it has gone."""
    run_soon()
    try:
        server = _Server(settings, hand, keypoint_names)
    except GlovetrackError as error:
        pipe.send(RobotFailed(str(error)))
        return
    with suppress(EOFError, OSError, KeyboardInterrupt):
        pipe.send(server.ready)
        while True:
            item: Item = pipe.recv()
            if item is None:
                return
            answer = server.do(item)
            if answer is not None:
                pipe.send(answer)


class _Server:
    """The robot itself."""

    def __init__(
        self, settings: RobotSettings, hand: HandModel, keypoint_names: tuple[str, ...]
    ) -> None:
        from extensions.robot.driver import RobotDriver
        from extensions.robot.shape import shape_of
        from extensions.robot.teleop import Teleop

        self._driver = RobotDriver(Teleop(settings), hand, keypoint_names)
        self._world = self._driver.teleop.world
        self.ready = RobotReady(self._driver.model, shape_of(self._world))

    def do(self, item: Estimate | RobotCommand | RobotState) -> Answer | None:
        import numpy as np

        from extensions.robot.shape import poses

        if isinstance(item, RobotCommand):
            try:
                self._driver.ask(item)
            except GlovetrackError as error:
                return RobotFailed(str(error))
            return None
        if isinstance(item, RobotState):
            try:
                self._world.show(item.joints, item.palm, item.objects)
            except ValueError:
                return RobotFailed("The recorded robot is another one than its model says.")
            return RobotShown(item, poses(self._world))
        said = self._driver.feed(item)
        errors = self._driver.teleop.fingers.error
        farthest = float(np.nanmax(errors)) if np.isfinite(errors).any() else float("nan")
        return RobotMoved(said, poses(self._world), farthest)
