"""The log: events of devices and tracking."""

from __future__ import annotations

import logging
from typing import Protocol

from PySide6.QtCore import Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import ErrorSignal, EventSignal
from app.panels.panel import Panel
from app.viewmodels.log import KINDS, EventLog, words_of
from app.widgets.measures import NEAR
from app.words import tr
from tracker.messages import Event

_log = logging.getLogger(__name__)


class LogHost(ErrorSignal, EventSignal, Protocol):
    """What the log shows of the engine host."""


class LogPanel(Panel):
    period = 1.0
    report = Signal()  # the user wants a bug report

    def __init__(self, host: LogHost, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = EventLog()
        self.kind = QComboBox()
        self.kind.addItem(self.tr("Everything"), "")
        for kind, look in KINDS.items():
            self.kind.addItem(f"{look.sign}  {tr(look.word)}", kind)
        self.kind.currentIndexChanged.connect(self._rebuild)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Filter"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._rebuild)
        copy = QPushButton(self.tr("Copy"))
        copy.clicked.connect(self.copy)
        report = QPushButton(self.tr("Bug report…"))
        report.clicked.connect(self.report)
        self.list = QListWidget()
        self.list.setUniformItemSizes(True)
        self.list.setAlternatingRowColors(True)
        row = QHBoxLayout()
        row.addWidget(self.kind)
        row.addWidget(self.search, 1)
        row.addWidget(copy)
        row.addWidget(report)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.addLayout(row)
        column.addWidget(self.list, 1)
        host.happened.connect(self.add)
        host.error.connect(lambda text: self.add(Event(0.0, "error", text)))

    def add(self, event: Event) -> None:
        _log.info("%s %s: %s", event.kind, event.code or "-", event.text)
        if not words_of(event):
            return
        entry = self.model.add(event)
        if self.model.shows(entry, self._kind(), self.search.text()):
            self._append(entry.line, entry.colour)
            self.list.scrollToBottom()

    def _append(self, line: str, colour: str) -> None:
        item = QListWidgetItem(line)
        item.setToolTip(line)
        self.list.addItem(item)
        while self.list.count() > self.model.capacity:
            self.list.takeItem(0)

    def _kind(self) -> str:
        return str(self.kind.currentData() or "")

    def _rebuild(self) -> None:
        self.list.clear()
        for entry in self.model.entries(self._kind(), self.search.text()):
            self._append(entry.line, entry.colour)

    def copy(self) -> None:
        """Copy the visible events as text."""
        entries = self.model.entries(self._kind(), self.search.text())
        QGuiApplication.clipboard().setText("\n".join(e.line for e in entries))
