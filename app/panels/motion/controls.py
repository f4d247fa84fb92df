"""The Motion panel's line of controls: units, distances to be measured, the table to take out."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QComboBox, QPushButton, QWidget

from app.viewmodels.names import spoken
from app.widgets.one_line import OneLine


class MotionControls(OneLine):
    """Widgets; `MotionPanel` does what they ask."""

    def __init__(self, unit: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.ends = QComboBox(), QComboBox()
        self.ends[0].setAccessibleName(self.tr("Distance from"))
        self.ends[1].setAccessibleName(self.tr("Distance to"))
        self.measure = QPushButton(self.tr("Measure this distance"))
        self.remove = QPushButton(self.tr("Remove"))
        self.remove.setToolTip(self.tr("Measure the chosen distances no more"))
        self.units = QComboBox()
        self.units.setAccessibleName(self.tr("Unit of angles"))
        self.units.addItem(self.tr("Degrees"), "deg")
        self.units.addItem(self.tr("Radians"), "rad")
        self.units.setCurrentIndex(self.units.findData(unit))
        self.copy = QPushButton(self.tr("Copy the table"))
        self.save = QPushButton(self.tr("Save as CSV…"))
        for widget in (self.units, self.copy, self.save, *self.ends, self.measure, self.remove):
            self.add(widget)

    def offer_points(self, names: Sequence[str]) -> None:
        """Points between which distances can be measured; the first and the last are chosen."""
        for box in self.ends:
            box.clear()
            for name in names:
                box.addItem(spoken(name), name)
        self.ends[1].setCurrentIndex(self.ends[1].count() - 1)

    @property
    def pair(self) -> tuple[str, str]:
        """The points chosen."""
        return self.ends[0].currentData(), self.ends[1].currentData()

    def enable(self, on: bool) -> None:
        for widget in (*self.ends, self.measure, self.remove, self.copy, self.save):
            widget.setEnabled(on)
