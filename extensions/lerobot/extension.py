"""Descriptors of the LeRobot export."""

from __future__ import annotations

from tracker.session.export.formats import DatasetWriter, ExportFormat


def _lerobot() -> DatasetWriter:
    from extensions.lerobot.export import export_lerobot

    return export_lerobot


FORMAT = ExportFormat(
    "lerobot",
    "Data set for robot learning (LeRobot, a folder)",
    dataset=_lerobot,
    options=("rate", "start", "stop", "anonymous", "dataset"),
    both_hands=True,
    folder=True,
    extra="glovetrack[parquet]",
    order=190,
)
