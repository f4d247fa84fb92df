"""Dialogs that fit small and magnified screens."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QDialog

MARGIN = 48  # of the window frame and the desktop's bars, px


def fit_to_screen(dialog: QDialog, width: int, height: int) -> None:
    """Resize to this size, limited to that of the screen."""
    screen = dialog.screen().availableSize() - QSize(MARGIN, MARGIN)
    dialog.resize(QSize(width, height).boundedTo(screen))
