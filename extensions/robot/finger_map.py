"""Which links of a robot hand are its fingertips: the user's choices, as text and as a file."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import tomli_w

from extensions.robot.wearer_hand import FINGERS
from tracker.base.errors import ConfigError
from tracker.base.files import write_whole
from tracker.base.frozen_dict import FrozenDict
from tracker.base.notices import notice
from tracker.base.toml_reader import parse_toml, read_text

PALM = "palm"
ROWS = (*FINGERS, PALM)
TABLE = "fingers"
_BETWEEN = re.compile(rf",(?=\s*(?:{'|'.join(ROWS)})\s*=)")


@dataclass(frozen=True)
class FingerMap:
    """``links``: name of a link (MJCF: body) by finger, "" for a finger that the hand does not
    have; `PALM` is the link that carries the fingers. What is not in it is found automatically."""

    links: Mapping[str, str] = field(default_factory=FrozenDict)

    def __post_init__(self) -> None:
        """Raises ConfigError for other keys and for a link given to two fingers."""
        for name in self.links:
            if name not in ROWS:
                raise ConfigError(notice("robot.finger", finger=name, known=ROWS))
        tips = [link for name, link in self.links.items() if link and name != PALM]
        twice = [link for link in tips if tips.count(link) > 1]
        if twice:
            raise ConfigError(notice("robot.link_twice", link=twice[0]))

    @property
    def text(self) -> str:
        """As `RobotSettings` contain it: ``thumb=link_15,little=``."""
        return ",".join(f"{name}={self.links[name]}" for name in ROWS if name in self.links)

    def with_link(self, name: str, link: str) -> FingerMap:
        """With another choice; a finger that had the link is found automatically again."""
        kept = {n: v for n, v in self.links.items() if not v or v != link or PALM in (n, name)}
        return FingerMap(FrozenDict({**kept, name: link}))


def map_from_text(text: str) -> FingerMap:
    """The map in `FingerMap.text`; empty text is an empty map. Raises ConfigError."""
    links: dict[str, str] = {}
    for part in _BETWEEN.split(text) if text.strip() else ():
        name, equals, link = part.partition("=")
        if not equals:
            raise ConfigError(notice("robot.finger", finger=name.strip(), known=ROWS))
        links[name.strip()] = link.strip()
    return FingerMap(FrozenDict(links))


def read_map(path: Path) -> FingerMap:
    """The table ``[fingers]`` of a TOML file. Raises FileError, and ConfigError for other keys."""
    table = parse_toml(read_text(path), str(path)).get(TABLE)
    if not isinstance(table, dict) or not all(isinstance(v, str) for v in table.values()):
        raise ConfigError(notice("robot.no_finger_table", file=path))
    return FingerMap(FrozenDict(table))


def write_map(path: Path, fingers: FingerMap, force: bool = False) -> None:
    """Write the map as TOML. Raises FileError, also for an existing file without ``force``."""
    table = {name: fingers.links[name] for name in ROWS if name in fingers.links}
    write_whole(path, tomli_w.dumps({TABLE: table}), force)


def map_given(words: str) -> FingerMap:
    """The map in a file, if ``words`` is the name of one, or in ``words``. Raises ConfigError and
    FileError."""
    if words.endswith(".toml"):
        return read_map(Path(words).expanduser())
    return map_from_text(words)
