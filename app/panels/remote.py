"""Remote control: a switch, an address and a port for each protocol."""

from __future__ import annotations

from functools import partial

from PySide6.QtWidgets import (
    QDialog,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.jobs.remote import RemoteControl
from app.panels.connection_table import ConnectionTable
from app.viewmodels.streams import door_row, is_loopback, option_fields
from app.widgets.options_dialog import OptionsDialog
from app.words import tr


class RemoteBox(QGroupBox):
    """Shows a `RemoteControl`."""

    def __init__(self, remote: RemoteControl, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTitle(
            self.tr("Remote control: other programs start and stop recordings and add notes")
        )
        self._remote = remote
        self.options: dict[str, QPushButton] = {}
        column = QVBoxLayout(self)
        column.addLayout(self._address())
        column.addLayout(self._table())
        self.opened = QLabel(
            self.tr(
                "Anyone on the network can start and stop recordings at this address. There is no "
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
            self.tr("127.0.0.1: this computer only. 0.0.0.0: all networks of this computer")
        )
        self.address.editingFinished.connect(self._move)
        label = QLabel(self.tr("Listen on"))
        label.setBuddy(self.address)
        row = QHBoxLayout()
        row.addWidget(label)
        row.addWidget(self.address, 1)
        return row

    def _move(self) -> None:
        host = self.address.text().strip()
        if host and host != self._remote.settings.host:
            self._remote.move(host)

    def _table(self) -> ConnectionTable:
        table = ConnectionTable(
            (
                self.tr("Protocol"),
                self.tr("Port"),
                self.tr("State"),
                self.tr("Clients"),
                self.tr("Requests"),
                self.tr("Rejected"),
            )
        )
        for name, kind in self._remote.kinds.items():
            table.add(name, tr(kind.title), self._remote.switch)
            if kind.has("port"):
                table.add_port(name, tr(kind.title), self._remote.set_port)
            if option_fields(kind):
                table.put_buttons(name, self._options_button(name))
        self.table = table
        self.boxes, self.ports, self.cells = table.boxes, table.ports, table.cells
        return table

    def _options_button(self, name: str) -> QPushButton:
        title = tr(self._remote.kinds[name].title)
        button = self.options[name] = QPushButton(self.tr("Options…"))
        button.setAccessibleName(self.tr("Options of {}").format(title))
        button.clicked.connect(partial(self._edit_options, name))
        return button

    def _edit_options(self, name: str) -> None:
        kind = self._remote.kinds[name]
        fields = option_fields(kind, self._remote.settings.options(kind))
        dialog = OptionsDialog(tr(kind.title), fields, self)
        if dialog.exec() == QDialog.DialogCode.Accepted:
            for option, value in dialog.changed().items():
                self._remote.set_option(name, option, value)

    def show_state(self) -> None:
        """Show the current state, which the command line may have changed."""
        host = self._remote.settings.host
        if not self.address.hasFocus():
            self.address.setText(host)
        self.opened.setVisible(not is_loopback(host))
        for name in self._remote.kinds:
            on = self._remote.is_on(name)
            self.table.show_wanted(name, on, self._remote.port(name))
            row = door_row(on, self._remote.counts(name), self._remote.problems.get(name, ""))
            sign = f'<span style="color:{row.look.colour}">{row.look.sign}</span>'
            texts = f"{sign} {row.state}", row.clients, row.sent, row.dropped
            self.table.show_row(name, texts, row.tip)
