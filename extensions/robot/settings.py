"""Settings of a robot hand."""

from __future__ import annotations

import json
from dataclasses import dataclass

from extensions.robot.finger_map import map_from_text
from extensions.robot.library import SHADOW
from tracker.base.config import from_dict
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice

OBJECTS = ("cube", "cylinder", "ball")
CLUTCHES = ("none", "thumb_up", "point", "fist")


@dataclass(frozen=True)
class RobotSettings:
    """``model`` is a name of `extensions.robot.library.MODELS` or the path of an MJCF or URDF
    file; ``side`` is the side of the wearer's hand; ``fingers`` is a `FingerMap` as text.

    ``motion_scale``: m that the robot's palm moves per m of the wearer's. ``reach_scale``: factor
    on the fingers' reach, in addition to the ratio of their lengths. ``clutch``: the gesture that
    couples and uncouples the palm; with none, only commands do. Speeds are upper limits.
    """

    model: str = SHADOW
    side: str = "right"
    fingers: str = ""  # found automatically where it names no link
    objects: str = ",".join(OBJECTS)  # on the table
    motion_scale: float = 1.0
    reach_scale: float = 1.0
    clutch: str = "none"
    joint_speed: float = 8.0  # rad/s
    palm_speed: float = 1.0  # m/s
    turn_speed: float = 6.0  # rad/s

    def __post_init__(self) -> None:
        if self.side not in ("right", "left"):
            raise ConfigError(notice("robot.side", side=self.side))
        if self.clutch not in CLUTCHES:
            raise ConfigError(notice("robot.clutch", known=CLUTCHES, clutch=self.clutch))
        map_from_text(self.fingers)
        strange = [name for name in self.things if name not in OBJECTS]
        if strange:
            raise ConfigError(notice("robot.objects", value=strange[0], known=OBJECTS))
        if not 0.1 <= self.motion_scale <= 10 or not 0.5 <= self.reach_scale <= 2:
            raise ConfigError(notice("robot.scale"))
        if min(self.joint_speed, self.palm_speed, self.turn_speed) <= 0:
            raise ConfigError(notice("robot.speeds"))

    @property
    def things(self) -> tuple[str, ...]:
        """Names of ``objects``."""
        return tuple(dict.fromkeys(word for word in self.objects.split(",") if word))


def settings_of(text: str) -> RobotSettings:
    """Settings from a recording's JSON. Raises FileError if it is not valid JSON."""
    try:
        found = json.loads(text)
    except ValueError as error:
        raise FileError(notice("robot.description_damaged")) from error
    return from_dict(RobotSettings, found if isinstance(found, dict) else {}, lambda key, why: None)
