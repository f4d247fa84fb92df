"""Selection of the hand that single-hand panels show."""

from __future__ import annotations

from functools import partial

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.engines.host_parts import HandSwitch
from app.widgets.segments import Segments


class HandChoice(QWidget):
    """Buttons *Left hand* and *Right hand*, visible while two hands are open.

    All single-hand panels show the same hand, so that they are consistent.
    """

    def __init__(self, host: HandSwitch, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        titles = {"left": self.tr("Left hand"), "right": self.tr("Right hand")}
        self.actions_of = {side: QAction(title, self) for side, title in titles.items()}
        self._segments = Segments(list(self.actions_of.values()))
        for side, action in self.actions_of.items():
            action.triggered.connect(partial(self._choose, host, side))
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self._segments)
        self.setAccessibleName(self.tr("Hand"))
        self.hide()
        host.opened.connect(self._show)
        host.hand_changed.connect(self._show)
        host.closed.connect(self.hide)

    def _choose(self, host: HandSwitch, side: str, _checked: bool = False) -> None:
        self.actions_of[side].setChecked(True)  # clicking the checked button leaves it checked
        host.show_hand(side)

    def _show(self, setup: EngineSetup) -> None:
        self.setVisible(bool(setup.others))
        self.actions_of[setup.side].setChecked(True)
