"""The protocols by which other programs control the window. By default none is on.

A package declares one as an entry point of the group ``glovetrack.remote`` that names a `DoorKind`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

from tracker.base.registry import Registry
from tracker.streaming.connection import (
    ConnectionKind,
    ConnectionSettings,
    kinds_of,
    with_words,
)
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Answer

Opt = TypeVar("Opt")  # a dataclass of options


@dataclass(frozen=True, kw_only=True)
class DoorKind(ConnectionKind[Opt]):
    """Descriptor of a protocol. ``make(options, answer)`` opens it, passes each request to
    ``answer``, and raises StreamError if it cannot be opened."""

    make: Callable[[Opt, Answer], Door]


DOORS: Registry[DoorKind[Any]] = Registry("remote", "remote control", DoorKind)


def door_kinds() -> dict[str, DoorKind[Any]]:
    """All protocols that can be loaded, by name, in the order of lists."""
    return kinds_of(DOORS)


def with_doors(settings: ConnectionSettings, words: str, host: str = "") -> ConnectionSettings:
    """``settings`` with the protocols of a comma-separated list on: ``udp,osc:9000``.

    Raises ConfigError for an unknown name or an invalid port.
    """
    return with_words(settings, DOORS, words, host)


def open_door(kind: DoorKind[Opt], options: Opt, answer: Answer) -> Door:
    """Opens one protocol. Raises StreamError."""
    with kind.opening(f"Remote control by {kind.name}"):
        return kind.make(options, answer)
