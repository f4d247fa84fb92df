"""Reporting and recording: events for the log, every message for the disk."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

from tracker.base.channels import Fifo
from tracker.base.notices import Notice, Outbox
from tracker.live.recording import Recorder, RecordingThread
from tracker.messages import Event, Message

EVENTS_STORED = 2000  # until they are drained


class Watch(Protocol):
    """Watches messages and reports what it notices."""

    @property
    def notices(self) -> Outbox: ...


class Journal:
    """Methods may be called from any thread; `open` and `detach` by one at a time."""

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._events: Fifo[Event] = Fifo(EVENTS_STORED)
        self._disk: RecordingThread | None = None

    def report(self, kind: str, what: Notice) -> None:
        """A notice for the log and the recording, stamped now."""
        self.add(Event.of(self._clock(), kind, what))

    def report_all(self, kind: str, watch: Watch | None) -> None:
        """Reports what a watch has noticed since the last call; nothing for None."""
        for found in watch.notices.drain() if watch is not None else ():
            self.report(kind, found)

    def note(self, text: str, t: float | None, data: Mapping[str, object]) -> None:
        """A note of the user's, stamped ``t`` (s), or now where that is None."""
        self.add(Event(self._clock() if t is None else t, "note", text, dict(data)))

    def add(self, event: Event) -> None:
        """Adds an event of a device, with its own stamp."""
        self._events.put(event)
        self.record(event)

    def drain_events(self) -> list[Event]:
        """The events since the last call, oldest first."""
        return self._events.drain()

    def record(self, message: Message, side: str = "") -> None:
        """Passes a message to the disk thread; does nothing while no recording is running.

        ``side``: the hand of the message.
        """
        disk = self._disk
        if disk is not None:
            disk.put(message, side)

    @property
    def recording(self) -> bool:
        """Whether messages are recorded."""
        return self._disk is not None

    def open(self, recorder: Recorder) -> None:
        """Starts recording into ``recorder``."""
        self._disk = RecordingThread(recorder, self.report)

    def detach(self) -> RecordingThread | None:
        """Stops recording. The caller must finish the returned recording, which may block."""
        before, self._disk = self._disk, None
        return before

    def figures(self) -> dict[str, float]:
        """Returns how much the disk could not write in time."""
        disk = self._disk
        if disk is None:
            return {}
        return {"pictures_thinned": disk.thinned, "messages_unrecorded": disk.overflowed}
