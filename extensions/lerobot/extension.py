"""Descriptors of the LeRobot export."""

from __future__ import annotations

from tracker.base.registry import deferred
from tracker.session.export.formats import ExportFormat

FORMAT = ExportFormat(
    "lerobot",
    "Data set for robot learning (LeRobot, a folder)",
    dataset=deferred("extensions.lerobot.export:export_lerobot").load,
    options=("rate", "start", "stop", "anonymous", "dataset"),
    both_hands=True,
    folder=True,
    extra="glovetrack[parquet]",
    order=190,
)
