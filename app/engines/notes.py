"""The notes of the recording under way: they can be changed until it ends."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Protocol

from PySide6.QtCore import QObject, Signal

from tracker.base.clock import monotonic
from tracker.session.notes import numbered


class Teller(Protocol):
    """Takes a note to the log and to the file."""

    def __call__(self, text: str, t: float, data: Mapping[str, object]) -> None: ...


@dataclass(frozen=True)
class Note:
    """``t`` s of the monotonic clock: when the user began to write it; ``data`` stays with it."""

    t: float
    text: str
    wording: int = 0
    data: Mapping[str, object] = field(default_factory=dict)


class Notes(QObject):
    """``standing`` holds them by number; those before a recording go to the log alone."""

    changed = Signal()

    def __init__(
        self,
        tell: Teller,
        parent: QObject | None = None,
        clock: Callable[[], float] = monotonic,
    ) -> None:
        super().__init__(parent)
        self._tell, self._clock = tell, clock
        self._next = 0
        self._keep = False
        self._recording = 0  # how many have begun
        self.standing: dict[int, Note] = {}

    def now(self) -> float:
        """The stamp of a note that the user begins to write."""
        return self._clock()

    def begin(self) -> None:
        """A recording has begun."""
        self._keep, self._next, self.standing = True, 0, {}
        self._recording += 1
        self.changed.emit()

    def end(self) -> None:
        """What the file holds stands."""
        self._keep, self.standing = False, {}
        self.changed.emit()

    def add(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None:
        """``t``: of `now` when its key was pressed."""
        note = Note(self.now() if t is None else t, text, data=data or {})
        number, self._next = self._next, self._next + 1
        self._tell(text, note.t, {**note.data, **(numbered(number, 0) if self._keep else {})})
        if self._keep:
            self.standing[number] = note
            self.changed.emit()

    def change(self, number: int, text: str) -> None:
        """Another wording, with the same stamp; none where the note is gone."""
        note = self.standing.get(number)
        if note is None or note.text == text:
            return
        note = replace(note, text=text, wording=note.wording + 1)
        self._tell(text, note.t, {**note.data, **numbered(number, note.wording)})
        if text:
            self.standing[number] = note
        else:
            del self.standing[number]
        self.changed.emit()

    def delete(self, number: int) -> Callable[[], bool] | None:
        """What undoes it; None where the note is gone already."""
        note, recording = self.standing.get(number), self._recording
        if note is None:
            return None
        self.change(number, "")
        return lambda: self._put_back(number, note, recording)

    def _put_back(self, number: int, note: Note, recording: int) -> bool:
        """With a later wording, so that it counts in the file; False once its recording ended."""
        if not self._keep or recording != self._recording:
            return False
        again = replace(note, wording=note.wording + 2)  # its deletion was the one between
        self._tell(again.text, again.t, {**again.data, **numbered(number, again.wording)})
        self.standing = dict(sorted({**self.standing, number: again}.items()))
        self.changed.emit()
        return True
