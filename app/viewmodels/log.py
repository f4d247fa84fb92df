"""The log: events as lines, limited in number, filtered by kind and text."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from datetime import datetime

from app.viewmodels.states import BAD, BLUE, GREY, ORANGE, PURPLE, SKY, StateLook
from app.words import event_text, mark, tr
from tracker.messages import Event
from tracker.session.notes import version_of

KINDS: dict[str, StateLook] = {
    "error": StateLook(BAD.colour, BAD.sign, mark("Problems")),
    "device": StateLook(BLUE, "■", mark("Devices")),
    "tracking": StateLook(SKY, "◆", mark("Tracking")),
    "load": StateLook(ORANGE, "▼", mark("Computer")),
    "recording": StateLook(PURPLE, "●", mark("Recording")),
    "note": StateLook(GREY, "✎", mark("Notes")),
}
DEVICES = {"pulse", "motor", "motor_run", "robot"}
"""Kinds of device events; kinds that are not listed belong to tracking."""


def kind_of(event: Event) -> str:
    """One of `KINDS`."""
    if event.kind in KINDS:
        return event.kind
    return "device" if event.kind in DEVICES else "tracking"


def words_of(event: Event) -> str:
    """The text for the user; empty for events that only programs read, such as gestures."""
    if event.kind == "note" and version_of(event) > 0:
        return tr("changed to: {}").format(event.text) if event.text else tr("a note was deleted")
    return event_text(event)


@dataclass(frozen=True)
class LogEntry:
    kind: str
    line: str
    colour: str


class EventLog:
    """The last ``capacity`` events."""

    def __init__(self, capacity: int = 2000) -> None:
        self.capacity = capacity
        self._entries: deque[LogEntry] = deque(maxlen=capacity)

    def add(self, event: Event, now: datetime | None = None) -> LogEntry:
        """Add an event with the time of its arrival."""
        kind = kind_of(event)
        look = KINDS[kind]
        clock = (now or datetime.now()).strftime("%H:%M:%S")
        entry = LogEntry(kind, f"{clock}  {look.sign}  {words_of(event)}", look.colour)
        self._entries.append(entry)
        return entry

    def ends_with(self, text: str) -> bool:
        """Whether one of the last few events has this text."""
        return any(e.line.endswith(text) for e in list(self._entries)[-3:])

    @staticmethod
    def shows(entry: LogEntry, kind: str, words: str) -> bool:
        """Whether an entry passes the filter; all ``words`` must occur."""
        line = entry.line.lower()
        return (not kind or entry.kind == kind) and all(w in line for w in words.lower().split())

    def entries(self, kind: str = "", words: str = "") -> list[LogEntry]:
        return [e for e in self._entries if self.shows(e, kind, words)]
