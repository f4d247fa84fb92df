"""Words that the user puts on sessions, each session's in a small file beside it.

``P01_pinch.mcap`` has ``P01_pinch.tags.json``: the session itself is never written again, so that
its bits stay those that were recorded, and the words go with it to another folder or computer.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Iterable
from pathlib import Path

from app.words import tr
from tracker.base.errors import FileError
from tracker.base.files import disk_error, write_whole

SUFFIX = ".tags.json"
MOST_BYTES = 65536
_log = logging.getLogger(__name__)


def tags_path(session: Path) -> Path:
    """Where the session's words are kept; there is no file while it has none."""
    return session.with_name(session.stem + SUFFIX)


def tags_of_text(text: str) -> tuple[str, ...]:
    """Words between commas, each once, in the order in which they were written."""
    return tuple(dict.fromkeys(" ".join(word.split()) for word in text.split(",") if word.strip()))


def read_tags(session: Path) -> tuple[str, ...]:
    """The session's words; none where there is no such file, or none that can be read."""
    path = tags_path(session)
    try:
        if path.stat().st_size > MOST_BYTES:
            raise ValueError(tr("it is too large"))
        words = json.loads(path.read_text("utf-8"))["tags"]
        return tuple(word for word in words if isinstance(word, str))
    except FileNotFoundError:
        return ()
    except (OSError, ValueError, KeyError, TypeError) as error:
        _log.warning("%s holds no tags: %s", path, error)
        return ()


def write_tags(session: Path, tags: Iterable[str]) -> None:
    """Keep these words, or remove the file where there are none. Raises FileError."""
    path, words = tags_path(session), list(tags)
    try:
        if words:
            write_whole(path, json.dumps({"tags": words}, ensure_ascii=False) + "\n")
        else:
            path.unlink(missing_ok=True)
    except OSError as error:
        raise disk_error(path, error) from error


def move_tags(before: Path, after: Path) -> None:
    """The session has another name. Raises FileError."""
    path = tags_path(before)
    if not path.exists():
        return
    try:
        path.replace(tags_path(after))
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(
            tr("The tags of {} were not moved with it: {}.").format(before.name, reason)
        ) from error
