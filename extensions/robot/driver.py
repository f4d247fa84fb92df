"""Drives a robot from estimates, and says all that it takes to drive it again from a recording."""

from __future__ import annotations

import threading
from collections.abc import Sequence

from extensions.robot.command import ENGAGE, RELEASE, RobotCommand
from extensions.robot.teleop import Teleop
from extensions.robot.worn import WornHand, worn_hand
from tracker.gestures.recogniser import GestureRecogniser
from tracker.hand.model import HandModel
from tracker.messages import Estimate, Event, RobotMemory, RobotModel, RobotState

KIND = "robot"
MEMORY_EVERY = 0.5  # s of the hand's time: so soon a recording knows what the robot is
Said = RobotModel | RobotState | RobotMemory | Event


class RobotDriver:
    """Fed with one hand's estimates in order; `ask` may be called from any thread."""

    def __init__(
        self, teleop: Teleop, hand: HandModel | None = None, keypoint_names: Sequence[str] = ()
    ) -> None:
        """``hand`` and names of the estimates' rows; none where hands come by `feed_worn`."""
        self.teleop, self._names = teleop, tuple(keypoint_names)
        self._clutch = teleop.settings.clutch
        self._gestures = None
        if self._clutch != "none" and hand is not None:
            self._gestures = GestureRecogniser(hand, self._names)
        self._asked: list[RobotCommand] = []
        self._lock = threading.Lock()
        self._told_at = -1e9  # s
        self.model = teleop.model

    def ask(self, command: RobotCommand) -> None:
        """Have a command done before the next hand. Raises ConfigError where it is none."""
        command.check()
        with self._lock:
            self._asked.append(command)

    def feed(self, estimate: Estimate) -> list[Said]:
        """What an estimate brings, the state last; all but it only now and then."""
        commands = self._commands()
        if self._gestures is not None:
            for phase in self._gestures.feed(estimate):
                if phase.begins and phase.gesture == self._clutch:
                    word = RELEASE if self.teleop.engaged else ENGAGE
                    commands.append(RobotCommand(word))
        return self._step(worn_hand(estimate, self._names), commands)

    def feed_worn(self, worn: WornHand) -> list[Said]:
        """The same of a hand that came by a stream; the clutch's gesture is not looked for."""
        return self._step(worn, self._commands())

    def _commands(self) -> list[RobotCommand]:
        with self._lock:
            asked, self._asked = self._asked, []
        return asked

    def _step(self, worn: WornHand, commands: list[RobotCommand]) -> list[Said]:
        said: list[Said] = []
        for command in commands:
            self.teleop.command(command)
            said.append(command_event(self.model.name, command, worn.t))
        state = self.teleop.feed(worn)
        said.append(state)
        if worn.t - self._told_at >= MEMORY_EVERY or worn.t < self._told_at:
            self._told_at = worn.t
            said += [self.model, self.teleop.memory]
        return said


def command_event(name: str, command: RobotCommand, t: float) -> Event:
    """As sessions have it: done before the hand of ``t``."""
    return Event(t, KIND, "", {"robot": name, "do": command.word, "value": command.value})


def command_of(event: Event, name: str) -> RobotCommand | None:
    """The command that an event tells of; None of another event, or of another robot's."""
    if event.kind != KIND or event.data.get("robot") != name:
        return None
    value = event.data.get("value", 1.0)
    known = isinstance(value, int | float)
    return RobotCommand(str(event.data.get("do")), float(value) if known else 1.0)  # type: ignore[arg-type]
