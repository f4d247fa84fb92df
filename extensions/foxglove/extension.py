"""Descriptor of the Foxglove stream."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class FoxgloveOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(8765, "listening port; Foxglove's default")
    origins: str = option("", "further sites whose pages may connect, separated by commas")


def _make(options: FoxgloveOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.foxglove.live import FoxglovePublisher

    origins = [o.strip() for o in options.origins.split(",") if o.strip()]
    first, *others = hands
    server = FoxglovePublisher(first, options.host, options.port, origins=origins, others=others)
    yield server
    yield from map(server.beside, others)


STREAM = StreamKind(
    name="foxglove",
    title="Foxglove",
    options=FoxgloveOptions,
    make=_make,
    extra="glovetrack[streams]",
    order=40,
)
