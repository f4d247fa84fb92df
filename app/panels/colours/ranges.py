"""The list of hues, the ranges of the selected hue, and a histogram of the image's hues."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QGridLayout, QLabel, QRadioButton, QVBoxLayout, QWidget

from app.viewmodels.colour_tuning import CHANNELS, ColourTuning
from app.viewmodels.colours import HueRow
from app.viewmodels.names import spoken
from app.widgets.chip import Chip
from app.widgets.hue_strip import HueStrip
from app.widgets.measures import TIGHT
from app.widgets.range_row import RangeRow

COLUMNS = 2
LONGEST = "● 19 of about 9 "


class ColoursHues(QWidget):
    """A button and a count for each hue."""

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.chips: list[Chip] = []
        self._group = QButtonGroup(self)
        self._group.idClicked.connect(self.chosen)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(TIGHT)
        self._grid.setVerticalSpacing(TIGHT)

    def fill(self, names: Sequence[str]) -> None:
        """Show these hues."""
        for button in self._group.buttons():
            self._group.removeButton(button)
            button.deleteLater()
        for chip in self.chips:
            chip.deleteLater()
        self.chips = []
        for i, name in enumerate(names):
            button, chip = QRadioButton(spoken(name)), Chip()
            chip.setMinimumWidth(self.fontMetrics().horizontalAdvance(LONGEST) + 12)
            self._group.addButton(button, i)
            self.chips.append(chip)
            row, column = divmod(i, COLUMNS)
            self._grid.addWidget(button, row, 2 * column)
            self._grid.addWidget(chip, row, 2 * column + 1)

    def choose(self, index: int) -> None:
        """Select a hue."""
        self._group.button(index).setChecked(True)

    def show_rows(self, rows: Sequence[HueRow]) -> None:
        """Show the counts, in the order of `fill`."""
        for chip, row in zip(self.chips, rows, strict=True):
            chip.show_state(row.look.colour, row.look.sign, row.count, row.clash or row.tip)


class ColoursRanges(QWidget):
    """The part of the panel with the ranges."""

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
        """Show the selected hue. If the engine ``followed`` the light, leave a field that is being
        edited."""
        self.hues.choose(tuning.hue)
        for channel, row in self.rows.items():
            low, high = getattr(tuning.hue_range, channel)
            row.set_values(low, high, spare_focused=followed)

    def show_rows(self, rows: Sequence[HueRow], words: str) -> None:
        self.hues.show_rows(rows)
        self.words.setText(words)
