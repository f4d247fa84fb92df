"""Fixtures of the tests of trackers in the room."""

from tests.fixtures import glove, hand
from tests.gui.conftest import no_leaks, qtbot, store, window
from tests.streaming.conftest import wait_for

__all__ = ["glove", "hand", "no_leaks", "qtbot", "store", "wait_for", "window"]
