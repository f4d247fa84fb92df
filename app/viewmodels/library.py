"""The sessions in a folder: first the contents of their index, later quality and thumbnails."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.storage.session_tags import read_tags
from app.viewmodels.recording import duration_text, size_text
from app.viewmodels.recording_report import packets_lost
from app.viewmodels.states import BAD, GOOD, SKY, WARN, StateLook
from app.words import error_text, mark, tr
from tracker.base.errors import GlovetrackError
from tracker.session.overview import Quality, quality, thumbnail
from tracker.session.reader import SessionReader

THUMBNAIL_WIDTH = 72  # px
BEING_RECORDED = StateLook(SKY, "●", mark("being recorded"))


@dataclass(frozen=True)
class SessionRow:
    """One file; ``problem`` is a message if it cannot be replayed."""

    path: Path
    name: str
    when: str
    duration: str
    size: str
    look: StateLook
    integrity: str
    problem: str
    stamp: tuple[int, int] = (0, 0)  # modification time in ns, and size, to detect changes
    tags: tuple[str, ...] = ()

    def matches(self, words: str, quality: str = "") -> bool:
        """Whether each of the words occurs in its name, tags, date or quality."""
        text = " ".join((self.name, *self.tags, self.when, self.integrity, quality)).casefold()
        return all(word in text for word in words.casefold().split())

    @property
    def recoverable(self) -> bool:
        """Whether it was interrupted or cannot be read."""
        return self.look in (BAD, WARN)


@dataclass(frozen=True, eq=False)
class Details:
    """Contents of a session. ``image`` (h, w, 3) BGR; None without images."""

    quality: str
    look: StateLook | None
    image: NDArray[np.uint8] | None


def session_row(path: Path, recording: Path | None = None) -> SessionRow:
    """Read only the index of a file, so that an hour takes no longer than a second."""
    stat = path.stat()
    when = datetime.fromtimestamp(stat.st_mtime).strftime("%Y-%m-%d %H:%M")
    duration, look, integrity, problem = "–", BAD, tr("unreadable"), ""
    if path == recording:
        look, integrity = BEING_RECORDED, tr(BEING_RECORDED.word)
    else:
        try:
            with SessionReader(path) as reader:
                duration = duration_text(reader.duration)
                whole = reader.source.contents.finished
                look, integrity = (GOOD, tr("complete")) if whole else (WARN, tr("interrupted"))
        except GlovetrackError as error:
            problem = error_text(error)
    return SessionRow(
        path,
        path.stem,
        when,
        duration,
        size_text(stat.st_size),
        look,
        integrity,
        problem,
        (stat.st_mtime_ns, stat.st_size),
        read_tags(path),
    )


def scan(
    folder: Path, progress: Callable[[float, str], None], recording: Path | None = None
) -> list[SessionRow]:
    """All sessions of a folder, newest first; ``recording`` is the one being written."""
    if not folder.is_dir():
        return []
    paths = sorted(folder.glob("*.mcap"), key=lambda p: p.stat().st_mtime, reverse=True)
    rows = []
    for i, path in enumerate(paths):
        progress(i / len(paths), path.name)
        rows.append(session_row(path, recording))
    return rows


def read_details(
    rows: Collection[SessionRow],
    found: Callable[[SessionRow, Details], None],
    progress: Callable[[float, str], None],
) -> None:
    """Pass the details of each row to ``found``."""
    for i, row in enumerate(rows):
        progress(i / len(rows), row.name)
        if not row.problem and row.look != BEING_RECORDED:
            found(row, details(row.path))


def details(path: Path) -> Details:
    """Quality and thumbnail; a message instead of the quality if the file is damaged."""
    try:
        with SessionReader(path) as reader:
            text, look = quality_text(quality(reader))
            return Details(text, look, thumbnail(reader, THUMBNAIL_WIDTH))
    except (GlovetrackError, OSError, ValueError) as error:
        return Details(error_text(error), BAD, None)


def quality_text(q: Quality) -> tuple[str, StateLook | None]:
    """``tracked 97 %, 2 packets lost`` and its look."""
    if q.tracked is None:
        return tr("not tracked"), None
    if q.by_imus:
        lost = q.packets_lost or 0
        return f"{tr('IMUs only')}, {packets_lost(lost)}", WARN if lost else GOOD
    share = f"{100 * q.tracked:.0f}"
    text = tr("tracked {} %").format(share)
    if q.hands:
        left, right = (f"{100 * (hand.tracked or 0.0):.0f}" for hand in q.hands)
        text = tr("tracked left {}, right {} %").format(left, right)
    if q.packets_lost:
        text = f"{text}, {packets_lost(q.packets_lost)}"
    good = q.tracked >= 0.95 and not q.packets_lost
    return text, GOOD if good else WARN if q.tracked >= 0.5 else BAD
