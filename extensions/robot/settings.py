"""What can be chosen of a robot hand."""

from __future__ import annotations

import json
from dataclasses import dataclass

from extensions.robot.library import SHADOW
from tracker.base.config import from_dict
from tracker.base.errors import ConfigError, FileError

OBJECTS = ("cube", "cylinder", "ball")
CLUTCHES = ("none", "thumb_up", "point", "fist")


@dataclass(frozen=True)
class RobotSettings:
    """``model`` is a name of `extensions.robot.library.MODELS` or a path of MJCF; ``side`` that of
    the wearer's hand.

    ``motion_scale``: m that the palm moves for each of the wearer's. ``reach_scale``: factor on the
    fingers' reach, beside the ratio of their lengths. ``clutch``: the gesture that couples and
    uncouples the palm; none: by command alone. Speeds are the most that is commanded.
    """

    model: str = SHADOW
    side: str = "right"
    objects: str = ",".join(OBJECTS)  # those that are on the table
    motion_scale: float = 1.0
    reach_scale: float = 1.0
    clutch: str = "none"
    joint_speed: float = 8.0  # rad/s
    palm_speed: float = 1.0  # m/s
    turn_speed: float = 6.0  # rad/s

    def __post_init__(self) -> None:
        if self.side not in ("right", "left"):
            raise ConfigError(f"A hand is right or left, not {self.side!r}.")
        if self.clutch not in CLUTCHES:
            raise ConfigError(f"The clutch is {', '.join(CLUTCHES)}, not {self.clutch!r}.")
        strange = [name for name in self.things if name not in OBJECTS]
        if strange:
            raise ConfigError(f"Objects are {', '.join(OBJECTS)}, not {strange[0]!r}.")
        if not 0.1 <= self.motion_scale <= 10 or not 0.5 <= self.reach_scale <= 2:
            raise ConfigError("The motion is scaled by 0.1 to 10, the reach by 0.5 to 2.")
        if min(self.joint_speed, self.palm_speed, self.turn_speed) <= 0:
            raise ConfigError("A robot's speeds are greater than zero.")

    @property
    def things(self) -> tuple[str, ...]:
        """Names of ``objects``."""
        return tuple(dict.fromkeys(word for word in self.objects.split(",") if word))


def settings_of(text: str) -> RobotSettings:
    """Settings from a recording's JSON. Raises FileError where it is none."""
    try:
        said = json.loads(text)
    except ValueError as error:
        raise FileError("What the session says of its robot is damaged.") from error
    return from_dict(RobotSettings, said if isinstance(said, dict) else {}, lambda key, why: None)
