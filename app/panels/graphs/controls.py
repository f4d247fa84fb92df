"""What a graph can be asked: its span, pause, fit, copy, close."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox, QHBoxLayout, QToolButton, QWidget

from app.viewmodels.graphs import SPANS, WHOLE
from app.widgets.icons import dress
from app.widgets.measures import TIGHT


class GraphControls(QWidget):
    """Widgets in a row."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.span = QComboBox()
        self.span.setAccessibleName(self.tr("Time window"))
        self.span.setToolTip(self.tr("Time window"))
        self.pause = self._button("pause", self.tr("Pause this graph; tracking goes on"))
        self.pause.setCheckable(True)
        words = self.tr("Fit both axes to the curves (double-click the graph)")
        self.fit = self._button("maximize", words)
        self.copy = self._button("copy", self.tr("Copy what is shown as CSV"))
        self.close_button = self._button("x", self.tr("Remove this graph"))
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(TIGHT)
        for widget in (self.span, self.pause, self.fit, self.copy, self.close_button):
            row.addWidget(widget)

    def _button(self, icon: str, text: str) -> QToolButton:
        button = QToolButton()
        dress(button, icon)
        button.setToolTip(text)
        button.setAccessibleName(text)
        button.setAutoRaise(True)
        return button

    def offer_spans(self, replay: bool, chosen: float) -> None:
        """Those of a recording, or of a live hand."""
        self.span.clear()
        for span in (WHOLE, *SPANS) if replay else SPANS:
            text = self.tr("Whole recording") if span == WHOLE else f"{span:.0f} s"
            self.span.addItem(text, span)
        self.span.setCurrentIndex(max(0, self.span.findData(chosen)))

    @property
    def chosen_span(self) -> float:
        """s, or `WHOLE`."""
        return float(self.span.currentData())
