"""Runs the robot in a process of its own, so that tracking and the window never wait for it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from extensions.robot.command import RobotCommand
from extensions.robot.settings import RobotSettings
from tracker.base.child import start_child
from tracker.base.clock import monotonic
from tracker.base.notices import Notice, failure
from tracker.base.registry import deferred
from tracker.base.urgency import run_soon
from tracker.hand.model import HandModel
from tracker.messages import Estimate, RobotModel, RobotState

if TYPE_CHECKING:
    from extensions.robot.driver import RobotOutput
    from extensions.robot.look import Placed, RobotShape

END_WAIT = 2.0  # s
STARTING = 0.0  # instead of an arrival time while the process starts


@dataclass(frozen=True)
class RobotReady:
    """The robot has started; its description and its shape."""

    model: RobotModel
    shape: RobotShape


@dataclass(frozen=True)
class RobotFailed:
    """The robot did not start or has stopped."""

    why: Notice


class RobotMoved(NamedTuple):
    """The result of one hand: the driver's outputs, the poses of all bodies, and the largest
    distance of a tip from its target in m."""

    outputs: list[RobotOutput]
    placed: Placed
    error: float


class RobotShown(NamedTuple):
    """The poses of all bodies in a recorded state."""

    state: RobotState
    placed: Placed


Answer = RobotReady | RobotFailed | RobotMoved | RobotShown
Item = Estimate | RobotCommand | RobotState | None


class RobotProcess:
    """Methods may be called from any thread and do not block.

    ``deliver`` is called in a separate thread with each `Answer` and the time in s since the
    arrival of the hand that it answers (0 if it answers none).
    """

    def __init__(
        self,
        settings: RobotSettings,
        hand: HandModel,
        keypoint_names: tuple[str, ...],
        deliver: Callable[[Answer, float], None],
    ) -> None:
        self._deliver = deliver
        name = "glovetrack-robot"
        self._pipe, self._process = start_child(
            name, deferred("extensions.robot.server:serve"), settings, hand, keypoint_names
        )
        self._lock = threading.Lock()
        self._latest: tuple[Estimate | RobotState, float] | None = None
        self._arrival: float | None = STARTING  # of the item that awaits an answer
        self._ending = False
        self.missed = 0
        """Number of hands that were replaced by a newer one before they were sent."""
        self._thread = threading.Thread(target=self._read, name="glovetrack-robot", daemon=True)
        self._thread.start()

    @property
    def pid(self) -> int:
        return self._process.pid or 0

    def feed(self, hand: Estimate | RobotState, t_arrival: float) -> None:
        """Send the newest hand, or a recorded state to show, which arrived at ``t_arrival`` s.

        It is sent in the caller's thread, because another thread would have to wait for its turn.
        Only one item awaits an answer at a time, so the pipe never blocks.
        """
        with self._lock:
            self.missed += self._latest is not None
            self._latest = hand, t_arrival
            self._send_latest()

    def ask(self, command: RobotCommand) -> None:
        """Queue a command for execution before the next hand."""
        with self._lock:
            self._send(command)

    def close(self) -> None:
        """Stop the process and wait until it has ended. Later calls do nothing."""
        with self._lock:
            if not self._ending:
                self._ending = True
                self._send(None)
                if self._arrival == STARTING:  # it would read the request only after its start
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
        with suppress(OSError):  # the process has ended, which `_read` reports
            self._pipe.send(item)

    def _read(self) -> None:
        run_soon()
        while True:
            try:
                answer = self._pipe.recv()
            except (EOFError, OSError):
                if not self._ending:
                    self._deliver(RobotFailed(failure("robot.process_ended")), 0.0)
                return
            self._deliver(answer, self._answered(answer))

    def _answered(self, answer: Answer) -> float:
        """s since the arrival of the answered hand; sends the next one."""
        if isinstance(answer, RobotFailed):
            return 0.0
        with self._lock:
            arrival, self._arrival = self._arrival, None
            self._send_latest()
        return monotonic() - arrival if arrival else 0.0
