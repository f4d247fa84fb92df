"""Descriptor of VMC as a stream."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.base.registry import deferred
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class VmcOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(39540, "destination port; that of a VMC Marionette")
    velocity: bool = option(True, "whether velocities follow each pose in a bundle of their own")


VMC = StreamKind(
    name="vmc",
    title="VMC (OSC, avatars)",
    options=VmcOptions,
    make=deferred("extensions.osc.vmc:open_stream"),
    order=20,
)
