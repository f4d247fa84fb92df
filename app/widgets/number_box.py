"""A number field that reports a value when editing has finished, not for each digit."""

from __future__ import annotations

from PySide6.QtCore import QEvent
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QSpinBox, QWidget

UNDO_KEYS = (QKeySequence.StandardKey.Undo, QKeySequence.StandardKey.Redo)


class NumberBox(QSpinBox):
    """Undo applies to the text while a number is edited, and to the window afterwards."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setKeyboardTracking(False)
        self.editingFinished.connect(lambda: self.lineEdit().setModified(False))

    @property
    def is_typed(self) -> bool:
        """Whether there is text that has not been accepted yet."""
        return self.lineEdit().isModified()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and not self.is_typed:
            assert isinstance(event, QKeyEvent)
            if any(event.matches(key) for key in UNDO_KEYS):
                event.ignore()
                return False
        return super().event(event)
