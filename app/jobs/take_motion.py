"""A take read for its motion, beside the window."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from app.platform.tasks import JobProgress
from app.words import tr
from tracker.base.errors import FileError
from tracker.session.motion import Take, read_take
from tracker.session.reader import SessionReader


def read_motion(path: Path, side: str = "") -> Callable[[JobProgress], Take | None]:
    """A job; None where the session has no estimates. ``side``: of the hand, of two."""

    def job(progress: JobProgress) -> Take | None:
        with SessionReader(path, watch=progress, side=side) as reader:
            try:
                return read_take(reader)
            except FileError:
                return None

    return job


def csv_of(text: str, path: Path) -> None:
    """Write a table. Raises FileError."""
    try:
        path.write_text(text, "utf-8", newline="")
    except OSError as error:
        words = tr("{} cannot be written: {}.")
        raise FileError(words.format(path, error.strerror or error)) from error
