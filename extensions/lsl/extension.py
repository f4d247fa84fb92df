"""Descriptors of Lab Streaming Layer: the stream, and markers as remote control."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.payload import LATEST, SCHEMAS
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind
from tracker.streaming.remote.doors import Door, is_loopback
from tracker.streaming.remote.reception import Answer
from tracker.streaming.remote.registry import DoorKind

EXTRA = "glovetrack[streams]"


@dataclass(frozen=True)
class LslOptions:
    network: bool = option(False, "whether other computers can discover the outlet")
    schema: int = option(
        LATEST, "2: with numbers and velocities in further channels; 1: without", SCHEMAS
    )


@dataclass(frozen=True)
class MarkerOptions:
    host: str = option(LOOPBACK, "127.0.0.1: markers of this computer only")


@contextmanager
def _liblsl() -> Iterator[None]:
    """pylsl without its library raises RuntimeError on import."""
    try:
        yield
    except RuntimeError as error:
        raise ImportError(str(error)) from error


def _outlets(options: LslOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    with _liblsl():
        from extensions.lsl.outlet import LslPublisher  # deferred: needs an extra

    for names in hands:
        yield LslPublisher(names, options.network, options.schema)


def _markers(options: MarkerOptions, answer: Answer) -> Door:
    with _liblsl():
        from extensions.lsl.markers import MarkerDoor  # deferred: needs an extra

    return MarkerDoor(answer, network=not is_loopback(options.host))


STREAM = StreamKind(
    name="lsl",
    title="Lab Streaming Layer",
    options=LslOptions,
    make=_outlets,
    extra=EXTRA,
    note="its library listens on all addresses of this computer, so others in the same network "
    "can read it, unless a firewall blocks it",
    order=30,
)
MARKERS = DoorKind(
    name="lsl",
    title="LSL (markers become notes)",
    options=MarkerOptions,
    make=_markers,
    extra=EXTRA,
    order=13,
)
