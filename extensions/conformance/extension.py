"""Descriptor of the stream that writes a record for NVIDIA's Isaac tools."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from tracker.streaming.connection import StreamError, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class IsaacOptions:
    file: str = option("", "the new file of the record")


def _make(options: IsaacOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.conformance.stream import IsaacPublisher

    if not options.file:
        raise StreamError("The Isaac record needs a file: isaac:take.mcap.")
    first, *others = (names.with_openxr() for names in hands)
    record = IsaacPublisher(first, Path(options.file))
    yield record
    yield from map(record.beside, others)


STREAM = StreamKind(
    name="isaac",
    title="Isaac record (MCAP)",
    options=IsaacOptions,
    make=_make,
    default_file="hands.mcap",
    order=50,
)
