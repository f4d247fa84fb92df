"""Dialogs for calibration files of other programs, and for information that these files do not
contain."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QSpinBox,
    QWidget,
)

from app.words import mark, tr
from tracker.calibration.stereo.files import MissingFacts

ZED_FOLDER = Path("/usr/local/zed/settings")
UNITS = (("mm", 1e-3), ("m", 1.0), ("cm", 1e-2), (mark("squares of the board"), 0.0))


class ImportFormDialog(QDialog):
    """Asks for the image size, and the unit of the baseline."""

    def __init__(self, path: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Import {}").format(path.name))
        default = MissingFacts()
        self.width_px, self.height_px = _pixels(default.width), _pixels(default.height)
        self.unit = QComboBox()
        for name, metres in UNITS:
            self.unit.addItem(tr(name), metres)
        self.square_mm = QDoubleSpinBox()
        self.square_mm.setRange(1.0, 500.0)
        self.square_mm.setValue(25.0)
        self.square_mm.setSuffix(self.tr(" mm"))
        self.unit.currentIndexChanged.connect(self._enable)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow(self.tr("Image's &width, px"), self.width_px)
        form.addRow(self.tr("Image's &height, px"), self.height_px)
        form.addRow(self.tr("&Unit of T in the file"), self.unit)
        form.addRow(self.tr("Side of a &square"), self.square_mm)
        form.addRow(buttons)
        self._enable()

    def form(self) -> MissingFacts:
        unit = self.unit.currentData() or self.square_mm.value() / 1000
        return MissingFacts(self.width_px.value(), self.height_px.value(), unit)

    def _enable(self) -> None:
        self.square_mm.setEnabled(self.unit.currentData() == 0.0)


def ask_import_form(path: Path, parent: QWidget) -> MissingFacts | None:
    """None if the user cancels."""
    dialog = ImportFormDialog(path, parent)
    return dialog.form() if dialog.exec() == QDialog.DialogCode.Accepted else None


def _pixels(value: int) -> QSpinBox:
    box = QSpinBox()
    box.setRange(160, 8192)
    box.setValue(value)
    return box


def ask_zed(parent: QWidget) -> tuple[Path, None] | None:
    """Ask for the factory file of the camera."""
    start = str(ZED_FOLDER) if ZED_FOLDER.is_dir() else ""
    title = QCoreApplication.translate("StereoWizard", "ZED factory file")
    path, _ = QFileDialog.getOpenFileName(parent, title, start, "*.conf")
    return (Path(path), None) if path else None


def ask_opencv(parent: QWidget) -> tuple[Path, MissingFacts] | None:
    """Ask for a file written by OpenCV's tools, and for missing information."""
    title = QCoreApplication.translate("StereoWizard", "OpenCV calibration")
    path, _ = QFileDialog.getOpenFileName(parent, title, "", "*.yml *.yaml *.xml *.json *.toml")
    form = ask_import_form(Path(path), parent) if path else None
    return (Path(path), form) if form is not None else None


def ask_folder(parent: QWidget) -> Path | None:
    """Ask for the folder of the images."""
    title = QCoreApplication.translate("StereoWizard", "Folder with left and right images")
    path = QFileDialog.getExistingDirectory(parent, title)
    return Path(path) if path else None
