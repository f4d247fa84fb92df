"""The options of tracking a session again, for the hand of each side; files declare their side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import parse_toml, read_text
from tracker.fusion.engine import Engine
from tracker.fusion.wearer_learning import save_wearer
from tracker.glove import library
from tracker.hand.names import SIDES
from tracker.offline.options import TrackOptions
from tracker.session.description import COLOURS, GLOVE, HAND, SessionInfo, of_side
from tracker.session.export.run import path_of_side
from tracker.vision.colours import parse_profile


def several(requested: str) -> list[str]:
    """Splits names or paths at commas; the path of an existing file may contain a comma."""
    if Path(requested).is_file():
        return [requested]
    return [part.strip() for part in requested.split(",") if part.strip()]


class Replacement(NamedTuple):
    """A text, and the name or path that was given for it."""

    text: str
    origin: str


def replacements(options: TrackOptions, both: bool) -> dict[str, Replacement]:
    """Returns the texts that replace the session's, by the attachment's name; for a session of
    ``both`` hands, each replaces the one of its side.

    Raises FileError and ConfigError.
    """
    out: dict[str, Replacement] = {}
    if options.colours:
        out[COLOURS] = Replacement(library.text("colours", options.colours), options.colours)
        parse_profile(*out[COLOURS])
    for kind, name, requested in (("hands", HAND, options.hand), ("gloves", GLOVE, options.glove)):
        found = [Replacement(library.text(kind, each), each) for each in several(requested)]
        if both:
            named = {of_side(name, _side_of(each.text, each.origin)): each for each in found}
            if len(named) < len(found):
                raise ConfigError(notice("track.same_side", files=[r.origin for r in found]))
            out |= named
        elif len(found) > 1:
            raise ConfigError(notice("track.one_hand", files=[r.origin for r in found]))
        elif found:
            (out[name],) = found
    return out


def _side_of(text: str, name: str) -> str:
    side = parse_toml(text, name).get("side")
    if side not in SIDES:
        raise FileError(notice("track.no_side", file=name))
    return str(side)


def wearers(requested: str, info: SessionInfo) -> dict[str, Path]:
    """Profiles by the side of the hand that each was learned of.

    Raises FileError for one that is of no hand of the session, ConfigError for two of one hand.
    """
    paths = [Path(each) for each in several(requested)]
    if not info.others and len(paths) == 1:
        return {info.side: paths[0]}  # its errors are reported when it is applied
    out: dict[str, Path] = {}
    for path in paths:
        table = parse_toml(read_text(path), path.name)
        names = table.get("hand"), table.get("glove")
        sides = [w.side for w in info.hands if names == (w.hand.name, w.glove.name)]
        if not sides:
            raise FileError(
                notice("track.other_hand", file=path.name, hand=names[0], glove=names[1])
            )
        if sides[0] in out:
            raise ConfigError(notice("track.same_hand", files=(out[sides[0]].name, path.name)))
        out[sides[0]] = path
    return out


def profile_paths(requested: str, both: bool) -> dict[str, Path]:
    """Returns the paths of the learned profiles by side: ``anna_left.toml`` for both hands."""
    if not requested:
        return {}
    return {
        side: path_of_side(Path(requested), side) if both else Path(requested) for side in SIDES
    }


def save_profiles(engines: Mapping[str, Engine], paths: Mapping[str, Path]) -> None:
    """Writes the learned profile of each hand. Raises as `save_wearer`."""
    for side, engine in engines.items():
        if side in paths:
            save_wearer(engine, paths[side])


def is_of_both(sides: Sequence[str], options: TrackOptions) -> bool:
    """Returns whether a session with gloves of these ``sides``, or their replacements, has two."""
    return bool(sides) or len(several(options.glove)) > 1
