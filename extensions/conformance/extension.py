"""Descriptors of the conformance extension: command, stream and export of Isaac records."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from tracker.base.notices import notice
from tracker.base.registry import deferred
from tracker.session.export.formats import ExportFormat
from tracker.streaming.connection import StreamError, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class IsaacOptions:
    file: str = option("", "the new file of the record")
    tips: bool = option(True, "whether wrist and fingertips are also trackers of their own")


def _make(options: IsaacOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.conformance.stream import IsaacPublisher

    if not options.file:
        raise StreamError(notice("isaac.no_file"))
    first, *others = (names.with_openxr() for names in hands)
    record = IsaacPublisher(first, Path(options.file), tips=options.tips)
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


FORMAT = ExportFormat(
    "isaac",
    "Hand record of NVIDIA's Isaac tools (MCAP)",
    deferred("extensions.conformance.export:export_isaac").load,
    options=("rate", "start", "stop", "anonymous"),
    both_hands=True,
    order=180,
)
