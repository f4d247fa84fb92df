"""The pages with live images of the board: collecting views, and checking the result on new
views."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QProgressBar,
    QPushButton,
    QSplitter,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.viewmodels.stereo import (
    VERDICTS,
    Meter,
    check_figures,
    check_rows,
    corner_shapes,
    exposure_text,
    meters,
    rig_figures,
    row_lines,
    view_name,
)
from app.widgets.image_shapes import Shape
from app.widgets.image_view import ImageView
from app.widgets.measures import TIGHT, WIDE
from app.wizards.stereo.board_watcher import BoardSeen
from app.words import notice_text
from tracker.calibration.stereo.collect import ExposureResult
from tracker.calibration.stereo.coverage import coverage
from tracker.calibration.stereo.verify import Verification, verify
from tracker.calibration.stereo.views import Image, StereoView, sizes_of
from tracker.sensors.image_input import Pair
from tracker.vision.rig import Camera, StereoRig


class ImagePair(QSplitter):
    """Both images side by side, or that of a single camera."""

    def __init__(self) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        waiting = self.tr("Waiting for the camera")
        self.left = ImageView(self.tr("Left"), waiting)
        self.right = ImageView(self.tr("Right"), waiting)
        self.setChildrenCollapsible(False)
        for view in (self.left, self.right):
            self.addWidget(view)

    def show_sides(self, alone: bool) -> None:
        """Show both images, or that of a single camera (``alone``), which is not named left."""
        self.left.set_title(self.tr("Camera") if alone else self.tr("Left"))
        self.right.setVisible(not alone)

    def show_pair(self, images: Pair, shapes: Sequence[Sequence[Shape]]) -> None:
        """Show images with shapes drawn over each."""
        self.show_sides(alone=images[1] is None)
        for view, image, drawn in zip((self.left, self.right), images, shapes, strict=True):
            if image is not None:
                view.show_image(image, drawn)

    def wait(self, words: str) -> None:
        for view in (self.left, self.right):
            view.set_placeholder(words)
            view.show_image(None)


class CollectPage(QWidget):
    """Live images, their coverage, and the collected views."""

    removed = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.images = ImagePair()
        self.words = QLabel()
        self.words.setProperty("role", "figure")
        self.words.setWordWrap(True)
        self.map = CoverageMap((self.tr("Left image"), self.tr("Right image")), self.tr("Image"))
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Views taken"))
        self.list.setMinimumHeight(60)
        self.remove = QPushButton(self.tr("Remove the view"))
        self.remove.setEnabled(False)
        self.remove.clicked.connect(lambda: self.removed.emit(self.list.currentRow()))
        self.list.currentRowChanged.connect(lambda row: self.remove.setEnabled(row >= 0))
        self._meters = QGridLayout()
        self._bars: list[tuple[QLabel, QProgressBar]] = []
        below = QHBoxLayout()
        below.setSpacing(WIDE)
        below.addLayout(self._figures(), 3)
        below.addLayout(self._taken(), 2)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.images, 3)
        column.addWidget(self.words)
        column.addLayout(below, 2)
        self._shown: tuple[object, int] = (None, -1)
        self._listed: tuple[Sequence[StereoView], tuple[float, ...]] = ((), ())

    def _figures(self) -> QVBoxLayout:
        self._meters.setColumnStretch(2, 1)
        self._meters.setVerticalSpacing(TIGHT)
        column = QVBoxLayout()
        column.addLayout(self._meters)
        column.addWidget(self.map)
        column.addStretch(1)
        return column

    def _taken(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.addWidget(self.list, 1)
        column.addWidget(self.remove, 0, Qt.AlignmentFlag.AlignRight)
        return column

    def show_seen(self, seen: BoardSeen | None, views: Sequence[StereoView], problem: str) -> None:
        """Show the latest exposure and the collected views."""
        if seen is None:
            self.images.wait(problem or self.tr("Waiting for the camera"))
            self.words.setText(problem)
            return
        if self._shown == (seen, len(views)):
            return
        self._shown = (seen, len(views))
        good = seen.answer in (ExposureResult.TAKEN, ExposureResult.KNOWN, ExposureResult.FULL)
        found = (seen.look.left, seen.look.right)
        self.images.show_pair(seen.pair, [corner_shapes(corners, good) for corners in found])
        cover = coverage(views, sizes_of(seen.pair))
        self.words.setText(problem or exposure_text(seen.answer, seen.look.problem, cover))
        self.map.show_counts(cover.maps)
        self._show_meters(meters(cover))

    def _show_meters(self, rows: Sequence[Meter]) -> None:
        for i, meter in enumerate(rows):
            if i == len(self._bars):
                self._add_bar(i, meter.name)
            label, bar = self._bars[i]
            label.setText(meter.text)
            bar.setValue(round(100 * min(1.0, meter.share)))

    def _add_bar(self, row: int, name: str) -> None:
        figure, bar = QLabel(), QProgressBar()
        bar.setTextVisible(False)
        bar.setMaximumHeight(8)
        bar.setAccessibleName(name)
        for column, widget in enumerate((QLabel(name), figure, bar)):
            self._meters.addWidget(widget, row, column)
        self._bars.append((figure, bar))

    def show_list(
        self, views: Sequence[StereoView], error_px: Callable[[StereoView], float]
    ) -> None:
        """List the collected views, each with its error in a calibration of all of them."""
        errors = tuple(error_px(v) for v in views)
        if self._listed == (views, errors):
            return
        self._listed = (views, errors)
        while self.list.count() > len(views):
            self.list.takeItem(self.list.count() - 1)
        for i, (view, error) in enumerate(zip(views, errors, strict=True)):
            if i == self.list.count():
                self.list.addItem("")
            self.list.item(i).setText(view_name(i, view, error))


class CheckPage(QWidget):
    """Rectified images, and row differences in views that were not used for the solution."""

    def __init__(self) -> None:
        super().__init__()
        self.images = ImagePair()
        self.words = QLabel()
        self.words.setProperty("role", "figure")
        self.words.setWordWrap(True)
        self.figures = QLabel()
        self.figures.setProperty("role", "faint")
        self.table = QTableWidget(0, 2)
        self._name_columns(one_camera=False)
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.setMaximumWidth(280)
        row = QHBoxLayout()
        row.addWidget(self.figures, 1, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self.table)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.images, 3)
        column.addWidget(self.words)
        column.addLayout(row, 2)
        self._maps: tuple[tuple[np.ndarray, np.ndarray], ...] = ()
        self._rig: StereoRig | None = None
        self._seen: BoardSeen | None = None
        self.found: Verification | None = None

    def set_rig(self, rig: StereoRig) -> None:
        """Check this rig."""
        self._rig, self.found, self._seen = rig, None, None
        self._maps = tuple(_rectify_map(c) for c in (rig.left, rig.right))
        self._name_columns(rig.one_camera)
        self.images.show_sides(rig.one_camera)
        self.show_views(())

    def _name_columns(self, one_camera: bool) -> None:
        off = self.tr("Corner error") if one_camera else self.tr("Row difference")
        self.table.setHorizontalHeaderLabels([self.tr("View"), off])

    def show_seen(self, seen: BoardSeen | None, views: Sequence[StereoView], problem: str) -> None:
        """Show the latest exposure, rectified, and the new views so far."""
        if seen is None:
            self.images.wait(problem or self.tr("Show the board again."))
        elif seen is not self._seen:
            self._seen = seen
            self._show_images(seen)
        if self.found is None or len(self.found.off_px) != len(views):
            self.show_views(views)

    def show_views(self, views: Sequence[StereoView]) -> None:
        """Show the errors of the new views."""
        if self._rig is None:
            return
        self.found = verify(self._rig, views)
        state, verdict = self.found.verdict()
        look = VERDICTS[state]
        self.words.setText(f"{look.sign}  {notice_text(verdict)}")
        figures = rig_figures(self._rig) + check_figures(self.found)
        self.figures.setText("\n".join(f"{name}: {text}" for name, text in figures))
        rows = check_rows(self.found)
        self.table.setRowCount(len(rows))
        for i, cells in enumerate(rows):
            for j, text in enumerate(cells):
                self.table.setItem(i, j, QTableWidgetItem(text))

    def _show_images(self, seen: BoardSeen) -> None:
        assert self._rig is not None
        rig, lines = self._rig, []
        if seen.look.view is not None and not rig.one_camera:
            # the same rows in both images, which must meet the same corners
            lines = row_lines(rig.left, seen.look.left, rig.left.width)
        for widget, image, camera, maps in zip(
            (self.images.left, self.images.right),
            seen.pair,
            (rig.left, rig.right),
            self._maps,
            strict=True,
        ):
            if image is None or image.shape[:2] != (camera.height, camera.width):
                widget.set_placeholder(self.tr("The image has a different size."))
                widget.show_image(None)
            else:
                widget.show_image(_rectified(image, maps), lines)


def _rectify_map(camera: Camera) -> tuple[np.ndarray, np.ndarray]:
    size = (camera.width, camera.height)
    make = cv2.fisheye.initUndistortRectifyMap if camera.fisheye else cv2.initUndistortRectifyMap
    first, second = make(camera.K, camera.D, camera.R, camera.P[:, :3], size, cv2.CV_16SC2)
    return first, second


def _rectified(image: Image, maps: tuple[np.ndarray, np.ndarray]) -> Image:
    return np.asarray(cv2.remap(image, maps[0], maps[1], cv2.INTER_LINEAR), np.uint8)


# ---- maps of the image areas that the board has covered

FULL = QColor("#009E73")
ENOUGH = 3
"""Number of views at which a cell is filled."""
GAP = 14


class CoverageMap(QWidget):
    """Shows the number of views with corners in each cell, as a number and a fill."""

    def __init__(self, titles: tuple[str, str], alone: str, parent: QWidget | None = None) -> None:
        """``titles`` of left and right, ``alone`` of a single camera."""
        super().__init__(parent)
        self._titles, self._alone = titles, alone
        self._counts: tuple[NDArray[np.int64], ...] = ()
        self.setMinimumSize(220, 90)

    def sizeHint(self) -> QSize:
        return QSize(300, 118)

    def show_counts(self, maps: tuple[NDArray[np.int64], ...]) -> None:
        """Show one or two arrays (rows, columns)."""
        self._counts = maps
        empty = sum(int((counts == 0).sum()) for counts in maps)
        self.setAccessibleName(self.tr("{} empty cells").format(empty))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        width = (self.width() - GAP) / 2
        head = painter.fontMetrics().height() + 4
        for k, title in enumerate(self._titles if len(self._counts) != 1 else (self._alone,)):
            x = k * (width + GAP)
            painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
            where = QRectF(x, 0, width, head)
            painter.drawText(where, Qt.AlignmentFlag.AlignLeft, title)
            if self._counts:
                box = QRectF(x, head, width, self.height() - head)
                self._paint_cells(painter, box, self._counts[k])
        painter.end()

    def _paint_cells(self, painter: QPainter, box: QRectF, counts: NDArray[np.int64]) -> None:
        rows, columns = counts.shape
        w, h = box.width() / columns, box.height() / rows
        text = self.palette().color(QPalette.ColorRole.WindowText)
        for (i, j), count in np.ndenumerate(counts):
            cell = QRectF(box.x() + j * w, box.y() + i * h, w - 2, h - 2)
            fill = QColor(FULL)
            fill.setAlphaF(0.75 * min(1.0, int(count) / ENOUGH))
            painter.setPen(self.palette().color(QPalette.ColorRole.Mid))
            painter.setBrush(fill)
            painter.drawRect(cell)
            if count:
                painter.setPen(text)
                painter.drawText(cell, Qt.AlignmentFlag.AlignCenter, str(int(count)))
