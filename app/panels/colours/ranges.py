"""Which hue is tuned, its ranges, and where the hues of the image lie."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from app.panels.colours.hues import ColoursHues
from app.viewmodels.colour_tuning import CHANNELS, ColourTuning
from app.viewmodels.colours import HueRow
from app.widgets.hue_strip import HueStrip
from app.widgets.measures import TIGHT
from app.widgets.range_row import RangeRow


class ColoursRanges(QWidget):
    """The half of the panel with the numbers."""

    moved = Signal(str, int, int, bool)  # channel, first, last, whether a handle is held

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.hues = ColoursHues()
        names = (self.tr("Hue"), self.tr("Saturation"), self.tr("Value"))
        self.rows = {
            channel: RangeRow(name, 179 if channel == "hue" else 255, wraps=channel == "hue")
            for channel, name in zip(CHANNELS, names, strict=True)
        }
        for channel, row in self.rows.items():
            row.changed.connect(lambda a, b, held, key=channel: self.moved.emit(key, a, b, held))
        self.strip = HueStrip()
        self.words = QLabel()
        self.words.setWordWrap(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(TIGHT)
        for widget in (self.hues, *self.rows.values(), self.strip, self.words):
            column.addWidget(widget)
        column.addStretch(1)

    def show_range(self, tuning: ColourTuning, followed: bool = False) -> None:
        """The hue that is tuned; what the engine ``followed`` leaves a field in use alone."""
        self.hues.choose(tuning.hue)
        for channel, row in self.rows.items():
            low, high = getattr(tuning.hue_range, channel)
            row.set_values(low, high, spare_focused=followed)

    def show_rows(self, rows: Sequence[HueRow], words: str) -> None:
        self.hues.show_rows(rows)
        self.words.setText(words)
