"""Descriptors of the core's own streams and of its own protocols of remote control."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.base.registry import deferred
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.payload import LATEST, SCHEMAS
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind
from tracker.streaming.remote.client import UDP_PORT
from tracker.streaming.remote.doors import Door, WebSocketDoor, udp_door
from tracker.streaming.remote.reception import Answer
from tracker.streaming.remote.registry import DoorKind
from tracker.streaming.udp import DEFAULT_PORT, UdpPublisher

SCHEMA_HELP = "version of the JSON messages: 2, or 1 for programs that read only that"
EXTRA = "glovetrack[streams]"


@dataclass(frozen=True)
class UdpOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(DEFAULT_PORT, "destination port")
    schema: int = option(LATEST, SCHEMA_HELP, SCHEMAS)


@dataclass(frozen=True)
class WebSocketOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(9751, "listening port")
    schema: int = option(LATEST, SCHEMA_HELP, SCHEMAS)


@dataclass(frozen=True)
class UdpDoorOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(UDP_PORT, "listening port")


@dataclass(frozen=True)
class WebSocketDoorOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(9762, "listening port")


def _udp(options: UdpOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    for names in hands:
        yield UdpPublisher(names, options.host, options.port, options.schema)


def _udp_door(options: UdpDoorOptions, answer: Answer) -> Door:
    return udp_door(answer, options.host, options.port)


def _websocket_door(options: WebSocketDoorOptions, answer: Answer) -> Door:
    return WebSocketDoor(answer, options.host, options.port)


UDP = StreamKind(name="udp", title="UDP (JSON)", options=UdpOptions, make=_udp, order=10)
WEBSOCKET = StreamKind(
    name="websocket",
    title="WebSocket (JSON)",
    options=WebSocketOptions,
    make=deferred("tracker.streaming.websocket:open_stream"),
    extra=EXTRA,
    order=11,
)
UDP_DOOR = DoorKind(
    name="udp", title="UDP (JSON, words)", options=UdpDoorOptions, make=_udp_door, order=10
)
WEBSOCKET_DOOR = DoorKind(
    name="websocket",
    title="WebSocket (JSON)",
    options=WebSocketDoorOptions,
    make=_websocket_door,
    extra=EXTRA,
    order=12,
)
