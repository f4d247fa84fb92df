"""Who may start, stop and note from outside: a switch, an address and a port for each way in."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.jobs.remote import RemoteControl
from app.viewmodels.remote import DOORS, door_row, is_loopback, title
from app.widgets.measures import NEAR

COLUMNS = ("state", "clients", "sent", "dropped")


class RemoteBox(QGroupBox):
    """Shows a `RemoteControl`."""

    def __init__(self, remote: RemoteControl, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTitle(self.tr("Remote control: start, stop and note from other programs"))
        self._remote = remote
        self.boxes: dict[str, QCheckBox] = {}
        self.ports: dict[str, QSpinBox] = {}
        self.cells: dict[str, dict[str, QLabel]] = {}
        column = QVBoxLayout(self)
        column.addLayout(self._address())
        column.addLayout(self._table())
        self.opened = QLabel(
            self.tr(
                "Others in the network can start and stop recordings at this address: there is no "
                "password."
            )
        )
        self.opened.setProperty("role", "warning")
        self.opened.setWordWrap(True)
        column.addWidget(self.opened)
        remote.changed.connect(self.show_state)
        self.show_state()

    def _address(self) -> QHBoxLayout:
        self.address = QLineEdit()
        self.address.setToolTip(
            self.tr("127.0.0.1: this computer alone. 0.0.0.0: all networks it is in")
        )
        self.address.editingFinished.connect(self._move)
        label = QLabel(self.tr("Listens at"))
        label.setBuddy(self.address)
        row = QHBoxLayout()
        row.addWidget(label)
        row.addWidget(self.address, 1)
        return row

    def _move(self) -> None:
        host = self.address.text().strip()
        if host and host != self._remote.params.host:
            self._remote.move(host)

    def _table(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(NEAR)
        grid.setColumnStretch(2, 1)
        headings = (
            self.tr("By"),
            self.tr("Port"),
            self.tr("State"),
            self.tr("Clients"),
            self.tr("Requests"),
            self.tr("Refused"),
        )
        for j, text in enumerate(headings):
            heading = QLabel(text)
            heading.setProperty("role", "faint")
            grid.addWidget(heading, 0, j)
        for i, name in enumerate(DOORS, start=1):
            self._add_row(grid, i, name)
        return grid

    def _add_row(self, grid: QGridLayout, i: int, name: str) -> None:
        box = self.boxes[name] = QCheckBox(title(name))
        box.toggled.connect(partial(self._remote.switch, name))
        port = self.ports[name] = QSpinBox()
        port.setRange(1, 65535)
        port.setAccessibleName(self.tr("Port of {}").format(title(name)))
        port.setKeyboardTracking(False)
        port.valueChanged.connect(partial(self._remote.set_port, name))
        grid.addWidget(box, i, 0)
        grid.addWidget(port, i, 1)
        self.cells[name] = {column: QLabel() for column in COLUMNS}
        for j, label in enumerate(self.cells[name].values(), start=2):
            if j > 2:
                label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            grid.addWidget(label, i, j)

    def show_state(self) -> None:
        """As it is now; the command line may have changed it."""
        params = self._remote.params
        if not self.address.hasFocus():
            self.address.setText(params.host)
        self.opened.setVisible(not is_loopback(params.host))
        for name in DOORS:
            on = self._remote.is_on(name)
            box, port = self.boxes[name], self.ports[name]
            with QSignalBlocker(box), QSignalBlocker(port):
                box.setChecked(on)
                if not port.hasFocus():
                    port.setValue(getattr(params, f"{name}_port"))
            self._show_row(name, on)

    def _show_row(self, name: str, on: bool) -> None:
        row = door_row(on, self._remote.counts(name), self._remote.problems.get(name, ""))
        sign = f'<span style="color:{row.look.colour}">{row.look.sign}</span>'
        texts = (f"{sign} {row.state}", row.clients, row.sent, row.dropped)
        for label, text in zip(self.cells[name].values(), texts, strict=True):
            if label.text() != text:
                label.setText(text)
            label.setToolTip(row.tip)
