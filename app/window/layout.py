"""Where the docks stand when nobody has moved them."""

from __future__ import annotations

import itertools

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow

LEFT_BELOW = ("sensors", "library", "log")
RIGHT_BELOW = ("checklist", "calibration", "colours", "recording", "streams")


def arrange(window: QMainWindow, docks: dict[str, QDockWidget]) -> None:
    """Images left, hand right, everything else as tabs below them."""
    for dock in docks.values():
        window.removeDockWidget(dock)
    left, right = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
    window.addDockWidget(left, docks["cameras"])
    window.addDockWidget(right, docks["hand"])
    _tabs(window, docks, left, LEFT_BELOW)
    _tabs(window, docks, right, RIGHT_BELOW)
    for dock in docks.values():
        dock.setFloating(False)
        dock.show()
    docks[LEFT_BELOW[0]].raise_()
    docks["calibration"].raise_()
    _proportions(window, docks)


def _tabs(
    window: QMainWindow,
    docks: dict[str, QDockWidget],
    area: Qt.DockWidgetArea,
    names: tuple[str, ...],
) -> None:
    for name in names:
        window.addDockWidget(area, docks[name])
    for first, second in itertools.pairwise(names):
        window.tabifyDockWidget(docks[first], docks[second])


def _proportions(window: QMainWindow, docks: dict[str, QDockWidget]) -> None:
    width, height = window.width(), window.height()
    sides = [docks["cameras"], docks["hand"]]
    window.resizeDocks(sides, [round(width * 0.58), round(width * 0.42)], Qt.Orientation.Horizontal)
    for top, below in (("cameras", LEFT_BELOW[0]), ("hand", RIGHT_BELOW[0])):
        pair = [docks[top], docks[below]]
        share = [round(height * 0.55), round(height * 0.45)]
        window.resizeDocks(pair, share, Qt.Orientation.Vertical)
