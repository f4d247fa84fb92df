"""Excludes the window's long-lived objects from garbage collection while a hand is tracked."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer

from app.platform.process_tuning import freeze_permanent_objects

if TYPE_CHECKING:
    from app.engines.engine_host import EngineHost

SETTLED_MS = 1500
"""After a start; by then the hand is found and all modules that tracking needs are loaded."""


def keep_pauses_short(host: EngineHost) -> None:
    """Exclude long-lived objects soon after each start, once the visible panels exist."""
    timer = QTimer(host)
    timer.setSingleShot(True)
    timer.setInterval(SETTLED_MS)
    timer.timeout.connect(freeze_permanent_objects)
    host.running_changed.connect(lambda running: timer.start() if running else timer.stop())
