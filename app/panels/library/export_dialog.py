"""What to export, how and where to."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.jobs.export import ExportRequest, free_target
from app.viewmodels.recording import position_text
from tracker.session.export.options import AXES_NAMES, FORMATS, PERSONAL, UNITS, ExportOptions

MAX_RATE_HZ = 2000.0


class ExportDialog(QDialog):
    """Says ``wanted`` once per session. ``part`` (s) is the range chosen in the replay, or None."""

    wanted = Signal(object)  # ExportRequest

    def __init__(
        self,
        sources: Sequence[Path],
        part: tuple[float, float] | None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._sources, self._part = tuple(sources), part
        names = (
            sources[0].name if len(sources) == 1 else self.tr("{} sessions").format(len(sources))
        )
        self.setWindowTitle(self.tr("Export {}").format(names))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._make_fields()
        column = QVBoxLayout(self)
        column.addLayout(self._form())
        column.addWidget(self._buttons())
        self.setMinimumWidth(460)

    def _make_fields(self) -> None:
        self.format = QComboBox()
        self.format.addItems(FORMATS)
        self.folder = QLineEdit(str(self._sources[0].parent))
        self.range = QCheckBox(self.tr("the whole session"))
        if self._part is not None:
            start, stop = (position_text(p) for p in self._part)
            self.range.setText(self.tr("only {} to {} (in and out point)").format(start, stop))
        self.range.setEnabled(self._part is not None)
        self.range.setChecked(self._part is not None)
        self.rate = QDoubleSpinBox()
        self.rate.setRange(0.0, MAX_RATE_HZ)
        self.rate.setSuffix(self.tr(" Hz"))
        self.rate.setSpecialValueText(self.tr("as recorded"))
        self.axes = self._choice(AXES_NAMES)
        self.units = self._choice(tuple(UNITS))
        self.anonymous = QCheckBox(self.tr("without participant and notes"))

    def _choice(self, names: Sequence[str]) -> QComboBox:
        box = QComboBox()
        box.addItem(self.tr("as usual for the format"), None)
        for name in names:
            box.addItem(name, name)
        return box

    def _form(self) -> QFormLayout:
        choose = QPushButton(self.tr("Change…"))
        choose.clicked.connect(self._choose_folder)
        row = QHBoxLayout()
        row.addWidget(self.folder, 1)
        row.addWidget(choose)
        folder = QLabel(self.tr("F&older"))
        folder.setBuddy(self.folder)
        form = QFormLayout()
        form.addRow(self.tr("&Format"), self.format)
        form.addRow(folder, row)
        form.addRow(self.tr("&Range"), self.range)
        form.addRow(self.tr("R&ate"), self.rate)
        form.addRow(self.tr("A&xes"), self.axes)
        form.addRow(self.tr("&Units"), self.units)
        form.addRow(self.tr("&Privacy"), self.anonymous)
        return form

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.start = buttons.addButton(self.tr("Export"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.start.setProperty("role", "primary")
        buttons.accepted.connect(self._start)
        buttons.rejected.connect(self.close)
        return buttons

    def _choose_folder(self) -> None:
        folder = QFileDialog.getExistingDirectory(
            self, self.tr("Folder for the export"), self.folder.text()
        )
        if folder:
            self.folder.setText(folder)

    def _start(self) -> None:
        for source in self._sources:
            self.wanted.emit(self.request(source))
        self.close()

    def request(self, source: Path) -> ExportRequest:
        """What is chosen, for one session; an existing file is never written over."""
        form = self.format.currentText()
        target = free_target(Path(self.folder.text()), source, form)
        return ExportRequest(
            source,
            form,
            target,
            self._part if self.range.isChecked() else None,
            ExportOptions(
                rate=self.rate.value() or None,
                axes=self.axes.currentData(),
                units=self.units.currentData(),
                anonymous=PERSONAL if self.anonymous.isChecked() else (),
            ),
        )
