"""The docks that hold the panels, and where they stand when nobody has moved them."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QByteArray, QCoreApplication, Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow

from app.panels.panel import Panel
from app.widgets.scrolled import Scrolled
from app.window.commands import Command, Commands

LEFT_BELOW = ("sensors", "library", "log")
RIGHT_BELOW = ("checklist", "calibration", "colours", "recording", "streams")


def make_docks(window: QMainWindow, panels: Sequence[Panel]) -> dict[str, QDockWidget]:
    """A dock for each panel, by the panel's name; none is shown yet."""
    docks = {}
    for panel in panels:
        dock = QDockWidget(panel.title(), window)
        dock.setObjectName(f"dock_{panel.name}")
        dock.setWidget(Scrolled(panel))
        docks[panel.name] = dock
    arrange(window, docks)
    for dock in docks.values():
        dock.hide()
    return docks


def list_docks(
    docks: dict[str, QDockWidget], commands: Commands, show: Callable[[str], None]
) -> None:
    """A command for each, that shows it and brings it to the front; its own button hides it."""
    menu = QCoreApplication.translate("MainWindow", "&View")
    for i, (name, dock) in enumerate(docks.items(), start=1):
        keys = f"Ctrl+{i}" if i < 10 else f"Ctrl+Alt+{i - 9}"
        title = dock.windowTitle()
        commands.add(
            Command(f"dock_{name}", menu, title, partial(show, name), keys, separator=i == 1)
        )


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


def places_of(window: QMainWindow, with_layout: bool) -> dict[str, str]:
    """What the settings keep of where the window and its docks stand, in base64."""
    kept = {"geometry": window.saveGeometry()}
    if with_layout:
        kept["layout"] = window.saveState()
    return {name: bytes(data.toBase64().data()).decode() for name, data in kept.items()}


def restore_geometry(window: QMainWindow, text: str) -> None:
    if text:
        window.restoreGeometry(QByteArray.fromBase64(text.encode()))


def restore_layout(window: QMainWindow, text: str) -> None:
    if text:
        window.restoreState(QByteArray.fromBase64(text.encode()))


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
