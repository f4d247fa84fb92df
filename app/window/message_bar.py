"""Messages over the docks, which do not move: the message bar, countdowns, and who uses them."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QKeySequence, QPainter, QPaintEvent, QShortcut
from PySide6.QtWidgets import QApplication, QMainWindow, QTabBar, QVBoxLayout, QWidget

from app.engines.engine_host import EngineHost
from app.jobs.pose_reset import PoseReset
from app.jobs.record_key import RecordKey
from app.panels.calibration.panel import CalibrationPanel
from app.panels.colours.panel import ColoursPanel
from app.panels.log import LogPanel
from app.widgets.banner import Action, Banner
from app.widgets.measures import NEAR
from app.words import event_text
from tracker.messages import Event

MOVES = (
    QEvent.Type.Resize,
    QEvent.Type.LayoutRequest,
    QEvent.Type.Move,
    QEvent.Type.Show,
    QEvent.Type.Hide,
)
READ_MS = 8_000
"""After which messages of success disappear; see `MessageBar.show_message`."""
CHOOSE_MS = 20_000
"""The same for messages with buttons."""
SIDE = 200  # px
SHADE, INK = QColor(0, 0, 0, 170), QColor("#FFFFFF")  # legible over images of any brightness
RESETS = "pose_reset."  # codes of the notices about a pose reset
COLOURS = "colours"  # topic of a hint


class MessageBar(QWidget):
    """Shows one message until it is dismissed or obsolete. It covers the lowest panels, above their
    tabs and the status bar, so that nothing moves under the pointer, but never what `keep_clear`
    names."""

    dismissed = Signal(str)  # by the user: the topic
    shown = Signal(str, bool)  # a message, and whether nothing is wrong

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self.setObjectName("messages")
        self._window, self._about = window, ""
        self._clear: list[tuple[QWidget, QWidget]] = []
        self.banner = Banner()
        self.banner.dismissed.connect(self._dismiss)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._leave)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.addWidget(self.banner)
        window.installEventFilter(self)
        self.hide()

    def show_message(
        self,
        text: str,
        *actions: Action,
        good: bool = False,
        about: str = "",
        stays: bool = False,
    ) -> None:
        """Show a message with a button for each action.

        ``good``: nothing is wrong. ``about`` is the topic, for `no_longer`. A message that
        ``stays`` is not closed by its own buttons. A good message without a topic disappears after
        `READ_MS` or `CHOOSE_MS`, unless it has the pointer or the keyboard focus.
        """
        again = self.isVisible() and text == self.banner.text()
        self._about = about
        self.banner.show_text(text, *actions, good=good, stays=stays)
        self.show()
        self._place()
        self.raise_()
        self._timer.stop()
        if good and not about:
            self._timer.start(CHOOSE_MS if actions else READ_MS)
        if not again:
            self.shown.emit(text, good)

    def _dismiss(self) -> None:
        about = self._about
        self.hide()
        self.dismissed.emit(about)

    def _leave(self) -> None:
        """The time has passed; it starts again while the user is using the message."""
        focus = QApplication.focusWidget()
        if not self.underMouse() and (focus is None or not self.isAncestorOf(focus)):
            self._timer.stop()
            self.hide()

    def no_longer(self, about: str) -> None:
        """Hide the message about this topic: it is obsolete."""
        if self._about == about:
            self.hide()

    def keep_clear(self, part: QWidget, within: QWidget) -> None:
        """Do not cover ``part``, which moves with ``within``: it is needed during a message."""
        self._clear.append((part, within))
        for watched in (part, within):
            watched.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in MOVES and self.isVisible():
            self._place()
            self.raise_()  # docks that are laid out again would cover it
        return super().eventFilter(watched, event)

    def _place(self) -> None:
        """As wide as the window, as high as the message needs."""
        window = self._window
        tabs = window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)
        foot = window.statusBar().height() + max(
            (t.height() for t in tabs if t.isVisible()), default=0
        )
        height = self.heightForWidth(window.width())
        position = QRect(0, window.height() - foot - height, window.width(), height)
        for part, within in self._clear:
            used = self._rect(part) & self._rect(within)
            if part.isVisible() and used.intersects(position):
                position.moveBottom(used.top() - 1)
        self.setGeometry(position)

    def _rect(self, widget: QWidget) -> QRect:
        """Its rectangle in the window; empty for a floating panel."""
        if widget.window() is not self._window:
            return QRect()
        return QRect(widget.mapTo(self._window, QPoint(0, 0)), widget.size())


@dataclass(frozen=True)
class Announced:
    """A countdown's announcement: ``title`` with a placeholder for the seconds, ``text`` above the
    number; ``beeps`` returns whether each second beeps."""

    title: str
    beeps: Callable[[], bool]
    text: str = ""


class Countdown(QWidget):
    """Covers the middle of the window and ignores clicks; Esc cancels the countdown."""

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
        number, small = self.font(), self.font()
        number.setPixelSize(SIDE // 3 if self._announced.text else SIDE // 2)
        number.setBold(True)
        painter.setFont(number)
        upper = QRect(0, 0, SIDE, 3 * SIDE // 4)
        if self._announced.text:
            upper = QRect(0, SIDE // 3, SIDE, SIDE // 3)
        painter.drawText(upper, Qt.AlignmentFlag.AlignCenter, str(self._key.left))
        small.setPixelSize(SIDE // 13)
        painter.setFont(small)
        lower = QRect(0, 2 * SIDE // 3, SIDE, SIDE // 5)
        painter.drawText(lower, Qt.AlignmentFlag.AlignCenter, self.tr("Esc: cancel"))
        if self._announced.text:
            top = QRect(SIDE // 5, SIDE // 12, 3 * SIDE // 5, SIDE // 4)
            flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(top, flags, self._announced.text)


class ColoursHint(QObject):
    """Asks the user to fit the colours while they find no hand; tries a fit at once."""

    def __init__(
        self, messages: MessageBar, panel: ColoursPanel, show: Callable[[str], object]
    ) -> None:
        super().__init__(messages)
        self._messages, self._panel, self._show = messages, panel, show

    def show_unfit(self, unfit: bool) -> None:
        """``unfit``: many patches were detected and no hand was found."""
        if not unfit:
            self._messages.no_longer(COLOURS)
            return
        self._panel.fitting.fit_by_itself()
        text = self.tr(
            "Many patches have the markers' colours, but none fit the glove. Fit the colours."
        )
        fit = (self.tr("Fit colours now"), self._fit)
        look = (self.tr("Show the colours"), lambda: self._show(self._panel.name))
        self._messages.show_message(text, fit, look, about=COLOURS)

    def no_hand(self) -> None:
        """Packets and images arrive, and no hand has been found in them since the start."""
        self._panel.fitting.fit_by_itself()

    def _fit(self) -> None:
        self._show(self._panel.name)  # it collects images while it is visible
        self._panel.fitting.fit_live()


class DeviceSearch(Protocol):
    """Finds devices, and offers the set-up with messages about them; see `sources.Sources`."""

    @property
    def looking_for_devices(self) -> bool: ...

    def show_device_message(self, text: str) -> None: ...


class MessageRouter(QObject):
    """Shows in the message bar what jobs, devices and panels report; the log gets it too."""

    def __init__(
        self,
        messages: MessageBar,
        host: EngineHost,
        devices: DeviceSearch,
        log: LogPanel,
        calibration: CalibrationPanel,
    ) -> None:
        super().__init__(messages)
        self._messages, self._host, self._devices = messages, host, devices
        self._log, self._calibration = log, calibration
        messages.shown.connect(self._add_to_log)
        host.error.connect(self.show_message)
        host.happened.connect(self._show_event)

    def show_message(self, text: str) -> None:
        """Show an error."""
        self._messages.show_message(text)

    def show_failed_job(self, text: str) -> None:
        """The set-up can help where devices were searched for."""
        if self._devices.looking_for_devices:
            self._devices.show_device_message(text)
        else:
            self._messages.show_message(text)

    def _show_event(self, event: Event) -> None:
        """Only what the user can fix now: not the events of a session that is replayed."""
        setup = self._host.setup
        if setup is None or setup.player is not None:
            return
        if event.kind == "error" or event.code == "glove.port_denied":
            self._devices.show_device_message(event_text(event))
        elif event.kind == "device" and event.code.startswith(RESETS):
            self._messages.show_message(event_text(event), good=True)

    def _add_to_log(self, text: str, good: bool) -> None:
        """Once, where the log does not end with the same text already."""
        if not self._log.model.ends_with(text):
            self._log.add(Event(time.monotonic(), "note" if good else "error", text))

    def offer_to_save_wearer(self) -> None:
        """Offer to save the result of guided poses, which is otherwise lost at the end."""
        if not self._calibration.profiles.keep_learned():
            text = self.tr("The calibration is used until this session ends.")
            ask = (self.tr("Save it to a profile…"), self._calibration.wearer.ask_name)
            self._messages.show_message(text, ask, good=True)

    def show_removed(self, text: str, undo: Callable[[], None]) -> None:
        """Offer to undo a removal, which was not confirmed."""
        self._messages.show_message(text, (self.tr("Undo"), undo), good=True)
