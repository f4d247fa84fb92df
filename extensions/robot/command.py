"""What may be asked of a robot while it follows."""

from __future__ import annotations

from typing import NamedTuple

from extensions.robot.settings import RobotSettings
from tracker.base.errors import ConfigError

ENGAGE, RELEASE, RESET, SCALE = COMMANDS = ("engage", "release", "reset", "scale")


class RobotCommand(NamedTuple):
    """What a user asks of a robot: one of `COMMANDS`; ``value`` is that of a scale."""

    word: str
    value: float = 1.0

    def check(self) -> None:
        """Raises ConfigError for what is not known."""
        if self.word not in COMMANDS:
            raise ConfigError(f"A robot is asked {', '.join(COMMANDS)}, not {self.word!r}.")
        if self.word == SCALE:
            RobotSettings(motion_scale=self.value)
