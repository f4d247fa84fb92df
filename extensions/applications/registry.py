"""The registry of applications: our own and those of installed packages.

A package names its application's class under the entry-point group ``glovetrack.applications``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, get_type_hints

from extensions.applications.extension import ApplicationKind
from extensions.applications.interface import Application
from tracker.base.config import from_dict
from tracker.base.errors import ConfigError
from tracker.base.notices import Notice, notice
from tracker.base.registry import Registry

Maker = Callable[[Any], Application]


def _described(found: object) -> object:
    """An application's class describes itself."""
    if not isinstance(found, type):
        return found
    application: type[Application] = found
    return ApplicationKind(application.name, application.title, lambda: application)


APPLICATIONS = Registry("applications", "application", ApplicationKind, _described)


def kind(name: str) -> type[Application]:
    """The class of an application. Raises ConfigError if it does not exist or cannot be loaded."""
    described = APPLICATIONS.get(name)
    try:
        return described.load()
    except ImportError as error:
        command = f' Run: pip install "{described.extra}"' if described.extra else ""
        raise ConfigError(
            notice("application.needs_package", application=name, why=error, install=command)
        ) from error


def titles() -> dict[str, str]:
    """Titles of all applications by name, in display order.

    Applications with a missing package are listed and report it when selected; those that cannot be
    loaded are omitted and logged.
    """
    found = sorted(APPLICATIONS.all().items(), key=lambda item: item[1].order)
    return {name: described.title for name, described in found}


def settings_type(found: type[Application]) -> type[Any]:
    """The dataclass of an application's settings, which its ``__init__`` takes."""
    hints = get_type_hints(found.__init__)
    hints.pop("return", None)
    return next(iter(hints.values()))


def make(name: str, settings: Mapping[str, Any] | None = None) -> Application:
    """Create an application. Raises ConfigError for invalid settings."""
    found = kind(name)
    maker: Maker = found
    return maker(settings_of(settings_type(found), settings or {}, name))


def settings_of(known: type[Any], values: Mapping[str, Any], name: str) -> Any:
    """Settings of type ``known`` with ``values``. Raises ConfigError."""

    def on_problem(path: str, why: Notice) -> None:
        raise ConfigError(notice("config.key", file=name, key=path, why=why))

    return from_dict(known, dict(values), on_problem)


def changed(settings: Any, key: str, value: Any, name: str) -> Any:
    """``settings`` with one value changed. Raises ConfigError."""
    wanted = settings_of(type(settings), {key: value}, name)
    return replace(settings, **{key: getattr(wanted, key)})
