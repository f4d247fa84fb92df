"""Fixtures of the window's tests."""

from tests.gui.conftest import (  # noqa: F401
    engine,
    live,
    no_leaks,
    qtbot,
    store,
    window,
)
