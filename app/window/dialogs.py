"""What commands open over the window: the palette, the guide, the keys, who made it."""

from __future__ import annotations

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QMainWindow

from app.platform.guide import site
from app.widgets.command_palette import CommandPalette
from app.window.about import AboutDialog
from app.window.commands import Commands
from app.window.help import GuideDialog, KeysDialog

BELOW_TOP = 90  # px


class Dialogs:
    """Of one window and its ``commands``."""

    def __init__(self, window: QMainWindow, commands: Commands) -> None:
        self._window, self._commands = window, commands

    def palette(self) -> None:
        """Find a command by its words."""
        window = self._window
        palette = CommandPalette(list(self._commands.actions.values()), window)
        palette.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        corner = window.geometry().center() - palette.rect().center()
        palette.move(corner.x(), window.geometry().top() + BELOW_TOP)
        palette.open()

    def guide(self) -> None:
        GuideDialog(self._window).show()

    def documentation(self) -> None:
        """The whole of it in the browser; it needs no network."""
        page = site()
        if page is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(page)))

    def keys(self) -> None:
        KeysDialog(self._commands.menus(), self._window).show()

    def about(self) -> None:
        AboutDialog(self._window).show()

    def full_screen(self) -> None:
        """To and fro."""
        state = self._window.windowState()
        self._window.setWindowState(state ^ Qt.WindowState.WindowFullScreen)
