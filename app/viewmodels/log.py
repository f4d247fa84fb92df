"""The log: events as lines, bounded, filtered by kind and by words."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from datetime import datetime

from app.viewmodels.states import BAD, BLUE, GREY, PURPLE, SKY, Look
from tracker.messages import Event

KINDS: dict[str, Look] = {
    "error": Look(BAD.colour, BAD.sign, "Problems"),
    "device": Look(BLUE, "■", "Devices"),
    "tracking": Look(SKY, "◆", "Tracking"),
    "recording": Look(PURPLE, "●", "Recording"),
    "note": Look(GREY, "✎", "Notes"),
}


@dataclass(frozen=True)
class Entry:
    kind: str
    line: str
    colour: str


class Log:
    """The last ``capacity`` events."""

    def __init__(self, capacity: int = 2000) -> None:
        self.capacity = capacity
        self._entries: deque[Entry] = deque(maxlen=capacity)

    def add(self, event: Event, now: datetime | None = None) -> Entry:
        """Take an event; its line carries the wall clock's time of arrival."""
        look = KINDS.get(event.kind, KINDS["note"])
        clock = (now or datetime.now()).strftime("%H:%M:%S")
        entry = Entry(event.kind, f"{clock}  {look.sign}  {event.text}", look.colour)
        self._entries.append(entry)
        return entry

    @staticmethod
    def shows(entry: Entry, kind: str, words: str) -> bool:
        """Whether an entry passes the filter; all ``words`` must occur."""
        line = entry.line.lower()
        return (not kind or entry.kind == kind) and all(w in line for w in words.lower().split())

    def entries(self, kind: str = "", words: str = "") -> list[Entry]:
        return [e for e in self._entries if self.shows(e, kind, words)]
