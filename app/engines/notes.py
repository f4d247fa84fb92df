"""The notes of the present recording; they can be changed until it ends."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Protocol

from PySide6.QtCore import QObject, Signal

from tracker.base.clock import monotonic
from tracker.session.notes import numbered


class NoteWriter(Protocol):
    """Writes a note to the log and to the file."""

    def __call__(self, text: str, t: float, data: Mapping[str, object]) -> None: ...


@dataclass(frozen=True)
class Note:
    """``t`` s of the monotonic clock: when the user began to write it; ``data`` is part of it."""

    t: float
    text: str
    wording: int = 0
    data: Mapping[str, object] = field(default_factory=dict)


class Notes(QObject):
    """``current`` are the notes by number; those before a recording are only logged."""

    changed = Signal()

    def __init__(
        self,
        write: NoteWriter,
        parent: QObject | None = None,
        clock: Callable[[], float] = monotonic,
    ) -> None:
        super().__init__(parent)
        self._write, self._clock = write, clock
        self._next = 0
        self._is_recording = False
        self._recording = 0  # the number of recordings so far
        self.current: dict[int, Note] = {}

    def now(self) -> float:
        """The time stamp of a note that the user begins to write."""
        return self._clock()

    def begin(self) -> None:
        """Begin with the notes of a recording."""
        self._is_recording, self._next, self.current = True, 0, {}
        self._recording += 1
        self.changed.emit()

    def end(self) -> None:
        """The recording has ended: its notes are final."""
        self._is_recording, self.current = False, {}
        self.changed.emit()

    def add(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None:
        """Add a note; ``t`` is the `now` of its key press."""
        note = Note(self.now() if t is None else t, text, data=data or {})
        number, self._next = self._next, self._next + 1
        self._write(
            text, note.t, {**note.data, **(numbered(number, 0) if self._is_recording else {})}
        )
        if self._is_recording:
            self.current[number] = note
            self.changed.emit()

    def change(self, number: int, text: str) -> None:
        """Change the text of a note but not its time. Does nothing if the note was deleted."""
        note = self.current.get(number)
        if note is None or note.text == text:
            return
        note = replace(note, text=text, wording=note.wording + 1)
        self._write(text, note.t, {**note.data, **numbered(number, note.wording)})
        if text:
            self.current[number] = note
        else:
            del self.current[number]
        self.changed.emit()

    def delete(self, number: int) -> Callable[[], bool] | None:
        """Delete a note; returns a function that undoes it, None if it is deleted already."""
        note, recording = self.current.get(number), self._recording
        if note is None:
            return None
        self.change(number, "")
        return lambda: self._put_back(number, note, recording)

    def _put_back(self, number: int, note: Note, recording: int) -> bool:
        """Restore a note with a later wording number; False if its recording has ended."""
        if not self._is_recording or recording != self._recording:
            return False
        again = replace(note, wording=note.wording + 2)  # its deletion has the number between
        self._write(again.text, again.t, {**again.data, **numbered(number, again.wording)})
        self.current = dict(sorted({**self.current, number: again}.items()))
        self.changed.emit()
        return True
