"""Excludes the window's long-lived objects from garbage collection, without a pause while a hand is
tracked."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer

from app.platform.process_tuning import freeze_new_objects, freeze_permanent_objects

if TYPE_CHECKING:
    from app.engines.engine_host import EngineHost

SETTLED_MS = 1500
"""After a start; by then the hand is found and all modules that tracking needs are loaded."""


def keep_pauses_short(host: EngineHost) -> None:
    """Exclude long-lived objects when the window has been made and whenever tracking has ended, and
    soon after each start those that have been added, once the visible panels exist."""
    idle, settled = _timer(host, 0), _timer(host, SETTLED_MS)
    idle.timeout.connect(freeze_permanent_objects)
    settled.timeout.connect(freeze_new_objects)

    def follow(running: bool) -> None:
        begun, ended = (settled, idle) if running else (idle, settled)
        ended.stop()
        begun.start()

    host.running_changed.connect(follow)
    idle.start()


def _timer(host: EngineHost, delay_ms: int) -> QTimer:
    timer = QTimer(host)
    timer.setSingleShot(True)
    timer.setInterval(delay_ms)
    return timer
