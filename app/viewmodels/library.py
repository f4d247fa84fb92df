"""The sessions in a folder."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from app.viewmodels.recording import duration_text, size_text
from app.viewmodels.states import BAD, GOOD, WARN, Look
from tracker.errors import GlovetrackError
from tracker.session.reader import SessionReader


@dataclass(frozen=True)
class SessionRow:
    """One file on screen; ``problem`` is a sentence where it cannot be replayed."""

    path: Path
    name: str
    when: str
    duration: str
    size: str
    look: Look
    integrity: str
    problem: str


def session_row(path: Path) -> SessionRow:
    """Look into a file: its index alone is read, so that an hour takes no longer than a second."""
    stat = path.stat()
    when = datetime.fromtimestamp(stat.st_mtime).strftime("%Y-%m-%d %H:%M")
    duration, look, integrity, problem = "–", BAD, "unreadable", ""
    try:
        with SessionReader(path) as reader:
            duration = duration_text(reader.duration)
            whole = reader.source.contents.finished
            look, integrity = (GOOD, "whole") if whole else (WARN, "cut off")
    except GlovetrackError as error:
        problem = str(error)
    return SessionRow(
        path, path.stem, when, duration, size_text(stat.st_size), look, integrity, problem
    )


def scan(folder: Path, progress: Callable[[float, str], None]) -> list[SessionRow]:
    """All sessions of a folder, newest first."""
    if not folder.is_dir():
        return []
    paths = sorted(folder.glob("*.mcap"), key=lambda p: p.stat().st_mtime, reverse=True)
    rows = []
    for i, path in enumerate(paths):
        progress(i / len(paths), path.name)
        rows.append(session_row(path))
    return rows
