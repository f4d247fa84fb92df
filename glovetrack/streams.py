"""What a live stream is made of: a plug-in under ``glovetrack.streams``; and streams in a program.

A `StreamKind` describes a stream: its name, its title, its options and what makes its publishers. A
`Publisher` sends one hand's estimates (`glovetrack.engine.Estimate`); `Names` has the names of
their rows. See ``docs/streaming.md``.
"""

from tracker.messages import Estimate
from tracker.streaming.attach import attach
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import (
    StreamError,
    StreamKind,
    StreamSettings,
    open_streams,
    option,
    read_settings,
)

__all__ = [
    "Estimate",
    "Names",
    "Publisher",
    "StreamError",
    "StreamKind",
    "StreamSettings",
    "attach",
    "open_streams",
    "option",
    "read_settings",
    "to_json",
]
