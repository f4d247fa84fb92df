"""Tags of sessions, each session's in a small file next to it.

``P01_pinch.mcap`` has ``P01_pinch.tags.json``: the session itself is never written again, so that
its bits do not change, and the tags can be copied with it to another folder or computer.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Iterable
from pathlib import Path

from tracker.base.errors import DataError, FileError
from tracker.base.files import disk_error, write_whole
from tracker.base.notices import notice

SUFFIX = ".tags.json"
MOST_BYTES = 65536
_log = logging.getLogger(__name__)


def tags_path(session: Path) -> Path:
    """The file of the session's tags; it does not exist without tags."""
    return session.with_name(session.stem + SUFFIX)


def tags_of_text(text: str) -> tuple[str, ...]:
    """Words separated by commas, each once, in their order."""
    return tuple(dict.fromkeys(" ".join(word.split()) for word in text.split(",") if word.strip()))


def read_tags(session: Path) -> tuple[str, ...]:
    """The session's tags; empty if there is no readable file."""
    path = tags_path(session)
    try:
        if path.stat().st_size > MOST_BYTES:
            raise DataError(notice("window.tags_too_large"))
        words = json.loads(path.read_text("utf-8"))["tags"]
        return tuple(word for word in words if isinstance(word, str))
    except FileNotFoundError:
        return ()
    except (OSError, ValueError, KeyError, TypeError) as error:
        _log.warning("%s contains no tags: %s", path, error)
        return ()


def write_tags(session: Path, tags: Iterable[str]) -> None:
    """Write these tags, or remove the file if there are none. Raises FileError."""
    path, words = tags_path(session), list(tags)
    try:
        if words:
            write_whole(path, json.dumps({"tags": words}, ensure_ascii=False) + "\n")
        else:
            path.unlink(missing_ok=True)
    except OSError as error:
        raise disk_error(path, error) from error


def move_tags(before: Path, after: Path) -> None:
    """Rename the tags with their session. Raises FileError."""
    path = tags_path(before)
    if not path.exists():
        return
    try:
        path.replace(tags_path(after))
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(notice("window.tags_not_moved", file=before.name, why=reason)) from error
