"""The banner's sentence where colours are to blame that no hand is found."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject

from app.panels.colours.panel import ColoursPanel
from app.window.message_bar import MessageBar

ABOUT = "colours"


class ColoursTold(QObject):
    """Says it while it is true, with the way to the panel; a fit is tried at once."""

    def __init__(
        self, messages: MessageBar, panel: ColoursPanel, show: Callable[[str], object]
    ) -> None:
        super().__init__(messages)
        self._messages, self._panel, self._show = messages, panel, show

    def tell(self, unfit: bool) -> None:
        """``unfit``: the colours find many patches and no hand."""
        if not unfit:
            self._messages.no_longer(ABOUT)
            return
        self._panel.fitting.fit_by_itself()
        text = self.tr("The colours find many patches, none fit the glove: fit the colours.")
        fit = (self.tr("Fit them now"), self._fit)
        look = (self.tr("Show the colours"), lambda: self._show(self._panel.name))
        self._messages.say(text, fit, look, about=ABOUT)

    def no_hand(self) -> None:
        """The glove sends, images come, and no hand was found among them since the start."""
        self._panel.fitting.fit_by_itself()

    def _fit(self) -> None:
        self._show(self._panel.name)  # it gathers images while it is in sight
        self._panel.fitting.fit_live()
