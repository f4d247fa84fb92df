"""Fixtures of the window's tests."""

from tests.gui.conftest import engine, live, no_leaks, qtbot, store, window
from tests.session.conftest import maker, record, session_info

__all__ = [
    "engine",
    "live",
    "maker",
    "no_leaks",
    "qtbot",
    "record",
    "session_info",
    "store",
    "window",
]
