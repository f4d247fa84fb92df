"""The docks that hold the panels."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QByteArray, QCoreApplication
from PySide6.QtWidgets import QDockWidget, QMainWindow

from app.panels.panel import Panel
from app.widgets.scrolled import Scrolled
from app.window.commands import Command, Commands
from app.window.layouts import LEFT


def make_docks(window: QMainWindow, panels: Sequence[Panel]) -> dict[str, QDockWidget]:
    """A dock for each panel, by the panel's name; none is shown yet."""
    docks = {}
    for panel in panels:
        dock = QDockWidget(panel.title(), window)
        dock.setObjectName(f"dock_{panel.name}")
        dock.setWidget(Scrolled(panel, dock))  # a move from parent to parent dresses it all anew
        docks[panel.name] = dock
        window.addDockWidget(LEFT, dock)
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


def geometry_of(window: QMainWindow) -> str:
    """Where the window stands, for the settings file."""
    return bytes(window.saveGeometry().toBase64().data()).decode()


def restore_geometry(window: QMainWindow, text: str) -> None:
    if text:
        window.restoreGeometry(QByteArray.fromBase64(text.encode()))
