"""The legend of the 3D hand: colours of measured, inferred and lost joints."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from app.viewmodels.states import VALIDITY
from app.widgets.measures import WIDE
from tracker.messages import Validity


class ValidityLegend(QWidget):
    """Further widgets can be appended to ``row``."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.row = QHBoxLayout(self)
        self.row.setContentsMargins(0, 0, 0, 0)
        self.row.setSpacing(WIDE)
        words = {
            Validity.MEASURED: self.tr("measured"),
            Validity.INFERRED: self.tr("inferred"),
            Validity.LOST: self.tr("lost"),
        }
        for state, word in words.items():
            look = VALIDITY[state]
            text = f'<span style="color:{look.colour}">{look.sign}</span> {word}'
            self.row.addWidget(QLabel(text))
