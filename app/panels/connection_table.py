"""A table of connections: a switch, a port, buttons, the state, and three counts.

In a narrow panel the last columns are out of view: the counts, not the buttons.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QCoreApplication, QSignalBlocker, Qt
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QSpinBox, QWidget

from app.widgets.measures import NEAR

COLUMNS = ("state", "clients", "sent", "dropped")
BUTTONS = 2  # column of the buttons, which has no heading
PORT_WIDTH = 84  # px, for five digits and the arrows


class ConnectionTable(QGridLayout):
    """``boxes``, ``ports`` (of those that have one) and ``cells`` by the connection's name."""

    def __init__(self, headings: Sequence[str]) -> None:
        """``headings``: those of the switch, the port, and each of `COLUMNS`."""
        super().__init__()
        self.boxes: dict[str, QCheckBox] = {}
        self.ports: dict[str, QSpinBox] = {}
        self.cells: dict[str, dict[str, QLabel]] = {}
        self.setHorizontalSpacing(NEAR)
        self.setColumnStretch(BUTTONS + 1, 1)
        for j, text in enumerate(headings):
            heading = QLabel(text)
            heading.setProperty("role", "faint")
            self.addWidget(heading, 0, j if j < BUTTONS else j + 1)

    def add(
        self,
        name: str,
        title: str,
        switch: Callable[[str, bool], object],
    ) -> None:
        """Add a row; ``switch`` gets the connection's name as its first argument."""
        i = self.rowCount()
        box = self.boxes[name] = QCheckBox(title)
        box.toggled.connect(partial(switch, name))
        self.addWidget(box, i, 0)
        self.cells[name] = {column: QLabel() for column in COLUMNS}
        for j, label in enumerate(self.cells[name].values(), start=BUTTONS + 1):
            if j > BUTTONS + 1:
                label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            self.addWidget(label, i, j)

    def add_port(self, name: str, title: str, set_port: Callable[[str, int], object]) -> None:
        """Add the port of a row; ``set_port`` gets the connection's name as its first argument."""
        port = self.ports[name] = QSpinBox()
        port.setRange(1, 65535)
        port.setFixedWidth(PORT_WIDTH)
        words = QCoreApplication.translate("ConnectionTable", "Port of {}")
        port.setAccessibleName(words.format(title))
        port.setKeyboardTracking(False)
        port.valueChanged.connect(partial(set_port, name))
        self.put_at_port(name, port)

    def put_buttons(self, name: str, widget: QWidget) -> None:
        """After the port."""
        row = 1 + list(self.boxes).index(name)  # below the headings
        self.addWidget(widget, row, BUTTONS)

    def put_at_port(self, name: str, widget: QWidget) -> None:
        """Show a widget instead of the port, for a connection without one."""
        row = 1 + list(self.boxes).index(name)  # below the headings
        self.addWidget(widget, row, 1)

    def show_wanted(self, name: str, on: bool, port: int | None) -> None:
        """Show the settings without emitting changes; a port that is being edited is unchanged."""
        box = self.boxes[name]
        with QSignalBlocker(box):
            box.setChecked(on)
        field = self.ports.get(name)
        if field is not None and port is not None and not field.hasFocus():
            with QSignalBlocker(field):
                field.setValue(port)

    def show_row(self, name: str, texts: Sequence[str], tip: str) -> None:
        """A text for each of `COLUMNS`."""
        for label, text in zip(self.cells[name].values(), texts, strict=True):
            if label.text() != text:
                label.setText(text)
            label.setToolTip(tip)
