"""Comparison of two recordings on one time axis: camera images, a joint angle of both, their
difference, and the time offset."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDoubleSpinBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from app.platform.tasks import JobProgress, LatestJob
from app.viewmodels.names import display_name
from app.viewmodels.states import GOOD, SKY, WARN
from app.viewmodels.two_recordings import Image, RecordingImages, TwoRecordings, figures_text
from app.widgets.image_view import ImageView
from app.words import error_text, local
from tracker.base.errors import GlovetrackError

LONGEST = 86_400.0  # s, maximum offset
FRAME_S = 0.01  # step of the field, s


HIGH = 200  # px


class ImagePairView(QSplitter):
    """The images of both, which zoom and move together; only the newest position is read, in the
    background."""

    def __init__(self, takes: TwoRecordings, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        paths = takes.first.path, takes.second.path
        self._sources = tuple(RecordingImages(path) for path in paths)
        nothing = self.tr("No image here")
        self.views = tuple(ImageView(path.stem, nothing) for path in paths)
        self.setChildrenCollapsible(False)
        for view, other in (self.views, self.views[::-1]):
            view.setMinimumHeight(HIGH)
            view.handled.connect(lambda v=view, o=other: o.show_like(v))
            self.addWidget(view)
        self._asked: tuple[float, ...] = ()
        self._reading = LatestJob(self.tr("Reading images"), self)

    def show_at(self, *positions: float) -> None:
        """Show the images at s after the first measurement of each recording."""
        if positions == self._asked:
            return
        self._asked = positions
        sources = self._sources

        def read(_progress: JobProgress) -> list[Image | None]:
            return [source.at(p) for source, p in zip(sources, positions, strict=True)]

        self._reading.run(read, self._show)

    def _show(self, images: Sequence[Image | None]) -> None:
        for view, image in zip(self.views, images, strict=True):
            view.show_image(image)

    def shut_down(self) -> None:
        """Wait for the image that is being read, and close both files."""
        self._reading.shut_down()
        for source in self._sources:
            source.close()


class TwoRecordingsDialog(QDialog):
    """Not modal. ``moved``: the new offset; ``seek_requested``: s of the first recording."""

    moved = Signal(float)
    seek_requested = Signal(float)

    def __init__(self, takes: TwoRecordings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.takes = takes
        names = takes.first.path.stem, takes.second.path.stem
        self.setWindowTitle(self.tr("{} and {}").format(*names))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(820, 640)
        self.figures = QLabel()
        self._make_plot(*names)
        column = QVBoxLayout(self)
        column.addLayout(self._top())
        self.images = ImagePairView(takes)
        self._position = 0.0
        column.addWidget(self.images, 1)
        column.addWidget(self.plot, 1)
        column.addWidget(self.figures)
        offsets = (takes.kept, takes.by_clock, 0.0)
        self.set_offset(next(offset for offset in offsets if offset is not None))

    def _make_plot(self, first: str, second: str) -> None:
        self.plot = pg.PlotWidget()
        self.plot.setBackground(self.palette().base().color())
        ink = self.palette().text().color()
        for side in ("left", "bottom"):
            self.plot.getAxis(side).setPen(ink)
            self.plot.getAxis(side).setTextPen(ink)
        self.plot.setLabel("bottom", self.tr("s from the start of {}").format(first))
        self.plot.setLabel("left", "°")
        self.plot.setMenuEnabled(False)
        self.plot.addLegend(labelTextColor=ink)
        dashed = Qt.PenStyle.DashLine
        self.curves = [
            self.plot.plot(pen=pg.mkPen(SKY, width=1), name=first),
            self.plot.plot(pen=pg.mkPen(WARN.colour, width=1), name=second),
            self.plot.plot(pen=pg.mkPen(GOOD.colour, width=1, style=dashed), name="Δ"),
        ]
        self.begin = pg.InfiniteLine(
            angle=90, movable=True, pen=pg.mkPen(WARN.colour), label=f"◂ {second} ▸"
        )
        self.begin.sigPositionChanged.connect(lambda line: self.set_offset(float(line.value())))
        self.cursor_line = pg.InfiniteLine(angle=90, movable=True, pen=pg.mkPen(ink))
        self.cursor_line.sigPositionChanged.connect(
            lambda line: self.seek_requested.emit(float(line.value()))
        )
        for line in (self.begin, self.cursor_line):
            self.plot.addItem(line, ignoreBounds=True)

    def _top(self) -> QHBoxLayout:
        self.joint = QComboBox()
        self.joint.setAccessibleName(self.tr("Joint angle"))
        for name in self.takes.names:
            self.joint.addItem(display_name(name), name)
        self.joint.currentIndexChanged.connect(lambda _i: self._show())
        self.offset = QDoubleSpinBox()
        self.offset.setRange(-LONGEST, LONGEST)
        self.offset.setDecimals(2)
        self.offset.setSingleStep(FRAME_S)
        self.offset.setSuffix(self.tr(" s"))
        self.offset.setKeyboardTracking(False)
        self.offset.setAccessibleName(self.tr("Second recording starts at"))
        self.offset.valueChanged.connect(self.set_offset)
        self.clock_button = QPushButton(self.tr("By clock"))
        self.clock_button.setToolTip(self.tr("Align the recordings by the computers' clocks"))
        self.clock_button.setEnabled(self.takes.by_clock is not None)
        self.clock_button.clicked.connect(lambda: self.set_offset(self.takes.by_clock or 0.0))
        self.starts_button = QPushButton(self.tr("Both from their start"))
        self.starts_button.clicked.connect(lambda: self.set_offset(0.0))
        self.movement_button = QPushButton(self.tr("By movement"))
        self.movement_button.setToolTip(
            self.tr("Align the recordings by the best match of their joint angles")
        )
        self.movement_button.clicked.connect(self._by_movement)
        self.store_button = QPushButton(self.tr("Keep"))
        self.store_button.setToolTip(self.tr("Save this alignment; compare --align uses it, too"))
        self.store_button.clicked.connect(self._keep)
        row = QHBoxLayout()
        row.addWidget(self.joint, 1)
        row.addWidget(QLabel(self.tr("Second recording starts at")))
        buttons = self.clock_button, self.movement_button, self.starts_button, self.store_button
        for widget in (self.offset, *buttons):
            row.addWidget(widget)
        return row

    def _by_movement(self) -> None:
        """Align by movement; without a match, the offset is unchanged and a message is shown."""
        try:
            found = self.takes.by_movement()
        except GlovetrackError as error:
            self.figures.setText(error_text(error))
            return
        self.set_offset(found.offset)
        template = self.tr("{} Correlation {:.2f}; at most {:.2f} elsewhere.")
        text = template.format(
            self.figures.text(), local(found.correlation), local(found.elsewhere)
        )
        self.figures.setText(text)

    def _keep(self) -> None:
        try:
            path = self.takes.save(self._offset)
        except GlovetrackError as error:
            self.figures.setText(error_text(error))
            return
        self.figures.setText(self.tr("Saved to {}.").format(path.name))

    def set_offset(self, offset: float) -> None:
        """Set where the second recording starts on the axis of the first, s."""
        self._offset = float(np.clip(offset, -LONGEST, LONGEST))
        with QSignalBlocker(self.offset), QSignalBlocker(self.begin):
            self.offset.setValue(self._offset)
            self.begin.setValue(self._offset)
        self._show()
        self.images.show_at(self._position, self._position - self._offset)
        self.moved.emit(self._offset)

    def show_position(self, position: float) -> None:
        """Show the position of the replay of the first recording, s."""
        self._position = position
        self.images.show_at(position, position - self._offset)
        with QSignalBlocker(self.cursor_line):
            if not self.cursor_line.moving:
                self.cursor_line.setValue(position)

    def done(self, result: int) -> None:
        """Close the files."""
        self.images.shut_down()
        super().done(result)

    def _show(self) -> None:
        name = self.joint.currentData()
        if name is None:
            self.figures.setText(self.tr("The recordings have no joint angle in common."))
            return
        t, first, t_second, second = self.takes.curves(name, self._offset)
        difference = self.takes.difference(name, self._offset)
        for curve, x, y in zip(
            self.curves, (t, t_second, t), (first, second, difference), strict=True
        ):
            curve.setData(x, np.rad2deg(y), connect="finite")
        found = self.takes.figures(name, self._offset)
        self.figures.setText(f"{display_name(name)}: {figures_text(found)}")
