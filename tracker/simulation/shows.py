"""Simulated wearers who use an application from beginning to end: their motions, and the
application's expected position."""

from __future__ import annotations

from typing import NamedTuple

from tracker.base.errors import ConfigError
from tracker.base.notices import notice

WORD = "show:"
"""Prefix of an application's name, in place of a file of recorded motion."""


class Key(NamedTuple):
    """At ``t`` s the hand shows ``gesture`` with its palm's centre at ``palm`` m in G, rotated from
    palm down, fingers along x, by the rotation vector ``turn`` in degrees about G's axes."""

    t: float
    gesture: str
    palm: tuple[float, float, float]
    turn: tuple[float, float, float] = (0.0, 0.0, 0.0)


def show_keys(name: str) -> list[Key]:
    """The keys of a show: `WORD` and the name of its application; `WORD` may be omitted.

    Raises ConfigError for an unknown name.
    """
    known = name.removeprefix(WORD)
    if known not in SHOWS:
        raise ConfigError(notice("simulate.unknown_show", name=name, known=tuple(SHOWS)))
    keys, t = [], 0.0
    for seconds, gesture, palm, turn in SHOWS[known]:
        t += seconds
        keys.append(Key(t, gesture, palm, turn))
    return keys


def shown_application(motion: str) -> tuple[str, dict[str, list[float]]]:
    """The application that the wearer of a ``motion`` uses, and the settings that place it at the
    expected position; empty for other motions. Raises ConfigError as `show_keys`.
    """
    name = motion.removeprefix(WORD)
    if name == motion:
        return "", {}
    show_keys(name)
    return name, {"place": list(PLACES[name])}


