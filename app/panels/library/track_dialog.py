"""Options for tracking a recorded session again: engine, hand, glove, colours, settings."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.words import tr
from tracker.engine.kinds import engine_kinds
from tracker.glove import library
from tracker.offline.options import USUAL, TrackOptions


class TrackDialog(QDialog):
    """Emits ``wanted(source, request)`` when the user starts tracking; not modal."""

    wanted = Signal(object, object)  # Path, TrackOptions

    def __init__(self, source: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.source = source
        self.setWindowTitle(self.tr("Track {} again").format(source.name))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.engine = QComboBox()
        for name, kind in engine_kinds().items():
            self.engine.addItem(tr(kind.title), name)
        self.hand = self._choice("hands")
        self.glove = self._choice("gloves")
        self.colours = self._choice("colours")
        self.settings = QComboBox()
        self.settings.addItem(self.tr("as recorded"), "")
        self.settings.addItem(self.tr("default"), USUAL)
        self.smooth = QCheckBox(self.tr("use the whole session for every estimate (chain)"))
        column = QVBoxLayout(self)
        column.addWidget(self._about())
        column.addLayout(self._form())
        column.addWidget(self._buttons())
        self.setMinimumWidth(460)

    def _about(self) -> QLabel:
        about = QLabel(
            self.tr(
                "Tracks the recorded sensor data again and saves the result as a new session in "
                "the same folder. Both sessions are then shown together and compared."
            )
        )
        about.setWordWrap(True)
        return about

    def _choice(self, kind: str) -> QComboBox:
        box = QComboBox()
        box.addItem(self.tr("as recorded"), "")
        for name in library.names(kind):
            box.addItem(name, name)
        return box

    def _form(self) -> QFormLayout:
        choose = QPushButton(self.tr("Choose…"))
        choose.clicked.connect(self._choose_settings)
        row = QHBoxLayout()
        row.addWidget(self.settings, 1)
        row.addWidget(choose)
        settings = QLabel(self.tr("&Settings"))
        settings.setBuddy(self.settings)
        form = QFormLayout()
        form.addRow(self.tr("&Engine"), self.engine)
        form.addRow(self.tr("&Hand"), self.hand)
        form.addRow(self.tr("&Glove"), self.glove)
        form.addRow(self.tr("&Colours"), self.colours)
        form.addRow(settings, row)
        form.addRow(self.tr("S&mooth"), self.smooth)
        return form

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.start = buttons.addButton(self.tr("Track"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.start.setProperty("role", "primary")
        buttons.accepted.connect(self._start)
        buttons.rejected.connect(self.close)
        return buttons

    def _choose_settings(self) -> None:
        path, _ = QFileDialog.getOpenFileName(self, self.tr("Settings"), "", "*.toml")
        if path:
            self.settings.addItem(Path(path).name, path)
            self.settings.setCurrentIndex(self.settings.count() - 1)

    def _start(self) -> None:
        self.wanted.emit(self.source, self.request())
        self.close()

    def request(self) -> TrackOptions:
        """The selected options."""
        return TrackOptions(
            engine=self.engine.currentData(),
            hand=self.hand.currentData(),
            glove=self.glove.currentData(),
            colours=self.colours.currentData(),
            settings=self.settings.currentData(),
            smooth=self.smooth.isChecked(),
        )
