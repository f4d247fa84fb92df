"""Messages between the window and the outputs' process."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tracker.base.notices import Notice
from tracker.streaming.streams import StreamCounts


@dataclass(frozen=True)
class StreamRequest:
    """A request ``number`` about the stream ``key``, with its arguments."""

    number: int
    do: str
    key: int
    data: Any = None


@dataclass(frozen=True)
class StreamReply:
    """``problem``: why it could not be done."""

    number: int
    result: Any = None
    problem: Notice | None = None


@dataclass(frozen=True)
class Counted:
    """The counts of all open streams, by key."""

    counts: dict[int, tuple[StreamCounts, ...]]


@dataclass(frozen=True)
class Reported:
    """A notice of a stream, such as a failure."""

    key: int
    what: Notice
