"""The About box: version, licence and the licences of everything inside."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontDatabase, QIcon
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QPlainTextEdit,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.platform.licences import as_text, own_text
from app.widgets.measures import WIDE
from tracker import __version__

ICON = 64  # px


class AboutDialog(QDialog):
    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("About Glovetrack"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(720, 520)
        self.tabs = QTabWidget()
        self.tabs.addTab(_text(as_text()), self.tr("Parts and their licences"))
        self.tabs.addTab(_text(own_text()), self.tr("Apache-2.0"))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        column = QVBoxLayout(self)
        column.addLayout(self._heading())
        column.addWidget(self.tabs, 1)
        column.addWidget(buttons)

    def _heading(self) -> QHBoxLayout:
        icon = QLabel()
        app = QApplication.instance()
        window_icon = app.windowIcon() if isinstance(app, QApplication) else QIcon()
        icon.setPixmap(window_icon.pixmap(ICON, ICON))
        title = QLabel(self.tr("Glovetrack {}").format(__version__))
        title.setProperty("role", "heading")
        words = QLabel(
            self.tr(
                "Hand tracking with a sensor glove and a stereo camera. Free software under the "
                "Apache Licence 2.0, without any warranty."
            )
        )
        words.setWordWrap(True)
        texts = QVBoxLayout()
        texts.addWidget(title)
        texts.addWidget(words)
        row = QHBoxLayout()
        row.setSpacing(WIDE)
        row.addWidget(icon)
        row.addLayout(texts, 1)
        return row


def _text(text: str) -> QPlainTextEdit:
    view = QPlainTextEdit(text)
    view.setReadOnly(True)
    view.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
    view.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
    return view
