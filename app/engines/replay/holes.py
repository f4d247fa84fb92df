"""Where a replayed hand has no estimates for a while: found by reading ahead."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from itertools import islice

from app.engines.replay.hands import OfFile
from tracker.messages import Estimate
from tracker.session.holes import is_hole

AHEAD_S = 0.4
"""How far is read ahead for the next estimate; on an overloaded computer they arrive late, in
bursts, but have no hole between their instants."""


def marked(messages: Iterable[OfFile]) -> Iterator[tuple[OfFile, bool]]:
    """Each message, and whether it is an estimate after which its hand has a hole.

    At the file's end there is none unless something else goes on for longer than `AHEAD_S`.
    """
    coming, waiting, is_end = iter(messages), deque[OfFile](), False
    while True:
        while not is_end and not (waiting and _is_decided(waiting)):
            read = next(coming, None)
            is_end = read is None
            if read is not None:
                waiting.append(read)
        if not waiting:
            return
        is_last = _is_decided(waiting) and _is_last(waiting)
        yield waiting.popleft(), is_last


def _is_decided(waiting: deque[OfFile]) -> bool:
    """Whether enough was read ahead for `_is_last` of the first one."""
    first = waiting[0]
    if not isinstance(first.message, Estimate):
        return True
    is_far = waiting[-1].arrival - first.arrival > AHEAD_S
    return is_far or _next_estimate(waiting) is not None


def _is_last(waiting: deque[OfFile]) -> bool:
    """Whether a hole begins with the first one."""
    message, found = waiting[0].message, _next_estimate(waiting)
    return isinstance(message, Estimate) and (found is None or is_hole(message.t, found.t))


def _next_estimate(waiting: deque[OfFile]) -> Estimate | None:
    """The one of the same hand that follows the first one."""
    side = waiting[0].side
    for read in islice(waiting, 1, None):
        if read.side == side and isinstance(read.message, Estimate):
            return read.message
    return None
