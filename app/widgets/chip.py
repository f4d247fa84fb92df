"""A label with a sign, a name and a value."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from app.widgets.elided_label import ElidedLabel
from app.widgets.measures import NEAR, TIGHT


class Chip(QWidget):
    """``● Glove 100 Hz``: colour and shape of the sign show the state.

    ``firm``: its text is elided last if there is too little space.
    """

    def __init__(self, parent: QWidget | None = None, firm: bool = False) -> None:
        super().__init__(parent)
        self._sign, self._text = QLabel(), ElidedLabel()
        self._text.firm = firm
        row = QHBoxLayout(self)
        row.setContentsMargins(NEAR, 0, NEAR, 0)
        row.setSpacing(TIGHT)
        row.addWidget(self._sign)
        row.addWidget(self._text)
        row.addStretch(1)
        self._shown = ("", "", "")

    def show_state(self, colour: str, sign: str, text: str, tip: str = "") -> None:
        if tip != self.toolTip():
            self.setToolTip(tip)
            self.setAccessibleDescription(tip)
        if (colour, sign, text) == self._shown:
            return  # setting a label's text repaints it even if nothing changes
        if self._shown[:2] != (
            colour,
            sign,
        ):  # changing a style sheet is slower than everything else
            self._sign.setText(sign)
            self._sign.setStyleSheet(f"color: {colour}")
        self._shown = (colour, sign, text)
        self._text.setText(text)
        self.setAccessibleName(text)

    def width_with(self, text: str) -> int:
        """Width in px with this text."""
        advance = self._text.fontMetrics().horizontalAdvance
        return self.sizeHint().width() + advance(text) - advance(self._text.text())

    def text(self) -> str:
        return self._text.text()
