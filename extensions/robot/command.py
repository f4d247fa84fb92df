"""Commands to a robot while it runs."""

from __future__ import annotations

from typing import NamedTuple

from extensions.robot.settings import RobotSettings
from tracker.base.errors import ConfigError
from tracker.base.notices import notice

ENGAGE, RELEASE, RESET, SCALE = COMMANDS = ("engage", "release", "reset", "scale")


class RobotCommand(NamedTuple):
    """A user's command: one of `COMMANDS`; ``value`` is the factor of a scale command."""

    word: str
    value: float = 1.0

    def check(self) -> None:
        """Raises ConfigError for an unknown command."""
        if self.word not in COMMANDS:
            raise ConfigError(notice("robot.command", command=self.word, known=COMMANDS))
        if self.word == SCALE:
            RobotSettings(motion_scale=self.value)
