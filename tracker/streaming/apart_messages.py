"""What passes between the window and the process of the outputs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tracker.base.notices import Notice
from tracker.messages import Estimate
from tracker.streaming.streams import StreamCounts


@dataclass(frozen=True)
class Sent:
    """An estimate of the hand ``hand``, in the order of the session's hands."""

    hand: int
    estimate: Estimate


@dataclass(frozen=True)
class Asked:
    """A request ``number`` about the stream ``key``, and what it needs."""

    number: int
    do: str
    key: int
    data: Any = None


@dataclass(frozen=True)
class Answered:
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
    """What a stream reports, such as that it fails."""

    key: int
    what: Notice
