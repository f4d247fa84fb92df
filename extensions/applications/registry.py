"""Which applications there are: our own, and those of installed packages.

A package names its application's class under the entry-point group ``glovetrack.applications``.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from dataclasses import replace
from importlib import import_module
from importlib.metadata import entry_points
from typing import Any, NamedTuple, get_type_hints

from extensions.applications.interface import Application
from tracker.base.config import from_dict
from tracker.base.errors import ConfigError

GROUP = "glovetrack.applications"


class BuiltIn(NamedTuple):
    """Where an application of ours is, and what it is called where it cannot be loaded."""

    module: str
    kind: str
    title: str


BUILT_IN = {
    "touch": BuiltIn("touch.touch", "Touch", "Virtual object to touch"),
    "arm": BuiltIn("arm.arm", "RobotArm", "Robot arm"),
    "place": BuiltIn("place.place", "Place", "Virtual place"),
    "swarm": BuiltIn("swarm.swarm", "Swarm", "Drone swarm"),
}
"""By name; imported when asked for."""
EXTRA = 'pip install "glovetrack[robot]"'
_log = logging.getLogger(__name__)
Maker = Callable[[Any], Application]


def names() -> list[str]:
    """Of all applications, ours first."""
    others = [entry.name for entry in entry_points(group=GROUP)]
    return [*BUILT_IN, *(n for n in others if n not in BUILT_IN)]


def kind(name: str) -> type[Application]:
    """The class. Raises ConfigError where there is none, or it cannot be loaded."""
    if name in BUILT_IN:
        ours = BUILT_IN[name]
        try:
            module = import_module(f"{__package__}.{ours.module}")
            found: type[Application] = getattr(module, ours.kind)
        except ImportError as error:
            raise ConfigError(
                f"The application {name} needs a package that is not installed ({error}). "
                f"Run: {EXTRA}"
            ) from error
        return found
    for entry in entry_points(group=GROUP, name=name):
        try:
            found = entry.load()
        except Exception as error:
            raise ConfigError(f"The application {name} cannot be loaded: {error}") from error
        return found
    raise ConfigError(f"There is no application {name!r}; there are {', '.join(names())}.")


def titles() -> dict[str, str]:
    """What each is called, by name. Ours are all named: one that lacks a package says so when it
    is chosen. A plug-in that cannot be loaded is left out and logged."""
    out = {}
    for name in names():
        try:
            out[name] = BUILT_IN[name].title if name in BUILT_IN else kind(name).title
        except ConfigError as error:
            _log.warning("%s", error)
    return out


def settings_type(found: type[Application]) -> type[Any]:
    """The dataclass of an application's settings: what its ``__init__`` takes."""
    hints = get_type_hints(found.__init__)
    hints.pop("return", None)
    return next(iter(hints.values()))


def make(name: str, settings: Mapping[str, Any] | None = None) -> Application:
    """An application as new. Raises ConfigError for a setting that it cannot take."""
    found = kind(name)
    maker: Maker = found
    return maker(settings_of(settings_type(found), settings or {}, name))


def settings_of(known: type[Any], values: Mapping[str, Any], name: str) -> Any:
    """A ``known`` with ``values``. Raises ConfigError."""

    def complain(path: str, why: str) -> None:
        raise ConfigError(f"{name}: {path} {why}.")

    return from_dict(known, dict(values), complain)


def changed(settings: Any, key: str, value: Any, name: str) -> Any:
    """``settings`` with another value of one of them. Raises ConfigError."""
    wanted = settings_of(type(settings), {key: value}, name)
    return replace(settings, **{key: getattr(wanted, key)})
