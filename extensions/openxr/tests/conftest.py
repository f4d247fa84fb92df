"""Fixtures of the tests of OpenXR."""

from tests.gui.conftest import no_leaks, qtbot, store, window
from tests.streaming.conftest import make_estimate, names, wait_for

__all__ = ["make_estimate", "names", "no_leaks", "qtbot", "store", "wait_for", "window"]
