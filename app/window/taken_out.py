"""Panels that are taken out of the window and put back."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QMainWindow

from app.window.layouts import Docks, Shares, resize


class TakenOut(QObject):
    """Gives a panel that comes back to its place the share that it had; by itself Qt gives it half
    of that, and the rest to the others. ``shares`` tells those of now."""

    def __init__(self, window: QMainWindow, docks: Docks, shares: Callable[[], Shares]) -> None:
        super().__init__(window)
        self._window, self._docks, self._shares = window, docks, shares
        self._before: dict[str, Shares] = {}  # by the panel that is out
        for name, dock in docks.items():
            dock.topLevelChanged.connect(partial(self._moved, name))

    def _moved(self, name: str, out: bool) -> None:
        if out:
            self._before[name] = dict(self._shares())
            return
        before = self._before.pop(name, {})
        if name in before:
            QTimer.singleShot(0, self, lambda: resize(self._window, self._docks, before))
