"""Descriptor of the Foxglove stream."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.base.registry import deferred
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class FoxgloveOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(8765, "listening port; Foxglove's default")
    origins: str = option("", "further sites whose pages may connect, separated by commas")


STREAM = StreamKind(
    name="foxglove",
    title="Foxglove",
    options=FoxgloveOptions,
    make=deferred("extensions.foxglove.live:open_stream"),
    extra="glovetrack[streams]",
    order=40,
)
