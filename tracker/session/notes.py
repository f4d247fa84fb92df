"""Notes that were changed while their session was recorded: the file contains each wording.

Messages are only appended to a recording, so that a killed one loses nothing. A note has a number
and the number of its wording; a later wording, stamped as the first, replaces it, and an empty one
deletes it.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tracker.messages import Event

NUMBER, WORDING = "note", "wording"


def numbered(number: int, wording: int) -> dict[str, object]:
    """Data of the event with the ``wording``-th text, from 0, of a session's note ``number``."""
    return {NUMBER: number, WORDING: wording}


def wording_of(event: Event) -> int:
    """0 for an event that was not changed."""
    return _whole(event.data.get(WORDING), 0)


def standing(events: Iterable[Event]) -> list[Event]:
    """Events in their order, each note in its last wording; deleted ones are left out."""
    latest: dict[object, Event] = {}
    for index, event in enumerate(events):
        number = _whole(event.data.get(NUMBER), -1) if event.kind == "note" else -1
        key: object = number if number >= 0 else ("unnumbered", index)
        if key not in latest or wording_of(event) >= wording_of(latest[key]):
            latest[key] = event
    return [e for e in latest.values() if e.kind != "note" or e.text]


def _whole(value: Any, otherwise: int) -> int:
    return value if type(value) is int else otherwise
