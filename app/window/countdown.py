"""The seconds until something begins, large over the window, with a beep where wanted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, QRect, Qt
from PySide6.QtGui import QColor, QKeySequence, QPainter, QPaintEvent, QShortcut
from PySide6.QtWidgets import QApplication, QMainWindow, QWidget

from app.jobs.pose_reset import PoseReset
from app.jobs.record_key import RecordKey

SIDE = 200  # px
SHADE, INK = QColor(0, 0, 0, 170), QColor("#FFFFFF")  # legible over images of any brightness


@dataclass(frozen=True)
class Announced:
    """What begins: ``title`` with a place for the seconds, ``words`` over the number; whether each
    second is to beep."""

    title: str
    beeps: Callable[[], bool]
    words: str = ""


class Countdown(QWidget):
    """Lies over the window's middle and takes no clicks; Esc cancels what is counted down to."""

    def __init__(
        self, key: RecordKey | PoseReset, announced: Announced, window: QMainWindow
    ) -> None:
        super().__init__(window)
        self._key, self._announced, self._window = key, announced, window
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFixedSize(SIDE, SIDE)
        self._escape = QShortcut(QKeySequence(Qt.Key.Key_Escape), window)
        self._escape.activated.connect(key.cancel)
        self._escape.setEnabled(False)
        key.counted.connect(self._show)
        window.installEventFilter(self)
        self.hide()

    def _show(self, left: int) -> None:
        self._escape.setEnabled(left > 0)
        self.setVisible(left > 0)
        if left:
            self.setAccessibleName(self._announced.title.format(left))
            self._place()
            self.raise_()
            self.update()
            if self._announced.beeps():
                QApplication.beep()

    def _place(self) -> None:
        self.move(self._window.rect().center() - self.rect().center())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._place()
        return super().eventFilter(watched, event)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setBrush(SHADE)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.drawEllipse(self.rect())
        painter.setPen(INK)
        number, words = self.font(), self.font()
        number.setPixelSize(SIDE // 3 if self._announced.words else SIDE // 2)
        number.setBold(True)
        painter.setFont(number)
        upper = QRect(0, 0, SIDE, 3 * SIDE // 4)
        if self._announced.words:
            upper = QRect(0, SIDE // 3, SIDE, SIDE // 3)
        painter.drawText(upper, Qt.AlignmentFlag.AlignCenter, str(self._key.left))
        words.setPixelSize(SIDE // 13)
        painter.setFont(words)
        lower = QRect(0, 2 * SIDE // 3, SIDE, SIDE // 5)
        painter.drawText(lower, Qt.AlignmentFlag.AlignCenter, self.tr("Esc: not now"))
        if self._announced.words:
            top = QRect(SIDE // 5, SIDE // 12, 3 * SIDE // 5, SIDE // 4)
            flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(top, flags, self._announced.words)
