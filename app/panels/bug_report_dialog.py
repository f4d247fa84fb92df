"""A dialog in which the user selects the content of a bug report."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.platform.bug_report import Choice, contents


class BugReportDialog(QDialog):
    """``wanted(path, choice)`` is emitted when the user saves the report; nothing is sent."""

    wanted = Signal(object, object)  # Path, Choice

    def __init__(self, path: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Save a bug report"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setMinimumWidth(560)
        self.boxes = {
            "screenshot": QCheckBox(self.tr("An image of the window")),
            "session": QCheckBox(self.tr("The last seconds of the session")),
            "images": QCheckBox(self.tr("Camera images of these seconds")),
            "personal": QCheckBox(self.tr("Participant, task, notes and folder names")),
        }
        self.path = QLineEdit(str(path))
        self.inside = QLabel()
        self.inside.setWordWrap(True)
        column = QVBoxLayout(self)
        for name, box in self.boxes.items():
            box.setChecked(getattr(Choice(), name))
            box.toggled.connect(self._describe)
            column.addWidget(box)
        column.addWidget(self.inside)
        column.addLayout(self._file_row())
        column.addWidget(self._buttons())
        self._describe()

    def _file_row(self) -> QHBoxLayout:
        choose = QPushButton(self.tr("Change…"))
        choose.clicked.connect(self._choose)
        row = QHBoxLayout()
        row.addWidget(QLabel(self.tr("File")))
        row.addWidget(self.path, 1)
        row.addWidget(choose)
        return row

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        save = buttons.addButton(self.tr("Save"), QDialogButtonBox.ButtonRole.AcceptRole)
        save.setProperty("role", "primary")
        buttons.accepted.connect(self._save)
        buttons.rejected.connect(self.close)
        return buttons

    def choice(self) -> Choice:
        return Choice(**{name: box.isChecked() for name, box in self.boxes.items()})

    def _describe(self) -> None:
        self.boxes["images"].setEnabled(self.boxes["session"].isChecked())
        lines = "".join(f"<li>{line}</li>" for line in contents(self.choice()))
        about = self.tr("The file stays on this computer until you send it. It will contain:")
        self.inside.setText(f"{about}<ul>{lines}</ul>")

    def _choose(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save a bug report"), self.path.text(), "*.zip"
        )
        if path:
            self.path.setText(path)

    def _save(self) -> None:
        self.wanted.emit(Path(self.path.text()), self.choice())
        self.close()
