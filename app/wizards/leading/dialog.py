"""A dialog that guides the wearer: a page that is refreshed continuously, then the result."""

from __future__ import annotations

from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QApplication, QDialog, QStackedWidget, QVBoxLayout, QWidget

from app.engines.engine_host import EngineHost
from app.storage.settings import SettingsStore
from app.wizards.leading.outcome import OutcomePage
from app.wizards.leading.page import LeadingPage
from app.wizards.sizing import fit_to_screen

TICK_MS = 33
SMALLEST_PX = 20
INK = "#101418"  # on the colour of a state: contrast of 5 or more


class LeadingDialog(QDialog):
    """Not modal; closes when the engine stops. ``due``: refresh the guiding page."""

    due = Signal()

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        pages: tuple[LeadingPage, OutcomePage],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        lead, outcome = pages
        self._first = lead
        fit_to_screen(self, 1280, 760)
        self.pages = QStackedWidget()
        self.pages.addWidget(lead)
        self.pages.addWidget(outcome)
        QVBoxLayout(self).addWidget(self.pages)
        lead.sound.setChecked(store.value.guided_sound)
        lead.sound.toggled.connect(lambda on: store.update(guided_sound=on))
        lead.stop.clicked.connect(self.reject)
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self.tick)
        host.running_changed.connect(self._running_changed)
        host.closed.connect(self.give_up)

    @property
    def leads(self) -> bool:
        """Whether the guiding page is shown."""
        return self.pages.currentWidget() is self._first

    def begin(self) -> None:
        """Start refreshing."""
        self._timer.start()
        self.tick()

    def tick(self) -> None:
        if self.leads:
            self.due.emit()

    def beep(self) -> None:
        """Beep, if sound is enabled."""
        if self._first.sound.isChecked():
            QApplication.beep()

    def _running_changed(self, on: bool) -> None:
        if not on:
            self.give_up()

    def give_up(self) -> None:
        """Close without asking, because the engine has changed."""
        if self.isVisible():
            self.done(int(QDialog.DialogCode.Rejected))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Scale the text with the window: it is read from a distance."""
        super().resizeEvent(event)
        px = max(min(self.height() // 17, self.width() // 26), SMALLEST_PX)
        self.setStyleSheet(
            f"QLabel#leading_words {{ font-size: {px}px; font-weight: 600; }}"
            f"QLabel#leading_beat {{ font-size: {2 * px}px; font-weight: 700; }}"
            f"QLabel#leading_word {{ font-size: {round(1.15 * px)}px; font-weight: 700;"
            f" color: {INK}; padding: 6px 12px; border-radius: 6px; }}"
            f"QPushButton {{ font-size: {max(round(0.42 * px), 13)}px; }}"
            f"QLabel#leading_notes {{ font-size: {max(round(0.55 * px), 14)}px; }}"
            f"QLabel#leading_chips {{ font-size: {max(round(0.48 * px), 13)}px; }}"
        )

    def done(self, result: int) -> None:
        """Clean up, however the dialog is closed."""
        self._timer.stop()
        self._first.stage.shut_down()
        super().done(result)
