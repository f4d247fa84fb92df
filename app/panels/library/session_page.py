"""The recorded sessions and what can be done with the selected ones."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from app.panels.library.session_table import SessionTable
from app.viewmodels.library import SessionRow


class SessionPage(QWidget):
    """Says what is ``asked``: replay, track, compare, export, recover or refresh."""

    asked = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = SessionTable()
        self.table.cellDoubleClicked.connect(lambda _row, _column: self.asked.emit("replay"))
        self.table.itemSelectionChanged.connect(self.enable)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 6, 0, 0)
        column.addWidget(self.table, 1)
        column.addLayout(self._buttons())
        self.enable()

    def _buttons(self) -> QHBoxLayout:
        row = QHBoxLayout()
        self.buttons: dict[str, QPushButton] = {}
        for key, text in (
            ("replay", self.tr("Replay")),
            ("track", self.tr("Track again…")),
            ("compare", self.tr("Compare")),
            ("export", self.tr("Export…")),
            ("recover", self.tr("Recover")),
            ("refresh", self.tr("Refresh")),
        ):
            self.buttons[key] = QPushButton(text)
            self.buttons[key].clicked.connect(lambda _on=False, key=key: self.asked.emit(key))
            row.addWidget(self.buttons[key])
        self.buttons["compare"].setToolTip(self.tr("Choose two sessions of one movement"))
        row.addStretch(1)
        return row

    def enable(self) -> None:
        rows = self.table.selected()
        one = len(rows) == 1
        for key, on in (
            ("replay", one),
            ("track", one),
            ("compare", len(rows) == 2),
            ("export", bool(rows)),
            ("recover", one and rows[0].recoverable),
        ):
            self.buttons[key].setEnabled(on)

    def selected(self) -> SessionRow | None:
        """The first of the selected sessions."""
        return next(iter(self.table.selected()), None)
