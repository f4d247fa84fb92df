"""A number that is taken when it is whole, not digit by digit."""

from __future__ import annotations

from PySide6.QtCore import QEvent
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QSpinBox, QWidget

UNDO_KEYS = (QKeySequence.StandardKey.Undo, QKeySequence.StandardKey.Redo)


class NumberBox(QSpinBox):
    """Undo is the text's own while a number is typed, and the window's once it was taken."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setKeyboardTracking(False)
        self.editingFinished.connect(lambda: self.lineEdit().setModified(False))

    @property
    def is_typed(self) -> bool:
        """Whether there is text that was not taken yet."""
        return self.lineEdit().isModified()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and not self.is_typed:
            assert isinstance(event, QKeyEvent)
            if any(event.matches(key) for key in UNDO_KEYS):
                event.ignore()
                return False
        return super().event(event)
