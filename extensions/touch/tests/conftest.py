"""Fixtures of the window."""

from tests.gui.conftest import no_leaks, qtbot, store, window

__all__ = ["no_leaks", "qtbot", "store", "window"]
