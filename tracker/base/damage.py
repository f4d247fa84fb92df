"""Damaged messages of a session, which are skipped and counted.

Readers of a session skip such a message and continue. `gather` collects the skipped messages of all
files that a task opens, for the summary at its end.
"""

from __future__ import annotations

import struct
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.notices import Notice, warning

MOST_COUNTED = 100_000  # messages of a file; later ones are not counted
MOST_NAMED = 8  # topics in a summary
DAMAGE = (ValueError, KeyError, TypeError, IndexError, OverflowError, struct.error, FileError)
"""Exceptions that decoding a damaged message may raise."""


class LeftOut:
    """The damaged messages of one file, which were skipped.

    A message that is read several times counts once. May be used by several threads.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._found: set[tuple[str, int]] = set()
        gathered = _gathered.get()
        if gathered is not None:
            gathered.append(self)

    def add(self, topic: str, log_time: int) -> None:
        """Counts the message of ``topic`` with ``log_time`` (ns)."""
        if len(self._found) < MOST_COUNTED:
            self._found.add((topic, log_time))

    @contextmanager
    def reading(self, topic: str, log_time: int) -> Iterator[None]:
        """Suppresses the errors of a damaged message in the block."""
        try:
            yield
        except DAMAGE:
            self.add(topic, log_time)

    def merge(self, other: LeftOut) -> None:
        """Adds the messages that ``other`` has found in the same file."""
        for topic, log_time in other._found:
            self.add(topic, log_time)

    def __len__(self) -> int:
        return len(self._found)

    def by_topic(self) -> dict[str, int]:
        """Returns the numbers by topic, in alphabetical order."""
        return dict(sorted(Counter(topic for topic, _ in self._found).items()))

    def report(self) -> Notice:
        """What was ignored, by topic."""
        counts = list(self.by_topic().items())
        named = [warning("session.damaged_topic", count=n, topic=t) for t, n in counts[:MOST_NAMED]]
        more = len(counts) - MOST_NAMED
        if more > 0:
            named.append(warning("session.damaged_more", count=more))
        return warning("session.messages_damaged", file=self.path.name, topics=named)


_gathered: ContextVar[list[LeftOut] | None] = ContextVar("gathered", default=None)


@contextmanager
def gather() -> Iterator[list[LeftOut]]:
    """What is left out of the files that this thread opens within the block."""
    found: list[LeftOut] = []
    token = _gathered.set(found)
    try:
        yield found
    finally:
        _gathered.reset(token)


def pass_on(found: Iterable[LeftOut]) -> None:
    """Add what another process has gathered to what this thread gathers, if it does."""
    gathered = _gathered.get()
    if gathered is not None:
        gathered.extend(found)


def merged(found: Iterable[LeftOut]) -> list[LeftOut]:
    """One for each file of which something was left out."""
    by_path: dict[Path, LeftOut] = {}
    for each in list(found):
        if len(each):
            by_path.setdefault(each.path, LeftOut(each.path)).merge(each)
    return list(by_path.values())


def reports(found: Iterable[LeftOut]) -> list[Notice]:
    """One for each file of which something was ignored."""
    return [each.report() for each in merged(found)]
