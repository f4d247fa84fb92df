"""Descriptors of Open Sound Control: VMC as a stream, and requests as remote control."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind
from tracker.streaming.remote.doors import DatagramDoor, Door
from tracker.streaming.remote.reception import Answer
from tracker.streaming.remote.registry import DoorKind


@dataclass(frozen=True)
class VmcOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(39540, "destination port; that of a VMC Marionette")
    velocity: bool = option(True, "whether velocities follow each pose in a bundle of their own")


@dataclass(frozen=True)
class OscOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(9761, "listening port")


def _vmc(options: VmcOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.osc.vmc import VmcPublisher

    for names in hands:
        yield VmcPublisher(names.model, options.host, options.port, names, options.velocity)


def _requests(options: OscOptions, answer: Answer) -> Door:
    return osc_door(answer, options.host, options.port)


def osc_door(answer: Answer, host: str, port: int) -> Door:
    """Requests as OSC messages over UDP. Raises StreamError."""
    from extensions.osc.requests import encode, parse

    return DatagramDoor("OSC", (parse, encode), answer, host, port)


VMC = StreamKind(name="vmc", title="VMC (OSC, avatars)", options=VmcOptions, make=_vmc, order=20)
REMOTE = DoorKind(name="osc", title="OSC", options=OscOptions, make=_requests, order=11)
