"""First page of the stereo calibration: the board, the source of images, or an existing file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import (
    QComboBox,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.widgets.measures import WIDE
from app.words import error_text
from tracker.base.errors import ConfigError
from tracker.calibration.stereo.board import BoardSpec, page_size, print_image
from tracker.sensors.image_input import ImageInput

DPI, PREVIEW_DPI = 300, 110


@dataclass(frozen=True)
class ImageChoice:
    """A source of images of the board."""

    title: str
    make: Callable[[BoardSpec], ImageInput]
    simulated: bool = False


class BoardPage(QWidget):
    """``spec()``: the board; `import_zed` and `import_opencv` ask for a file."""

    import_zed = Signal()
    import_opencv = Signal()
    changed = Signal()

    def __init__(self, spec: BoardSpec, choices: list[ImageChoice]) -> None:
        super().__init__()
        self.choices = choices
        self.kind = QComboBox()
        self.kind.addItem(self.tr("ChArUco (may be partly hidden)"), "charuco")
        self.kind.addItem(self.tr("Chessboard (always whole)"), "chessboard")
        self.kind.setCurrentIndex(self.kind.findData(spec.kind))
        self.columns, self.rows = _count(spec.columns), _count(spec.rows)
        self.square_mm = QDoubleSpinBox()
        self.square_mm.setRange(4.0, 200.0)
        self.square_mm.setDecimals(2)
        self.square_mm.setSuffix(self.tr(" mm"))
        self.square_mm.setValue(spec.square * 1000)
        self.baseline_mm = QDoubleSpinBox()
        self.baseline_mm.setRange(0.0, 500.0)
        self.baseline_mm.setDecimals(1)
        self.baseline_mm.setSuffix(self.tr(" mm"))
        self.baseline_mm.setSpecialValueText(self.tr("unknown"))
        self.baseline_mm.setToolTip(self.tr("From the camera's data sheet; a ZED Mini has 63 mm"))
        self.images = QComboBox()
        self.preview = BoardPreview()
        self.paper = QLabel()
        self.paper.setProperty("role", "faint")
        self.problem = QLabel()
        self.problem.setProperty("role", "warning")
        self.problem.setWordWrap(True)
        self._lay_out()
        self.set_choices(choices)
        for signal in (
            self.kind.currentIndexChanged,
            self.columns.valueChanged,
            self.rows.valueChanged,
            self.square_mm.valueChanged,
        ):
            signal.connect(self._show)
        self._show()

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.addRow(self.tr("&Board"), self.kind)
        form.addRow(self.tr("Squares a&cross"), self.columns)
        form.addRow(self.tr("Squares &down"), self.rows)
        form.addRow(self.tr("Side of a &square, measured"), self.square_mm)
        form.addRow(self.tr("B&aseline, if known"), self.baseline_mm)
        form.addRow(self.tr("&Images from"), self.images)
        self.save = QPushButton(self.tr("Save the board for printing…"))
        self.save.clicked.connect(self._ask_save)
        left = QVBoxLayout()
        left.addLayout(form)
        left.addWidget(self.problem)
        left.addWidget(self.save)
        left.addWidget(self.paper)
        left.addStretch(1)
        left.addWidget(self._import_box())
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(WIDE)
        row.addLayout(left, 1)
        row.addWidget(self.preview, 1)

    def _import_box(self) -> QGroupBox:
        box = QGroupBox(self.tr("Import an existing calibration"))
        words = QLabel(
            self.tr(
                "It is checked as strictly as a new calibration, and can be tested with the board."
            )
        )
        words.setWordWrap(True)
        words.setProperty("role", "faint")
        self.zed = QPushButton(self.tr("ZED factory file…"))
        self.zed.clicked.connect(self.import_zed)
        self.opencv = QPushButton(self.tr("OpenCV file…"))
        self.opencv.clicked.connect(self.import_opencv)
        buttons = QHBoxLayout()
        buttons.addWidget(self.zed)
        buttons.addWidget(self.opencv)
        buttons.addStretch(1)
        column = QVBoxLayout(box)
        column.addWidget(words)
        column.addLayout(buttons)
        return box

    def set_choices(self, choices: list[ImageChoice]) -> None:
        """Offer these sources of images; the selection is kept if it is still available."""
        before = self.images.currentText()
        self.choices = choices
        self.images.clear()
        self.images.addItems([c.title for c in choices])
        self.images.setCurrentIndex(max(0, self.images.findText(before)))

    def choice(self) -> ImageChoice | None:
        index = self.images.currentIndex()
        return self.choices[index] if 0 <= index < len(self.choices) else None

    def spec(self) -> BoardSpec | None:
        """The board; None, with the reason on the page, if it is invalid."""
        try:
            return BoardSpec(
                self.kind.currentData(),
                self.columns.value(),
                self.rows.value(),
                self.square_mm.value() / 1000,
            )
        except ConfigError as error:
            self.problem.setText(error_text(error))
            return None

    def _show(self) -> None:
        spec = self.spec()
        self.problem.setVisible(spec is None)
        self.save.setEnabled(spec is not None)
        self.preview.show_board(spec)
        if spec is not None:
            width_mm, height_mm = (1000 * side for side in page_size(spec))
            words = self.tr("The page is {} by {} mm: print it without scaling.")
            self.paper.setText(words.format(f"{width_mm:.0f}", f"{height_mm:.0f}"))
        self.changed.emit()

    def _ask_save(self) -> None:
        spec = self.spec()
        if spec is None:
            return
        name = f"{spec.kind}-{spec.columns}x{spec.rows}-{spec.square * 1000:g}mm.png"
        path, _ = QFileDialog.getSaveFileName(self, self.tr("Save the board"), name, "*.png")
        if path:
            self.save_board(Path(path))

    def save_board(self, path: Path) -> bool:
        """Write the page as a PNG with its resolution; whether that was possible."""
        spec = self.spec()
        if spec is None:
            return False
        page, per_metre = print_image(spec, DPI)
        image = _grey_image(page)
        image.setDotsPerMeterX(round(per_metre))
        image.setDotsPerMeterY(round(per_metre))
        if image.save(str(path)):
            return True
        self.problem.setText(self.tr("{} cannot be written.").format(path))
        self.problem.show()
        return False


class BoardPreview(QWidget):
    """The board as it will be printed."""

    def __init__(self) -> None:
        super().__init__()
        self._image: QImage | None = None
        self.setMinimumSize(180, 140)
        self.setAccessibleName(self.tr("Board"))

    def show_board(self, spec: BoardSpec | None) -> None:
        self._image = None if spec is None else _grey_image(print_image(spec, PREVIEW_DPI)[0])
        self.update()

    def paintEvent(self, event: object) -> None:
        if self._image is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        size = self._image.size().scaled(self.size(), Qt.AspectRatioMode.KeepAspectRatio)
        x, y = (self.width() - size.width()) / 2, (self.height() - size.height()) / 2
        painter.drawImage(QRectF(x, y, size.width(), size.height()), self._image)
        painter.end()


def _grey_image(pixels: NDArray[np.uint8]) -> QImage:
    """A QImage with its own copy of the pixels."""
    height, width = pixels.shape
    data = np.ascontiguousarray(pixels)
    image = QImage(data.data, width, height, data.strides[0], QImage.Format.Format_Grayscale8)
    return image.copy()


def _count(value: int) -> QSpinBox:
    box = QSpinBox()
    box.setRange(4, 20)
    box.setValue(value)
    return box
