"""The docks that hold the panels."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QByteArray, QCoreApplication
from PySide6.QtWidgets import QDockWidget, QMainWindow

from app.panels.panel import Panel
from app.widgets.scrolled import Scrolled
from app.window.commands import Command, Commands
from app.window.layouts import LEFT


def make_docks(window: QMainWindow, panels: Mapping[str, Panel]) -> dict[str, QDockWidget]:
    """A dock for each panel, by the panel's name; none is shown yet."""
    docks = {}
    for name, panel in panels.items():
        dock = QDockWidget(panel.windowTitle(), window)
        dock.setObjectName(f"dock_{name}")
        dock.setWidget(Scrolled(panel, dock))  # a move from parent to parent dresses it all anew
        docks[name] = dock
        window.addDockWidget(LEFT, dock)
        dock.hide()
    return docks


def list_docks(
    docks: dict[str, QDockWidget],
    numbers: Mapping[str, int],
    commands: Commands,
    show: Callable[[str], None],
) -> None:
    """A command for each, that shows it and brings it to the front; its own button hides it.

    ``numbers``: of the panels' kinds; of two with the same one, the first has the key.
    """
    menu = QCoreApplication.translate("MainWindow", "&View")
    first = True
    taken = {""}
    for name, dock in docks.items():
        keys = keys_of(numbers[name])
        keys = "" if keys in taken else keys
        taken.add(keys)
        run = partial(show, name)
        commands.add(Command(f"dock_{name}", menu, dock.windowTitle(), run, keys, separator=first))
        first = False


def keys_of(number: int) -> str:
    """The key that shows the panel of this ``number``; empty for none."""
    if not 1 <= number <= 18:
        return ""
    return f"Ctrl+{number}" if number < 10 else f"Ctrl+Alt+{number - 9}"


def geometry_of(window: QMainWindow) -> str:
    """Where the window stands, for the settings file."""
    return bytes(window.saveGeometry().toBase64().data()).decode()


def restore_geometry(window: QMainWindow, text: str) -> None:
    if text:
        window.restoreGeometry(QByteArray.fromBase64(text.encode()))
