"""Reads messages of a file in the order of their log times, with little memory."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator
from typing import NamedTuple

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.session.mcap.input import FOREVER, McapInput, RawMessage
from tracker.session.mcap.records import LIMIT
from tracker.session.mcap.spans import Span

_PER_MESSAGE = 400  # bytes in memory in addition to its data


def ordered(
    source: McapInput,
    topics: frozenset[str] | None = None,
    start: int = 0,
    end: int = FOREVER,
    rank: Callable[[str], int] = lambda topic: 0,
) -> Iterator[RawMessage]:
    """Yields messages with start ≤ log_time < end (ns), sorted by log_time, ``rank``, position.

    ``rank``: of the topic. A span is read when its first log time is reached, so only overlapping
    spans are in memory. Raises FileError on damage, or if too many spans overlap.
    """
    heap: list[tuple[int, int, int, int, RawMessage]] = []
    held = 0
    for span in source.spans_with(topics, start, end):
        while heap and heap[0][0] < span.start:
            message = heapq.heappop(heap)[4]
            held -= len(message.data) + _PER_MESSAGE
            yield message
        for i, m in enumerate(source.messages_in(span, topics)):
            if start <= m.log_time < end:
                heapq.heappush(heap, (m.log_time, rank(m.topic), span.offset, i, m))
                held += len(m.data) + _PER_MESSAGE
        if held > LIMIT:
            raise FileError(notice("session.not_orderable", path=source.path))
    while heap:
        yield heapq.heappop(heap)[4]


def last_before(
    source: McapInput,
    topic: str,
    time: int,
    check: Callable[[RawMessage], None] = lambda raw: None,
) -> RawMessage | None:
    """The latest undamaged message of a topic with log_time < ``time`` (ns), of equal ones the last
    in the file. ``check`` raises one of `tracker.base.damage.DAMAGE` for a damaged message."""
    wanted = frozenset([topic])
    best: _OrderedMessage | None = None
    for span in source.spans_with(wanted, 0, time, back=True):
        best = _latest_in(source, span, wanted, time, check)
        if best is not None:
            break
    if best is None:
        return None
    # Spans overlap: one that begins earlier may contain a later message.
    for span in source.spans_with(wanted, best.place[0], time):
        if span.end >= best.place[0]:
            other = _latest_in(source, span, wanted, time, check, best.place)
            best = other or best
    return best.message


class _OrderedMessage(NamedTuple):
    """A message, and its log time (ns), span's offset and position in the span."""

    place: tuple[int, int, int]
    message: RawMessage


def _latest_in(
    source: McapInput,
    span: Span,
    wanted: frozenset[str],
    time: int,
    check: Callable[[RawMessage], None],
    after: tuple[int, int, int] = (-1, 0, 0),
) -> _OrderedMessage | None:
    """The latest undamaged message of a span before ``time`` (ns); None unless it is after
    ``after``."""
    found = [
        _OrderedMessage((m.log_time, span.offset, i), m)
        for i, m in enumerate(source.messages_in(span, wanted))
        if m.log_time < time
    ]
    for placed in sorted(found, key=lambda p: p.place, reverse=True):
        if placed.place <= after:
            return None
        with source.left_out.reading(placed.message.topic, placed.message.log_time):
            check(placed.message)
            return placed
    return None
