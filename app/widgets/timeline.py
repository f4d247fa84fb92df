"""A time line with a playhead, an in and an out point, and marks for events."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
)
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

MARGIN = 9  # px left and right, so that a handle at the end is not clipped
REACH = 6  # px within which the mouse selects a handle or a mark
TRACK = QColor(128, 128, 128, 90)
PLAYHEAD, HANDLE = "head", ("in", "out")


@dataclass(frozen=True)
class Mark:
    """An event at ``position`` s; ``sign`` shows its kind in addition to the colour; an empty
    colour is that of text."""

    position: float
    text: str
    colour: str
    sign: str


@dataclass(frozen=True)
class TimelineSpan:
    """An interval from ``start`` to ``stop`` s, drawn below the line; ``text`` is its tool tip."""

    start: float
    stop: float
    colour: str
    text: str


class TimelineBar(QWidget):
    """Mouse: press and drag. Keys: arrows step images, Page moves by seconds, Home and End."""

    seek_requested = Signal(float)
    stepped = Signal(int)
    range_changed = Signal(float, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._duration, self._position = 0.0, 0.0
        self._range = (0.0, 0.0)
        self._marks: tuple[Mark, ...] = ()
        self.spans: tuple[TimelineSpan, ...] = ()
        self._held = ""
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)

    def sizeHint(self) -> QSize:
        return QSize(300, 38)

    def show_session(self, duration: float, marks: Sequence[Mark]) -> None:
        self._duration, self._marks = duration, tuple(marks)
        self._position, self._range, self.spans = 0.0, (0.0, duration), ()
        self.update()

    def show_spans(self, spans: Sequence[TimelineSpan]) -> None:
        """Draw these intervals, later ones over earlier ones."""
        self.spans = tuple(spans)
        self.update()

    def show_place(self, position: float, in_out: tuple[float, float]) -> None:
        if (position, in_out) != (self._position, self._range):
            self._position, self._range = position, in_out
            self.update()

    def show_range(self, in_out: tuple[float, float]) -> None:
        """Update only the range while the mouse drags the playhead."""
        self.show_place(self._position, in_out)

    @property
    def held(self) -> bool:
        """Whether the mouse is dragging."""
        return bool(self._held)

    # --- positions and pixels

    def x_of(self, position: float) -> float:
        """Coordinate of a position (s), px."""
        share = position / self._duration if self._duration > 0 else 0.0
        return MARGIN + share * (self.width() - 2 * MARGIN)

    def position_at(self, x: float) -> float:
        share = (x - MARGIN) / max(1, self.width() - 2 * MARGIN)
        return min(max(share, 0.0), 1.0) * self._duration

    def _handle_at(self, at: QPointF) -> str:
        """A handle of the range in the lower half, else the playhead."""
        if at.y() > self.height() * 0.6:
            for name, position in zip(HANDLE, self._range, strict=True):
                if abs(self.x_of(position) - at.x()) <= REACH:
                    return name
        return PLAYHEAD

    def mark_at(self, x: float) -> Mark | None:
        near = [m for m in self._marks if abs(self.x_of(m.position) - x) <= REACH]
        return min(near, key=lambda m: abs(self.x_of(m.position) - x), default=None)

    def span_at(self, x: float) -> TimelineSpan | None:
        """The shortest interval at a coordinate."""
        there = [s for s in self.spans if self.x_of(s.start) - 2 <= x <= self.x_of(s.stop) + 2]
        return min(there, key=lambda s: s.stop - s.start, default=None)

    # --- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._held = self._handle_at(event.position())
        self.mouseMoveEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not self._held:
            return
        position = self.position_at(event.position().x())
        start, stop = self._range
        if self._held == PLAYHEAD:
            self._position = position
            self.seek_requested.emit(position)
        elif self._held == "in":
            self.range_changed.emit(min(position, stop), stop)
        else:
            self.range_changed.emit(start, max(position, start))
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held = ""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = Qt.Key(event.key())
        steps = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
        jumps = {Qt.Key.Key_PageUp: -1.0, Qt.Key.Key_PageDown: 1.0}
        ends = {Qt.Key.Key_Home: 0.0, Qt.Key.Key_End: self._duration}
        if key in steps:
            self.stepped.emit(steps[key])
        elif key in jumps:
            self.seek_requested.emit(min(max(self._position + jumps[key], 0.0), self._duration))
        elif key in ends:
            self.seek_requested.emit(ends[key])
        else:
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            mark, span = self.mark_at(event.pos().x()), self.span_at(event.pos().x())
            tips = [f"{mark.sign} {mark.text}"] if mark else []
            tips += [span.text] if span else []
            QToolTip.showText(event.globalPos(), "\n".join(tips), self)
            return True
        return super().event(event)

    # --- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        accent = self.palette().highlight().color()
        middle = self.height() * 0.6
        line = QRectF(MARGIN, middle - 2, self.width() - 2 * MARGIN, 4)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(TRACK)
        painter.drawRoundedRect(line, 2, 2)
        if self.isEnabled() and self._duration > 0:
            self._paint_range(painter, middle, accent)
            _paint_spans(painter, self, middle)
            self._paint_marks(painter)
            head = QPointF(self.x_of(self._position), middle)
            _paint_head(painter, head, self.palette())
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(accent)
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3)
        painter.end()

    def _paint_range(self, painter: QPainter, middle: float, accent: QColor) -> None:
        a, b = (self.x_of(p) for p in self._range)
        painter.setBrush(accent)
        painter.drawRect(QRectF(a, middle - 2, b - a, 4))
        painter.setBrush(self.palette().text())
        for x, side in ((a, 1), (b, -1)):  # brackets that open towards each other
            painter.drawRect(QRectF(x - 1, middle, 2, 12))
            painter.drawRect(QRectF(min(x, x + 6 * side), middle + 10, 6, 2))

    def _paint_marks(self, painter: QPainter) -> None:
        for mark in self._marks:
            painter.setPen(QColor(mark.colour) if mark.colour else self.palette().text().color())
            box = QRectF(self.x_of(mark.position) - 8, 0, 16, self.height() * 0.45)
            painter.drawText(box, int(Qt.AlignmentFlag.AlignCenter), mark.sign)
        painter.setPen(Qt.PenStyle.NoPen)


def _paint_spans(painter: QPainter, bar: TimelineBar, middle: float) -> None:
    for span in bar.spans:
        a, b = bar.x_of(span.start), bar.x_of(span.stop)
        painter.setBrush(QColor(span.colour))
        painter.drawRect(QRectF(a, middle + 3, max(b - a, 2.0), 5))


def _paint_head(painter: QPainter, at: QPointF, palette: QPalette) -> None:
    painter.setBrush(palette.highlight())
    painter.drawEllipse(at, 6, 6)
    painter.setBrush(palette.base())
    painter.drawEllipse(at, 2.5, 2.5)
