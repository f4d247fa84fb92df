"""The source of poses in the dialog: its options, and the tracker on each hand."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from PySide6.QtWidgets import QComboBox, QFormLayout, QLineEdit, QSpinBox, QWidget

from app.jobs.remote import RemoteControl
from app.viewmodels.streams import option_fields
from app.widgets.options_dialog import option_label, option_widget
from app.words import tr
from extensions.room.placement import ANY
from tracker.hand.names import SIDES
from tracker.streaming.connection import HOST

ALIGNMENT = "alignment"


class SourceForm(QWidget):
    """Fields of the source ``name``, as stored; `apply` stores what the user changed."""

    def __init__(self, remote: RemoteControl, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._remote, self.name = remote, name
        self._read: dict[str, Callable[[], Any]] = {}
        self.fields: dict[str, QWidget] = {}
        self.trackers: dict[str, QComboBox] = {}
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        kind = remote.kinds[name]
        values = remote.settings.options(kind)
        if kind.has(HOST):
            self._add(form, HOST, tr(kind.fields[HOST]), QLineEdit(values.host))
        if kind.has("port"):
            port = QSpinBox()
            port.setRange(1, 65535)
            port.setValue(values.port)
            self._add(form, "port", tr(kind.fields["port"]), port)
        for each in option_fields(kind, values):
            if each.name in SIDES:
                self._add_tracker(form, each.name, str(each.value))
            elif each.name != ALIGNMENT:
                widget, self._read[each.name] = option_widget(each.value, each.choices)
                self.fields[each.name] = widget
                widget.setAccessibleName(tr(each.help))
                form.addRow(option_label(each.help), widget)

    def _add(self, form: QFormLayout, name: str, label: str, widget: QLineEdit | QSpinBox) -> None:
        self.fields[name] = widget
        self._read[name] = widget.text if isinstance(widget, QLineEdit) else widget.value
        widget.setAccessibleName(label)
        form.addRow(label[:1].upper() + label[1:], widget)

    def _add_tracker(self, form: QFormLayout, side: str, value: str) -> None:
        combo = self.trackers[side] = QComboBox()
        combo.setEditable(True)
        combo.addItems(["", ANY])
        combo.setCurrentText(value)
        combo.setToolTip(
            self.tr("Name of the tracker on the hand; any: every tracker; empty: none")
        )
        label = {"right": self.tr("Tracker on the right hand"),
                 "left": self.tr("Tracker on the left hand")}[side]  # fmt: skip
        combo.setAccessibleName(label)
        form.addRow(label, combo)

    def show_names(self, names: Iterable[str]) -> None:
        """Offer the trackers that were received."""
        for combo in self.trackers.values():
            for name in names:
                if combo.findText(name) < 0:
                    combo.addItem(name)

    def tracker(self, side: str) -> str:
        """The name of the tracker on a hand; empty if there is none."""
        return self.trackers[side].currentText().strip()

    def apply(self) -> None:
        """Store what was changed; an open connection is opened again with it."""
        kind = self._remote.kinds[self.name]
        before = self._remote.settings.options(kind)
        now = {name: read() for name, read in self._read.items()}
        now |= {side: self.tracker(side) for side in self.trackers}
        host = now.pop(HOST, None)
        if isinstance(host, str) and host.strip() and host.strip() != before.host:
            self._remote.move(host.strip())
        for name, value in now.items():
            if value != getattr(before, name):
                self._remote.set_option(self.name, name, value)

    def options(self) -> Any:
        """The options as stored."""
        return self._remote.settings.options(self._remote.kinds[self.name])
