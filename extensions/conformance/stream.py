"""Writes live estimates as a record of NVIDIA's Isaac tools.

Estimates that were replaced by newer ones before they were written are missing; a session and its
export contain all of them.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

from extensions.conformance.extension import IsaacOptions
from extensions.conformance.isaac.record import HandRecord, Stamps, joints_of
from extensions.conformance.isaac.writer import IsaacWriter
from tracker.base.notices import Notice, notice, warning
from tracker.messages import Estimate
from tracker.streaming.payload import openxr_of
from tracker.streaming.publisher import Names, OtherHand, Publisher, StreamError


class IsaacPublisher:
    """Writes to a new file, which is complete once the publisher is closed.

    ``tips``: also write the wrist and each fingertip as a tracker of its own.
    Raises StreamError if the file exists or cannot be created, or if ``names`` lack OpenXR's radii.
    """

    def __init__(
        self,
        names: Names,
        path: Path,
        clock_ns: Callable[[], int] = time.monotonic_ns,
        tips: bool = False,
    ) -> None:
        if not names.openxr:
            raise StreamError(notice("isaac.needs_openxr"))
        self._names, self._clock_ns, self._tips = names, clock_ns, tips
        self.name = notice("isaac.record", file=path.name)
        try:
            self._file = path.open("xb")
        except OSError as error:
            raise StreamError(notice("file.not_created", path=path, why=error.strerror)) from error
        self._writer = IsaacWriter(self._file)
        self._last = self._count = 0
        self._writing = threading.Lock()

    def send(self, estimate: Estimate) -> None:
        self._send(self._names, estimate)

    def for_other_hand(self, names: Names) -> OtherHand:
        """A publisher of another hand to the same record."""
        return OtherHand(self.name, partial(self._send, names))

    def _send(self, names: Names, estimate: Estimate) -> None:
        with self._writing:  # each hand has its own thread
            self._write(names, estimate)

    def _write(self, names: Names, estimate: Estimate) -> None:
        if self._file.closed:
            raise StreamError(notice("stream.closed", what="Isaac record"))
        sample = round(estimate.t * 1e9)
        available = self._last = max(self._clock_ns(), sample, self._last)
        hand = openxr_of(estimate, names)
        stamps = Stamps(available, sample, sample)
        self._count += 1
        self._writer.write(names.side, HandRecord(stamps, joints_of(hand)))
        if self._tips:
            self._writer.write_tips(names.side, stamps, hand)

    def probe(self) -> Notice:
        """Whether hands are written: a file has no receiver."""
        if not self._count:
            return warning("stream.test_nothing", stream=self.name)
        return notice("isaac.test_written", stream=self.name, count=self._count)

    def close(self) -> None:
        with self._writing:
            if not self._file.closed:
                self._writer.finish()
                self._file.close()


def open_stream(options: IsaacOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    """Yields the publisher of each hand."""
    if not options.file:
        raise StreamError(notice("isaac.no_file"))
    first, *others = (names.with_openxr() for names in hands)
    record = IsaacPublisher(first, Path(options.file), tips=options.tips)
    yield record
    yield from map(record.for_other_hand, others)
