"""The window's objects are not gone through by the collector of garbage while a hand is tracked."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer

from app.platform.process_tuning import freeze_permanent_objects

if TYPE_CHECKING:
    from app.engines.engine_host import EngineHost

SETTLED_MS = 1500
"""After a start: the hand is found, and what a first look at it imports is there."""


def keep_pauses_short(host: EngineHost) -> None:
    """Set objects that stay aside soon after each start, when the panels in sight are made."""
    timer = QTimer(host)
    timer.setSingleShot(True)
    timer.setInterval(SETTLED_MS)
    timer.timeout.connect(freeze_permanent_objects)
    host.running_changed.connect(lambda running: timer.start() if running else timer.stop())
