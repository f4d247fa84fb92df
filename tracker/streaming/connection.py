"""Common parts of connections to other programs: descriptor, options, and the error they raise.

Streams and remote control are switched on by name and share one form of settings, a flat table as
in the window's settings and in a TOML file: ``{"udp": true, "udp_port": 9000}``.
This module does not import the engine, so that a command starts at once.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, fields
from typing import Any, Generic, TypeVar
from urllib.parse import parse_qsl

from tracker.base.config import from_dict
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.notices import notice
from tracker.base.registry import Registry

LOOPBACK = "127.0.0.1"
HOST = "host"
Opt = TypeVar("Opt")  # a dataclass of options
V = TypeVar("V", bool, int, float, str)
_log = logging.getLogger(__name__)


class StreamError(GlovetrackError):
    """A stream cannot be opened or has failed."""


def option(default: V, help: str, choices: Sequence[V] = ()) -> V:
    """A field of a dataclass of options, with a sentence for tooltips and documentation, and the
    values that it can have if these are few."""
    value: V = field(default=default, metadata={"help": help, "choices": tuple(choices)})
    return value


@dataclass(frozen=True, kw_only=True)
class ConnectionKind(Generic[Opt]):
    """Descriptor of a connection that is switched on by name.

    ``options`` is a frozen dataclass with a default for each field. A field ``host`` is the address
    that all connections of a registry share; a field ``port`` or ``file`` follows the name
    and a colon on the command line, and is edited in the window. ``extra`` is what pip installs if
    a package is missing. ``order`` sorts lists; the core's have 10 to 19.
    """

    name: str
    title: str
    options: type[Opt]
    extra: str = ""
    order: int = 100

    @property
    def fields(self) -> dict[str, str]:
        """Names of the options, each with its help."""
        found = fields(self.options)  # type: ignore[arg-type]
        return {f.name: f.metadata.get("help", "") for f in found}

    def has(self, option: str) -> bool:
        """Whether there is an option of this name."""
        return option in self.fields

    @contextmanager
    def opening(self, what: str) -> Iterator[None]:
        """Raises StreamError with the package to install if one cannot be imported."""
        try:
            yield
        except ImportError as error:
            command = f' Run: pip install "{self.extra}"' if self.extra else ""
            raise StreamError(
                notice("stream.needs_package", what=what, why=error, install=command)
            ) from error


K = TypeVar("K", bound=ConnectionKind[Any])


def kinds_of(registry: Registry[K]) -> dict[str, K]:
    """All connections that can be loaded, by name, in the order of lists."""
    return dict(sorted(registry.all().items(), key=lambda item: item[1].order))


@dataclass(frozen=True)
class ConnectionSettings:
    """Which connections are on and their options; by default none is on.

    ``table`` has ``NAME`` (a boolean), ``NAME_OPTION`` and ``host``. Keys of a connection that is
    not installed are preserved, and a value of a wrong type counts as absent.
    """

    table: Mapping[str, object] = field(default_factory=dict)

    def is_on(self, name: str) -> bool:
        return self.table.get(name) is True

    @property
    def host(self) -> str:
        """The address to which streams are sent and at which servers listen."""
        return self._text(HOST, LOOPBACK)

    def changed(self: S, **changes: object) -> S:
        """A copy with other values in the table."""
        return type(self)({**self.table, **changes})

    def options(self, kind: ConnectionKind[Opt]) -> Opt:
        """Options of one connection; absent values and those of a wrong type have their
        defaults."""
        keys = {name: key_of(kind.name, name) for name in kind.fields}
        given = {name: self.table[key] for name, key in keys.items() if key in self.table}
        return from_dict(kind.options, given, lambda key, why: _log.info("%s %s", key, why))

    def _text(self, key: str, usual: str) -> str:
        value = self.table.get(key)
        return value if isinstance(value, str) and value else usual


S = TypeVar("S", bound=ConnectionSettings)


def key_of(name: str, option: str) -> str:
    """Key of an option in the table of settings."""
    return option if option == HOST else f"{name}_{option}"


def with_words(settings: S, registry: Registry[K], words: str, host: str = "") -> S:
    """``settings`` with the connections of a comma-separated list on, and another host.

    ``udp:9000`` sets the port, ``isaac:take.mcap`` the file, ``udp?schema=1&port=9000`` any
    options. Raises ConfigError for an unknown name or option, or an invalid value.
    """
    for word in filter(None, (w.strip() for w in words.split(","))):
        address, mark, query = word.partition("?")
        name, colon, value = address.partition(":")
        kind = registry.get(name.lower())
        settings = settings.changed(**{kind.name: True})
        if colon:
            settings = settings.changed(**_after_colon(kind, registry.noun, value))
        if mark:
            settings = settings.changed(**_queried(kind, registry.noun, query))
    return settings.changed(host=host) if host else settings


def _queried(kind: ConnectionKind[Any], noun: str, query: str) -> dict[str, object]:
    """Options as in the query of a URL, by their keys in the table."""
    out: dict[str, object] = {}
    usual = kind.options()
    for name, text in parse_qsl(query, keep_blank_values=True):
        if name == HOST or not kind.has(name):
            raise ConfigError(
                notice(
                    "stream.no_option",
                    kind=kind.name,
                    what=noun,
                    option=name,
                    known=[n for n in kind.fields if n != HOST],
                )
            )
        value = _read(text, getattr(usual, name))
        if value is None:
            raise ConfigError(
                notice("stream.bad_option", value=text, option=name, kind=kind.name, what=noun)
            )
        out[key_of(kind.name, name)] = value
    return out


def _read(text: str, usual: object) -> object:
    """``text`` converted to the type of ``usual``; None if that is impossible."""
    if isinstance(usual, bool):
        return {"true": True, "1": True, "false": False, "0": False}.get(text.lower())
    try:
        return type(usual)(text)  # type: ignore[call-arg]
    except ValueError:
        return None


def _after_colon(kind: ConnectionKind[Any], noun: str, value: str) -> dict[str, object]:
    if kind.has("port"):
        if not value.isdecimal() or not 1 <= int(value) <= 65535:
            raise ConfigError(notice("stream.bad_port", value=value, kind=kind.name, what=noun))
        return {key_of(kind.name, "port"): int(value)}
    if kind.has("file"):
        return {key_of(kind.name, "file"): value}
    raise ConfigError(notice("stream.no_port", kind=kind.name, what=noun))
