"""Fixtures of the window's tests."""

from tests.gui.conftest import engine, live, no_leaks, qtbot, store, window

__all__ = ["engine", "live", "no_leaks", "qtbot", "store", "window"]
