"""Descriptor of VMC as a stream."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class VmcOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(39540, "destination port; that of a VMC Marionette")
    velocity: bool = option(True, "whether velocities follow each pose in a bundle of their own")


def _vmc(options: VmcOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.osc.vmc import VmcPublisher

    for names in hands:
        yield VmcPublisher(names.model, options.host, options.port, names, options.velocity)


VMC = StreamKind(name="vmc", title="VMC (OSC, avatars)", options=VmcOptions, make=_vmc, order=20)
