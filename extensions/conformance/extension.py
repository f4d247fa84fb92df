"""Descriptors of the conformance extension: command, stream and export of Isaac records."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.base.registry import deferred
from tracker.session.export.formats import ExportFormat
from tracker.streaming.connection import option
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class IsaacOptions:
    file: str = option("", "the new file of the record")
    tips: bool = option(True, "whether wrist and fingertips are also trackers of their own")


STREAM = StreamKind(
    name="isaac",
    title="Isaac record (MCAP)",
    options=IsaacOptions,
    make=deferred("extensions.conformance.stream:open_stream"),
    default_file="hands.mcap",
    order=50,
)


FORMAT = ExportFormat(
    "isaac",
    "Hand record of NVIDIA's Isaac tools (MCAP)",
    deferred("extensions.conformance.run:export_isaac").load,
    options=("rate", "start", "stop", "anonymous"),
    both_hands=True,
    order=180,
)