_FLAT, _EDGE, _TURNED = (0.0, 0.0, 0.0), (90.0, 0.0, 0.0), (0.0, 0.0, 35.0)
_HOME = (0.15, 0.0, 0.12)
SHOWS: dict[
    str, list[tuple[float, str, tuple[float, float, float], tuple[float, float, float]]]
] = {
    "touch": [
        (0.0, "open_palm", _HOME, _FLAT),
        (1.5, "open_palm", _HOME, _FLAT),
        (1.5, "open_palm", (0.15, 0.0, 0.07), _FLAT),
        (0.8, "open_palm", (0.17, 0.03, 0.07), _FLAT),
        (0.8, "open_palm", (0.17, -0.03, 0.07), _FLAT),
        (1.0, "point", (0.15, 0.0, 0.12), _FLAT),
        (1.0, "point", (0.18, 0.0, 0.08), _FLAT),
        (1.0, "open_palm", _HOME, _FLAT),
    ],
    "arm": [
        (0.0, "relaxed", _HOME, _FLAT),
        (1.5, "relaxed", _HOME, _FLAT),
        (0.6, "grasp", _HOME, _FLAT),
        (1.5, "grasp", (0.18, 0.0, -0.01), _FLAT),
        (0.4, "grasp", (0.18, 0.0, -0.01), _FLAT),
        (0.4, "pinch_index", (0.18, 0.0, -0.01), _FLAT),
        (0.8, "pinch_index", (0.18, 0.0, -0.01), _FLAT),
        (1.2, "pinch_index", (0.16, 0.03, 0.09), _FLAT),
        (0.6, "open_palm", (0.16, 0.03, 0.09), _FLAT),
        (0.6, "open_palm", (0.16, 0.03, 0.09), _FLAT),
        (0.6, "thumb_up", (0.16, 0.03, 0.09), _FLAT),
        (0.8, "thumb_up", (0.16, 0.03, 0.09), _FLAT),
    ],
    "swarm": [
        (0.0, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (1.5, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (0.8, "point", (0.10, 0.0, 0.12), _FLAT),
        (1.0, "point", (0.15, 0.0, 0.12), _FLAT),
        (0.8, "relaxed", (0.22, 0.0, 0.20), _FLAT),
        (0.5, "pinch_index", (0.22, -0.02, 0.20), _FLAT),
        (1.0, "pinch_index", (0.18, 0.04, 0.19), _FLAT),
        (0.6, "relaxed", (0.18, 0.06, 0.19), _FLAT),
        (0.5, "grasp", (0.18, 0.06, 0.19), _FLAT),
        (1.0, "grasp", (0.18, 0.12, 0.19), _FLAT),
        (0.5, "relaxed", (0.18, 0.12, 0.19), _FLAT),
        (0.8, "relaxed", (0.10, -0.14, 0.22), _FLAT),
        (0.5, "open_palm", (0.10, -0.14, 0.22), _FLAT),
        (1.0, "open_palm", (0.10, -0.14, 0.06), _FLAT),
        (0.5, "relaxed", (0.10, -0.14, 0.10), _FLAT),
        (0.8, "relaxed", (0.16, 0.03, 0.30), _EDGE),
        (0.5, "open_palm", (0.20, 0.03, 0.24), _EDGE),
        (1.2, "open_palm", (0.20, 0.03, 0.02), _EDGE),
        (0.6, "relaxed", (0.12, 0.0, 0.12), _FLAT),
        (0.8, "thumb_up", (0.12, 0.0, 0.12), _FLAT),
        (0.4, "thumb_up", (0.12, 0.0, 0.12), _FLAT),
        (0.6, "fist", (0.12, 0.0, 0.12), _FLAT),
        (0.6, "fist", (0.12, 0.0, 0.12), _FLAT),
        (0.6, "relaxed", (0.19, 0.05, 0.20), _FLAT),
        (0.6, "pinch_index", (0.19, 0.05, 0.20), _FLAT),
        (0.3, "pinch_index", (0.19, 0.05, 0.20), _FLAT),
        (1.0, "pinch_index", (0.225, -0.056, 0.20), _FLAT),
        (0.6, "relaxed", (0.16, 0.0, 0.20), _FLAT),
    ],
    "place": [
        (0.0, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (1.5, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (0.6, "point", (0.08, -0.0935, 0.148), _FLAT),
        (1.5, "point", (0.08, -0.0935, 0.148), _FLAT),
        (0.8, "relaxed", (0.24, -0.03, 0.14), _FLAT),
        (0.5, "grasp", (0.24, -0.03, 0.14), _FLAT),
        (1.2, "grasp", (0.20, 0.02, 0.14), _TURNED),
        (0.5, "relaxed", (0.20, 0.02, 0.14), _TURNED),
        (0.6, "pinch_middle", (0.20, 0.03, 0.12), _FLAT),
        (1.0, "pinch_middle", (0.20, 0.03, 0.18), _FLAT),
        (0.5, "relaxed", (0.20, 0.03, 0.16), _FLAT),
        (0.5, "pinch_index", (0.20, 0.02, 0.14), _FLAT),
        (1.0, "pinch_index", (0.20, -0.04, 0.14), _FLAT),
        (0.6, "open_palm", (0.12, 0.0, 0.14), _FLAT),
        (1.2, "open_palm", (0.12, 0.0, 0.14), _FLAT),
        (0.8, "point", (0.08, 0.0465, 0.148), _FLAT),
        (1.5, "point", (0.08, 0.0465, 0.148), _FLAT),
        (0.6, "open_palm", (0.12, 0.0, 0.14), _FLAT),
        (1.2, "open_palm", (0.12, 0.0, 0.14), _FLAT),
        (0.8, "point", (0.07, -0.0235, 0.118), _FLAT),
        (1.5, "point", (0.07, -0.0235, 0.118), _FLAT),
        (0.6, "open_palm", (0.12, 0.0, 0.14), _FLAT),
        (1.2, "open_palm", (0.12, 0.0, 0.14), _FLAT),
    ],
}
"""Seconds since the key before, gesture, palm and turn of each key, by application."""

PLACES: dict[str, tuple[float, float, float]] = {
    "touch": (0.25, 0.0, 0.05),
    "arm": (-0.006, 0.12, 0.02),
    "swarm": (0.26, 0.0, 0.12),
    "place": (0.32, 0.0, 0.06),
}
"""m in G: position of an application if the first hand is that of the first key."""
