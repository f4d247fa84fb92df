"""The size of a window on the screen that it opens on."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QMainWindow

SMALLEST = (800, 500)
FRAME = (16, 48)  # px that a window manager's frame and title take at most


def fit_to_screen(window: QMainWindow, usual: tuple[int, int]) -> None:
    """The usual size, or as much of it as the screen has; the least size gives way too."""
    room = window.screen().availableSize() - QSize(*FRAME)
    window.setMinimumSize(QSize(*SMALLEST).boundedTo(room))
    window.resize(QSize(*usual).boundedTo(room))
