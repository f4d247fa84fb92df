"""The record key: starts a recording, after an optional countdown, and stops it."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal

from app.engines.engine_host import EngineHost
from app.viewmodels.recording import RecordingPlan

SECOND_MS = 1000


class RecordKey(QObject):
    """``left``: s until the recording starts; 0 without a countdown."""

    counted = Signal(int)  # `left` has changed

    def __init__(
        self, host: EngineHost, plan: RecordingPlan, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._host, self._plan = host, plan
        self.left = 0
        self._timer = QTimer(self)
        self._timer.setInterval(SECOND_MS)
        self._timer.timeout.connect(self._count)
        host.recording.begun.connect(self.cancel)  # started by remote control, without a countdown
        host.running_changed.connect(lambda on: None if on else self.cancel())

    def press(self) -> None:
        """Stop the recording, cancel the countdown, or start."""
        if self._host.recording.request is not None:
            self._host.recording.end()
        elif self.left:
            self.cancel()
        elif self._plan.countdown and self._host.running and self._host.recording.is_possible:
            self._set(self._plan.countdown)
            self._timer.start()
        else:
            self._host.recording.toggle(self._plan.request)

    def cancel(self) -> None:
        """Cancel the countdown, if any."""
        self._timer.stop()
        if self.left:
            self._set(0)

    def _count(self) -> None:
        if self.left > 1:
            self._set(self.left - 1)
        else:
            self.cancel()
            self._host.recording.toggle(self._plan.request)

    def _set(self, left: int) -> None:
        self.left = left
        self.counted.emit(left)
