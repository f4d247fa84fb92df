"""The files of a headless report, known before the window is imported."""

from __future__ import annotations

from pathlib import Path

from tracker.base.files import check_target, disk_error
from tracker.hand.names import SIDES


def report_paths(out: Path) -> list[Path]:
    """All files that a report may write to the folder ``out``."""
    tables = [f"session{side}.csv" for side in ("", *(f"_{side}" for side in SIDES))]
    names = ["session.mcap", *tables, *(f"{table}.json" for table in tables), "window.png"]
    return [out / name for name in names]


def check_report(out: Path, force: bool = False) -> None:
    """Raises FileError where the folder has one of these files, unless ``force``."""
    for path in report_paths(out):
        check_target(path, force)


def make_room(out: Path) -> None:
    """Make the folder, and delete the files of an earlier report in it. Raises DiskError."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        for path in report_paths(out):
            path.unlink(missing_ok=True)
    except OSError as error:
        raise disk_error(out, error) from error
