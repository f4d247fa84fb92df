"""A window that flashes while something is measured."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

from PySide6.QtCore import QEventLoop, Qt, Signal
from PySide6.QtGui import QColor, QHideEvent, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication, QWidget

from app.platform.screens import has_screen
from tracker.base.errors import DeviceError
from tracker.base.notices import notice

R = TypeVar("R")
Measuring = Callable[[Callable[[bool], None], Callable[[], bool]], R]
"""Measures with what lights a screen up or darkens it, and tells whether the user wants an end."""
DARK, LIT, INK = QColor("black"), QColor("white"), QColor("#a0a8b0")
TEXT_PT = 20.0


class FlashWindow(QWidget):
    """Black with a text, or white while it is lit."""

    changed = Signal(bool)  # whether it is lit; from any thread
    measured = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.lit, self.ended = False, threading.Event()
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.changed.connect(self._change)

    def _change(self, lit: bool) -> None:
        self.lit = lit
        self.repaint()  # at once

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), LIT if self.lit else DARK)
        if not self.lit:
            painter.setPen(INK)
            font = self.font()
            font.setPointSizeF(TEXT_PT)
            painter.setFont(font)
            flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(self.rect().adjusted(40, 40, -40, -40), int(flags), self._text())
        painter.end()

    def _text(self) -> str:
        return self.tr(
            "Point the left camera at this window and tap on the table with the glove, firmly and "
            "at irregular times. Esc ends the measurement."
        )

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.close()

    def hideEvent(self, event: QHideEvent) -> None:
        self.ended.set()


class _Work(Generic[R]):
    """A measurement in a thread of its own."""

    def __init__(self, measuring: Measuring[R], window: FlashWindow) -> None:
        self._measuring, self._window = measuring, window
        self._result: list[R] = []
        self._error: BaseException | None = None
        self.thread = threading.Thread(target=self._run, name="glovetrack-loop-back")

    def _run(self) -> None:
        try:
            is_ended = self._window.ended.is_set
            self._result.append(self._measuring(self._window.changed.emit, is_ended))
        except BaseException as error:  # noqa: BLE001 - raised again by `result`
            self._error = error
        finally:
            self._window.measured.emit()

    def result(self) -> R:
        """Waits for the end. Raises what the measurement raised."""
        self.thread.join()
        if self._error is not None:
            raise self._error
        return self._result[0]


def flash_while(measuring: Measuring[R]) -> R:
    """Shows a window that fills the screen until ``measuring`` has ended; returns its result.

    Raises DeviceError without a screen, and what ``measuring`` raises.
    """
    if not has_screen():
        raise DeviceError(notice("loopback.screen_missing"))
    app = QApplication.instance() or QApplication(["glovetrack"])
    window, loop = FlashWindow(), QEventLoop()
    window.measured.connect(loop.quit)
    work = _Work(measuring, window)
    window.showFullScreen()
    work.thread.start()
    loop.exec()
    window.close()
    del app
    return work.result()
