"""What OpenXR adds to the program: the stream that layers read; `command` has the commands."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.base.registry import deferred
from tracker.streaming.connection import option
from tracker.streaming.registry import StreamKind

MOST_AHEAD_MS = 100


@dataclass(frozen=True)
class OpenXrOptions:
    """The default puts a table, on which G's origin is, below and in front of a seated user."""

    space: str = option(
        "local", "reference space of the placement: local or stage", ("local", "stage")
    )
    x: float = option(0.0, "position of Glovetrack's origin in that space, m to the right")
    y: float = option(-0.45, "m up")
    z: float = option(-0.25, "m backwards")
    yaw: float = option(0.0, "how far Glovetrack's forward direction is turned to the left, deg")
    ahead_ms: int = option(50, "how far poses are predicted beyond the newest sample at most, ms")


STREAM = StreamKind(
    name="openxr",
    title="OpenXR applications",
    options=OpenXrOptions,
    make=deferred("extensions.openxr.publisher:open_stream"),
    order=21,
)
