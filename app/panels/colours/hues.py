"""The hues of a profile: which one is tuned, how many blobs each has, what stands in its way."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QGridLayout, QRadioButton, QWidget

from app.viewmodels.colours import HueRow
from app.viewmodels.names import spoken
from app.widgets.chip import Chip
from app.widgets.measures import TIGHT

COLUMNS = 2
LONGEST = "● 19 of about 9 "


class ColoursHues(QWidget):
    """A button and a chip for each hue."""

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
        """Offer these hues."""
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
        """Mark the hue that is tuned."""
        self._group.button(index).setChecked(True)

    def show_rows(self, rows: Sequence[HueRow]) -> None:
        """The counts, in the order of `fill`."""
        for chip, row in zip(self.chips, rows, strict=True):
            chip.show_state(row.look.colour, row.look.sign, row.count, row.clash or row.tip)
