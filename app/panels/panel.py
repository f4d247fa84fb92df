"""The base class of panels."""

from __future__ import annotations

from typing import Protocol

from PySide6.QtWidgets import QLabel, QWidget

from app.engines.snapshot import Snapshot
from tracker.messages import Shed


class PanelColours(Protocol):
    """Colours of the window's theme, as ``#RRGGBB``."""

    @property
    def base(self) -> str:
        """Background of plots and lists."""

    @property
    def text(self) -> str:
        """Text and axes on ``base``."""

    @property
    def scene(self) -> str:
        """Background of 3D views."""


class Panel(QWidget):
    """The contents of a dock. ``refresh`` is called at most every ``period`` seconds while it is
    visible.

    ``name`` is that of its `PanelKind`; the window sets it, and the title as its window title.
    """

    name = ""
    period = 1 / 30
    spared_at: Shed | None = None  # overload level from which on it is refreshed less often

    @property
    def works_unseen(self) -> bool:
        """Whether it is also refreshed while hidden, for work that it has to finish."""
        return False

    @property
    def needs_low_latency(self) -> bool:
        """Whether a device follows the hand and must not wait for the window's painting."""
        return False

    def refresh(self, view: Snapshot | None) -> None:
        """Show ``view``; None while no engine is open. Panels fed by signals need none."""

    def show_theme(self, colours: PanelColours) -> None:
        """Apply the colours that the style sheet does not: those of plots and 3D views."""

    def shut_down(self) -> None:
        """Free resources that Qt does not; called once before the window closes."""


class MessageLabel(QLabel):
    """A wrapped message below a panel's controls; hidden while it is empty."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWordWrap(True)
        self.hide()

    def show_message(self, text: str) -> None:
        self.setText(text)
        self.setVisible(bool(text))
