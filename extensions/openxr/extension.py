"""What OpenXR adds to the program: the stream that layers read; `command` has the commands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.base.notices import notice
from tracker.streaming.connection import StreamError, option
from tracker.streaming.publisher import Names, Publisher
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


def _make(options: OpenXrOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.openxr.layout import Space
    from extensions.openxr.publisher import OpenXrPublisher, WorldPlacement

    spaces = {space.name.lower(): space for space in Space}
    if options.space not in spaces:
        raise StreamError(
            notice("option.choice", option="space", known=tuple(spaces), value=options.space)
        )
    if not 0 <= options.ahead_ms <= MOST_AHEAD_MS:
        raise StreamError(notice("option.range", option="ahead_ms", low=0, high=MOST_AHEAD_MS))
    position = options.x, options.y, options.z
    placement = WorldPlacement(
        spaces[options.space], position, options.yaw, options.ahead_ms / 1000
    )
    first, *others = (names.with_openxr() for names in hands)
    publisher = OpenXrPublisher(first, placement)
    yield publisher
    yield from map(publisher.beside, others)


STREAM = StreamKind(
    name="openxr",
    title="OpenXR applications",
    options=OpenXrOptions,
    make=_make,
    order=21,
)
