"""What a robot hand's file contains: its links, and which of them are fingertips."""

from __future__ import annotations

import math
from dataclasses import dataclass

import mujoco

from extensions.robot.finger_map import PALM, FingerMap, map_from_text
from extensions.robot.fingers import distal_of, last_links, path_to, plain
from extensions.robot.hand import HandFile, read_hand, usable
from extensions.robot.library import model_path, need_mujoco
from extensions.robot.model_file import read_model
from extensions.robot.settings import RobotSettings
from extensions.robot.wearer_hand import FINGERS
from tracker.base.errors import ConfigError
from tracker.base.frozen_dict import FrozenDict
from tracker.base.notices import Notice


@dataclass(frozen=True)
class FingerRow:
    """``link`` is the tip's link, "" for a finger that the hand does not have; ``how`` is "user",
    "name" or "position"; ``joints`` are its hinges from the palm on; ``length`` m or NaN."""

    finger: str
    link: str = ""
    how: str = ""
    joints: tuple[str, ...] = ()
    length: float = math.nan


@dataclass(frozen=True)
class HandSurvey:
    """``side`` is that of the file's hand. ``tips`` and ``palms`` are the links from which the user
    can choose; ``problem`` is why the hand cannot be used with the links of ``fingers``, if it
    cannot."""

    side: str
    palm: str
    fingers: tuple[FingerRow, ...]
    tips: tuple[str, ...]
    palms: tuple[str, ...]
    problem: Notice | None = None

    @property
    def map(self) -> FingerMap:
        """The links of all fingers, found or chosen."""
        return FingerMap(FrozenDict({**{r.finger: r.link for r in self.fingers}, PALM: self.palm}))


def survey_hand(settings: RobotSettings) -> HandSurvey:
    """Reads the hand of the settings. Raises ConfigError if the file cannot be read."""
    need_mujoco()
    path = model_path(settings.model)
    given = map_from_text(settings.fingers)
    try:
        file = read_hand(path, given)
    except ConfigError as error:
        with usable(path):
            tips, palms = _choices(read_model(path).compile())
        rows = tuple(FingerRow(f, given.links.get(f, "")) for f in FINGERS)
        return HandSurvey("", given.links.get(PALM, ""), rows, tips, palms, error.notice)
    tips, palms = _choices(file.whole)
    rows = tuple(_row(f, file) for f in FINGERS)
    return HandSurvey(file.anatomy.side, file.fingers.links[PALM], rows, tips, palms)


def _choices(model: mujoco.MjModel) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of links that may be a fingertip: those that move; and that may be the palm."""
    paths = [path_to(model, end) for end in last_links(model)]
    moving = {b for path in paths for b in path if b and distal_of(model, b) != 0}
    palms = [b for b in range(1, model.nbody) if sum(b in path[:-1] for path in paths) > 1]
    tips = [b for b in range(1, model.nbody) if b in moving or _hangs(model, b, moving)]
    tips = [b for b in tips if b not in palms]
    return tuple(model.body(b).name for b in tips), tuple(model.body(b).name for b in palms)


def _hangs(model: mujoco.MjModel, body: int, moving: set[int]) -> bool:
    """Whether a link is fixed to a moving one."""
    weld = int(model.body_weldid[body])
    return weld != 0 and weld in moving


def _row(finger: str, file: HandFile) -> FingerRow:
    read = next((f for f in file.anatomy.fingers if f.name == finger), None)
    if read is None:
        return FingerRow(finger)
    joints = tuple(plain(file.model.joint(j).name) for j in read.joints)
    link = file.fingers.links[finger]
    return FingerRow(finger, link, file.found.how[finger], joints, read.length)
