"""Recent sessions and interrupted recordings for the start page."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from app.viewmodels.library import Details, SessionRow, details, session_row
from app.viewmodels.states import GOOD
from app.words import tr

MOST = 5
LOOKED_AT = 20  # newest files that are checked for an interrupted recording
SUFFIX = ".mcap"
POLLS, POLL_S = 12, 0.5  # checks of a recording that its process may still be finishing


@dataclass(frozen=True, eq=False)
class RecentSession:
    """``age`` as text, of the file."""

    row: SessionRow
    age: str
    details: Details


@dataclass(frozen=True, eq=False)
class Earlier:
    """``unfinished``: interrupted recordings that have not been recovered, newest first."""

    recent: tuple[RecentSession, ...]
    unfinished: tuple[Path, ...]


def with_recent(known: Sequence[str], path: Path) -> list[str]:
    """The recently used paths, ``path`` first."""
    name = str(path.absolute())
    return [name, *(p for p in known if p != name)][:MOST]


def renamed(known: Sequence[str], before: Path, path: Path) -> list[str]:
    """The recently used paths after the session ``before`` was renamed to ``path``."""
    names = {str(before.absolute()): str(path.absolute())}
    return list(dict.fromkeys(names.get(p, p) for p in known))


def newest(folder: Path) -> list[Path]:
    """Sessions of a folder, newest first."""
    try:
        found = [(p.stat().st_mtime, p) for p in folder.glob(f"*{SUFFIX}")]
    except OSError:
        return []
    return [p for _, p in sorted(found, reverse=True)]


def look_back(
    known: Sequence[str], folder: Path, now: datetime, progress: Callable[[float, str], None]
) -> Earlier:
    """Check the newest session of the folder, the recent ones, then the rest of the folder; results
    are sorted by age."""
    here = newest(folder)
    used = [Path(p) for p in known if Path(p).is_file()]
    candidates = list(dict.fromkeys([*here[:1], *used, *here]))
    recent: list[RecentSession] = []
    for path in candidates:
        if len(recent) == MOST:
            break
        progress(-1.0, path.name)
        row = session_row(path)
        if not row.problem:
            when = datetime.fromtimestamp(row.stamp[0] / 1e9)
            recent.append(RecentSession(row, age_text(when, now), details(path)))
    recent.sort(key=lambda r: r.row.stamp[0], reverse=True)
    cut = []
    for path in here[:LOOKED_AT]:
        progress(-1.0, path.name)
        if is_unfinished(path):
            cut.append(path)
    return Earlier(tuple(recent), tuple(cut))


def is_complete(path: Path, progress: Callable[[float, str], None]) -> bool:
    """Whether a recording is complete.

    Its process writes the end after the window has closed, and is given some seconds for it.
    """
    for _ in range(POLLS):
        progress(-1.0, path.name)
        if session_row(path).look is GOOD:
            return True
        time.sleep(POLL_S)
    return False


def is_unfinished(path: Path) -> bool:
    """Whether it was interrupted and has not been recovered."""
    return not recovered(path).exists() and session_row(path).recoverable


def recovered(path: Path) -> Path:
    """The path of the recovered file."""
    return path.with_name(f"{path.stem}_recovered{SUFFIX}")


def age_text(when: datetime, now: datetime) -> str:
    """``5 minutes ago``, ``yesterday``, then the date."""
    minutes = int((now - when).total_seconds() // 60)
    days = (now.date() - when.date()).days
    if minutes < 1:
        return tr("just now")
    if minutes < 60:
        return tr("1 minute ago") if minutes == 1 else tr("{} minutes ago").format(minutes)
    if days <= 0:
        return tr("today, {:%H:%M}").format(when)
    if days == 1:
        return tr("yesterday, {:%H:%M}").format(when)
    return tr("{} days ago").format(days) if days < 14 else f"{when:%Y-%m-%d}"
