"""Drives a robot from estimates; returns everything needed to repeat that from a recording."""

from __future__ import annotations

import threading
from collections.abc import Sequence

from extensions.robot.command import ENGAGE, RELEASE, RobotCommand
from extensions.robot.teleop import Teleop
from extensions.robot.wearer_hand import WearerHand, hand_from_estimate
from tracker.gestures.recogniser import GestureRecogniser
from tracker.hand.model import HandModel
from tracker.messages import Estimate, Event, RobotMemory, RobotModel, RobotState

KIND = "robot"
MEMORY_EVERY = 0.5  # s of the hand's time between stored states: a recording may start in between
RobotOutput = RobotModel | RobotState | RobotMemory | Event
"""What a driver returns, for recordings."""


class RobotDriver:
    """Takes the estimates of one hand in order; `ask` may be called from any thread."""

    def __init__(
        self, teleop: Teleop, hand: HandModel | None = None, keypoint_names: Sequence[str] = ()
    ) -> None:
        """``hand`` and the names of the estimates' rows; not needed with `feed_hand`."""
        self.teleop, self._names = teleop, tuple(keypoint_names)
        self._clutch = teleop.settings.clutch
        self._gestures = None
        if self._clutch != "none" and hand is not None:
            self._gestures = GestureRecogniser(hand, self._names)
        self._asked: list[RobotCommand] = []
        self._lock = threading.Lock()
        self._sent_at = -1e9  # s
        self.model = teleop.model

    def ask(self, command: RobotCommand) -> None:
        """Queue a command for execution before the next hand. Raises ConfigError if unknown."""
        command.check()
        with self._lock:
            self._asked.append(command)

    def feed(self, estimate: Estimate) -> list[RobotOutput]:
        """Messages caused by an estimate. The state is the last; the others are occasional."""
        commands = self._commands()
        if self._gestures is not None:
            for phase in self._gestures.feed(estimate):
                if phase.begins and phase.gesture == self._clutch:
                    word = RELEASE if self.teleop.engaged else ENGAGE
                    commands.append(RobotCommand(word))
        return self._step(hand_from_estimate(estimate, self._names), commands)

    def feed_hand(self, wearer: WearerHand) -> list[RobotOutput]:
        """Like `feed`, for a hand from a stream; the clutch's gesture is not recognised."""
        return self._step(wearer, self._commands())

    def _commands(self) -> list[RobotCommand]:
        with self._lock:
            asked, self._asked = self._asked, []
        return asked

    def _step(self, wearer: WearerHand, commands: list[RobotCommand]) -> list[RobotOutput]:
        outputs: list[RobotOutput] = []
        for command in commands:
            self.teleop.command(command)
            outputs.append(command_event(self.model.name, command, wearer.t))
        state = self.teleop.feed(wearer)
        outputs.append(state)
        if wearer.t - self._sent_at >= MEMORY_EVERY or wearer.t < self._sent_at:
            self._sent_at = wearer.t
            outputs += [self.model, self.teleop.memory]
        return outputs


def command_event(name: str, command: RobotCommand, t: float) -> Event:
    """The event for sessions: the command was executed before the hand of time ``t``."""
    return Event(t, KIND, "", {"robot": name, "do": command.word, "value": command.value})


def command_of(event: Event, name: str) -> RobotCommand | None:
    """The command that an event records; None for other events and other robots."""
    if event.kind != KIND or event.data.get("robot") != name:
        return None
    value = event.data.get("value", 1.0)
    known = isinstance(value, int | float)
    return RobotCommand(str(event.data.get("do")), float(value) if known else 1.0)  # type: ignore[arg-type]
