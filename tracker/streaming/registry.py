"""Streams that can be switched on: descriptors, settings and opening.

A package declares a stream as an entry point of the group ``glovetrack.streams`` that names a
`StreamKind`. On a command line: ``--stream udp,vmc:39541``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from tracker.base.config import UNKNOWN
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.registry import Registry
from tracker.base.toml_reader import parse_toml, read_text
from tracker.streaming.connection import (
    HOST,
    ConnectionKind,
    ConnectionSettings,
    key_of,
    kinds_of,
    with_words,
)
from tracker.streaming.connection import StreamError as StreamError
from tracker.streaming.connection import option as option
from tracker.streaming.publisher import OWN, Names, Publisher

Opt = TypeVar("Opt")  # a dataclass of options
JOINTS = "joints"


@dataclass(frozen=True, kw_only=True)
class StreamKind(ConnectionKind[Opt]):
    """Descriptor of a stream.

    ``make(options, hands)`` returns or yields one publisher for each hand, in order. It imports
    slow or optional packages, and raises StreamError if the stream cannot be opened. ``note`` is a
    warning next to the switch. A stream with an option ``file`` writes to a new file, which the
    window names ``default_file`` and numbers.
    """

    make: Callable[[Opt, Sequence[Names]], Iterable[Publisher]]
    note: str = ""
    default_file: str = ""


STREAMS: Registry[StreamKind[Any]] = Registry("streams", "stream", StreamKind)


def stream_kinds() -> dict[str, StreamKind[Any]]:
    """All streams that can be loaded, by name, in the order in which lists show them."""
    return kinds_of(STREAMS)


@dataclass(frozen=True)
class StreamSettings(ConnectionSettings):
    """Which streams run, with their options. ``table`` also has ``joints``, see `Names.of`."""

    @property
    def joints(self) -> str:
        return self._text(JOINTS, OWN)

    @property
    def on(self) -> list[str]:
        """Names of the streams that are on and installed."""
        return [name for name in stream_kinds() if self.is_on(name)]


def with_streams(
    settings: StreamSettings, words: str, host: str = "", joints: str = ""
) -> StreamSettings:
    """``settings`` with the streams of a comma-separated list on, another host and other joints.

    Raises ConfigError as `with_words`.
    """
    settings = with_words(settings, STREAMS, words, host)
    return settings.changed(joints=joints) if joints else settings


def read_settings(path: str | Path) -> StreamSettings:
    """The table ``[streams]`` of a TOML file, whose other tables are ignored.

    Raises FileError, and ConfigError for a key that no installed stream has.
    """
    table = parse_toml(read_text(Path(path)), str(path)).get("streams", {})
    if not isinstance(table, dict):
        raise ConfigError(notice("config.streams_table", file=path))
    kinds = stream_kinds()
    known = {HOST, JOINTS, *kinds}
    known |= {key_of(name, option) for name, kind in kinds.items() for option in kind.fields}
    for key in table:
        if key not in known:
            raise ConfigError(notice("config.unknown_stream", file=path, key=key, why=UNKNOWN))
    return StreamSettings(table)


def open_streams(settings: StreamSettings, hands: Sequence[Names]) -> dict[str, list[Publisher]]:
    """Every stream that is on, with a publisher for each hand.

    Raises StreamError after closing what was opened.
    """
    out: dict[str, list[Publisher]] = {}
    sharing = [names.sharing() for names in hands]
    try:
        for name in settings.on:
            kind = STREAMS.get(name)
            out[name] = open_stream(kind, settings.options(kind), sharing)
    except StreamError:
        close_all(publisher for publishers in out.values() for publisher in publishers)
        raise
    return out


def open_stream(kind: StreamKind[Opt], options: Opt, hands: Sequence[Names]) -> list[Publisher]:
    """A publisher for each hand. Raises StreamError after closing what was opened."""
    out: list[Publisher] = []
    try:
        with kind.opening(f"The {kind.name} stream"):
            for publisher in kind.make(options, hands):
                out.append(publisher)
        if len(out) != len(hands):
            raise StreamError(
                notice("stream.publishers", kind=kind.name, made=len(out), hands=len(hands))
            )
    except StreamError:
        close_all(out)
        raise
    return out


def close_all(publishers: Iterable[Publisher]) -> None:
    """Close each of them."""
    for publisher in publishers:
        publisher.close()
