"""Notes that were edited during the recording: the file contains each version.

Messages are only appended to a recording, so that nothing is lost if the process is killed. A note
has a number and a version number; a later version, with the stamp of the first, replaces it, and an
empty one deletes it.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tracker.messages import Event

NUMBER, WORDING = "note", "wording"


def numbered(number: int, wording: int) -> dict[str, object]:
    """Data of the event with version ``wording``, from 0, of a session's note ``number``."""
    return {NUMBER: number, WORDING: wording}


def version_of(event: Event) -> int:
    """The version of a note; 0 for an event that was not edited."""
    return _whole(event.data.get(WORDING), 0)


def latest_versions(events: Iterable[Event]) -> list[Event]:
    """Events in order, each note in its last version; deleted ones are left out."""
    latest: dict[object, Event] = {}
    for index, event in enumerate(events):
        number = _whole(event.data.get(NUMBER), -1) if event.kind == "note" else -1
        key: object = number if number >= 0 else ("unnumbered", index)
        if key not in latest or version_of(event) >= version_of(latest[key]):
            latest[key] = event
    return [e for e in latest.values() if e.kind != "note" or e.text]


def _whole(value: Any, otherwise: int) -> int:
    return value if type(value) is int else otherwise
