"""Live streams to other programs, and the vibration motors of the glove."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from html import escape
from pathlib import Path
from typing import Any, Protocol

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QFileDialog,
    QGridLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QSlider,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import ErrorSignal, RunState
from app.engines.snapshot import Snapshot
from app.jobs.outputs import Outputs
from app.jobs.remote import RemoteControl
from app.panels.connection_table import ConnectionTable
from app.panels.panel import Panel
from app.panels.remote import RemoteBox
from app.viewmodels.streams import MOTORS, OPENXR, OWN, StreamRow, option_fields, stream_row, tested
from app.widgets.measures import NEAR
from app.widgets.options_dialog import OptionsDialog
from app.words import mark, tr

MOTOR_TITLES = {
    "thumb": mark("Thumb"),
    "index": mark("Index"),
    "middle": mark("Middle"),
    "ring": mark("Ring"),
    "little": mark("Little"),
}
TEST_MS = 300
MOST, USUAL = 255, 200  # amplitude


WIDTH = 90
"""px, width of a file name."""
OPTIONS_WIDTH = 40  # px


class RecordFile(QPushButton):
    """Shows the file of the stream ``name``."""

    def __init__(self, outputs: Outputs, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._outputs, self._name = outputs, name
        self._title = self.tr("File of {}").format(tr(outputs.kinds[name].title))
        self._suffix = Path(outputs.kinds[name].default_file).suffix
        self.setAccessibleName(self._title)
        self.clicked.connect(self._choose)
        outputs.changed.connect(self._show)
        self._show()

    def _choose(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self,
            self._title,
            str(self._outputs.file(self._name)),
            self.tr("Hand records (*{})").format(self._suffix),
            options=QFileDialog.Option.DontConfirmOverwrite,
        )
        if path:
            chosen = Path(path).with_suffix(self._suffix)
            self._outputs.set_option(self._name, "file", str(chosen))
            self._show()

    def _show(self) -> None:
        path = self._outputs.file(self._name)
        middle = Qt.TextElideMode.ElideMiddle
        self.setText(self.fontMetrics().elidedText(path.name, middle, WIDTH))
        self.setToolTip(self.tr("{}; a number is added if the file exists").format(path))


class StreamsHost(ErrorSignal, RunState, Protocol):
    """What the panel uses of the engine host."""


class StreamsPanel(Panel):
    period = 0.5

    def __init__(
        self,
        host: StreamsHost,
        outputs: Outputs,
        remote: RemoteControl,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._outputs = outputs
        self.remote = RemoteBox(remote)
        inside = QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        column.addLayout(self._address())
        self.tests: dict[str, QPushButton] = {}
        self.options: dict[str, QPushButton] = {}
        column.addWidget(self._result())
        column.addLayout(self._table())
        column.addWidget(self._reach())
        column.addWidget(self._haptics())
        column.addWidget(self.remote)
        column.addStretch(1)
        scroll = QScrollArea()
        scroll.setWidget(inside)
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QScrollArea.Shape.NoFrame)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(scroll)
        outputs.changed.connect(self._show)
        host.running_changed.connect(lambda _on: self._show())
        self._show()

    # --- streams

    def _address(self) -> QHBoxLayout:
        self.address = QLineEdit(self._outputs.settings.host)
        self.address.setToolTip(
            self.tr(
                "UDP and VMC send to this address, servers listen on it; 127.0.0.1 is this "
                "computer "
                "only"
            )
        )
        self.address.editingFinished.connect(self._move)
        label = QLabel(self.tr("&Address"))
        label.setBuddy(self.address)
        row = QHBoxLayout()
        row.addWidget(label)
        row.addWidget(self.address, 1)
        row.addWidget(self._joints())
        return row

    def _joints(self) -> QComboBox:
        """The selection of the joints that all streams contain."""
        self.joints = QComboBox()
        self.joints.setAccessibleName(self.tr("Joints"))
        self.joints.setToolTip(
            self.tr("The joints in the streams: Glovetrack's 21, or the 26 of OpenXR in its axes")
        )
        for text, value in (
            (self.tr("Glovetrack joints"), OWN),
            (self.tr("OpenXR joints"), OPENXR),
        ):
            self.joints.addItem(text, value)
        self.joints.setCurrentIndex(max(self.joints.findData(self._outputs.settings.joints), 0))
        self.joints.activated.connect(
            lambda _i: self._outputs.set_joints(self.joints.currentData())
        )
        return self.joints

    def _move(self) -> None:
        host = self.address.text().strip()
        if host and host != self._outputs.settings.host:
            self._outputs.move(host)

    def _table(self) -> ConnectionTable:
        table = ConnectionTable(
            (
                self.tr("Stream"),
                self.tr("Port"),
                self.tr("State"),
                self.tr("Clients"),
                self.tr("Sent"),
                self.tr("Dropped"),
            )
        )
        outputs = self._outputs
        self.files: dict[str, RecordFile] = {}
        for name, kind in outputs.kinds.items():
            table.add(name, tr(kind.title), outputs.switch)
            if kind.has("port"):
                table.add_port(name, tr(kind.title), outputs.set_port)
            table.show_wanted(name, outputs.is_on(name), outputs.port(name))
            table.boxes[name].setToolTip(tr(kind.note))
            if kind.default_file:
                self.files[name] = RecordFile(outputs, name)
                table.put_at_port(name, self.files[name])
            table.put_buttons(name, self._row_buttons(name))
        self.table = table
        self.boxes, self.ports, self.cells = table.boxes, table.ports, table.cells
        return table

    def _row_buttons(self, name: str) -> QWidget:
        """*Test*, and *Options* where there are any beyond address, port and file."""
        title = tr(self._outputs.kinds[name].title)
        test = self.tests[name] = QPushButton(self.tr("Test"))
        test.setToolTip(self.tr("Whether a program receives {}").format(title))
        test.setAccessibleName(self.tr("Test {}").format(title))
        test.clicked.connect(partial(self._outputs.test, name))
        whole = QWidget()
        row = QHBoxLayout(whole)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(NEAR)
        row.addWidget(test)
        if option_fields(self._outputs.kinds[name]):
            options = self.options[name] = QPushButton("…")
            options.setFixedWidth(OPTIONS_WIDTH)  # all columns fit next to the camera images
            options.setToolTip(self.tr("Options of {}").format(title))
            options.setAccessibleName(self.tr("Options of {}").format(title))
            options.clicked.connect(partial(self._edit_options, name))
            row.addWidget(options)
        row.addStretch(1)
        return whole

    def _edit_options(self, name: str) -> None:
        kind = self._outputs.kinds[name]
        fields = option_fields(kind, self._outputs.settings.options(kind))
        dialog = OptionsDialog(tr(kind.title), fields, self)
        if dialog.exec() == QDialog.DialogCode.Accepted:
            for option, value in dialog.changed().items():
                self._outputs.set_option(name, option, value)

    def _show_test(self, _name: str, found: Any) -> None:
        look, text = tested(found)
        sign = f'<span style="color:{look.colour}">{look.sign}</span>'
        self.result.setText(f"{sign} {escape(text)}")
        self.result.show()

    def _result(self) -> QLabel:
        """For the last test."""
        self.result = QLabel()
        self.result.setWordWrap(True)
        self.result.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.result.hide()
        self._outputs.tested.connect(self._show_test)
        return self.result

    def _reach(self) -> QLabel:
        """Show which streams other computers can receive, since they do not use the address."""
        kinds = self._outputs.kinds.values()
        lines = [f"{tr(kind.title)}: {tr(kind.note)}." for kind in kinds if kind.note]
        self.reach = QLabel("\n".join(lines))
        self.reach.setProperty("role", "faint")
        self.reach.setWordWrap(True)
        return self.reach

    # --- haptics

    def _haptics(self) -> QGroupBox:
        group = QGroupBox(self.tr("Vibration motors: press one to test it"))
        tests = QHBoxLayout()
        self.motors = [QPushButton(tr(MOTOR_TITLES[finger])) for finger in MOTORS]
        for channel, button in enumerate(self.motors):
            button.setToolTip(self.tr("Motor {}").format(channel))
            button.setMinimumWidth(20)
            button.clicked.connect(partial(self._test, channel))
            tests.addWidget(button)
        tests.addStretch(1)
        self.amplitude = QSlider(Qt.Orientation.Horizontal)
        self.amplitude.setRange(0, MOST)
        self.amplitude.setValue(USUAL)
        self.amplitude.setAccessibleName(self.tr("Strength of the test"))
        strength = QHBoxLayout()
        strength.addWidget(QLabel(self.tr("Strength")))
        strength.addWidget(self.amplitude, 1)
        column = QVBoxLayout(group)
        column.addLayout(tests)
        column.addLayout(strength)
        column.addLayout(self._rule())
        self.contact = QLabel()
        self.contact.setProperty("role", "faint")
        self.contact.setWordWrap(True)
        column.addWidget(self.contact)
        return group

    def _rule(self) -> QGridLayout:
        self.rule = QCheckBox(self.tr("Vibrate when a fingertip enters a sphere of"))
        self.rule.setChecked(self._outputs.rule.on)
        self.rule.toggled.connect(self._set_rule)
        self.radius = QSpinBox()
        self.radius.setRange(5, 300)
        self.radius.setSuffix(self.tr(" mm"))
        self.radius.setAccessibleName(self.tr("Radius of the sphere"))
        self.radius.setValue(round(1000 * self._outputs.rule.radius))
        self.radius.setKeyboardTracking(False)
        self.radius.valueChanged.connect(self._set_rule)
        self.place = QPushButton(self.tr("Place it at the index fingertip"))
        self.place.clicked.connect(self._put)
        grid = QGridLayout()
        grid.addWidget(self.rule, 0, 0)
        grid.addWidget(self.radius, 0, 1)
        grid.addWidget(self.place, 1, 0, Qt.AlignmentFlag.AlignLeft)
        grid.setColumnStretch(2, 1)
        return grid

    def _test(self, channel: int) -> None:
        self._outputs.vibrate(channel, self.amplitude.value(), TEST_MS)

    def _set_rule(self) -> None:
        changed = replace(
            self._outputs.rule, on=self.rule.isChecked(), radius=self.radius.value() / 1000
        )
        self._outputs.set_rule(changed)
        self.rule.blockSignals(True)
        self.rule.setChecked(self._outputs.rule.on)
        self.rule.blockSignals(False)

    def _put(self) -> None:
        center = self._outputs.fingertip()
        if center:
            self._outputs.set_rule(replace(self._outputs.rule, center=center))
        else:
            self.host.error.emit(
                self.tr("The sphere was not placed: the index fingertip is not visible.")
            )

    # --- displayed data

    def _show(self) -> None:
        for name in self._outputs.kinds:
            row = stream_row(
                self._outputs.is_on(name),
                self.host.running,
                self._outputs.counts(name),
                self._outputs.problems.get(name, ""),
            )
            self._show_row(name, row)
            self.table.show_wanted(name, self._outputs.is_on(name), self._outputs.port(name))
        for button in (*self.motors, self.place):
            button.setEnabled(self._outputs.can_vibrate)
        self.contact.setText(self._contact_text())

    def _show_row(self, name: str, row: StreamRow) -> None:
        sign = f'<span style="color:{row.look.colour}">{row.look.sign}</span>'
        texts = f"{sign} {row.state}", row.clients, row.sent, row.dropped
        self.table.show_row(name, texts, row.tip)

    def _contact_text(self) -> str:
        rule = self._outputs.rule
        if not rule.center:
            return self.tr("The sphere has not been placed yet.")
        x, y, z = (1000 * v for v in rule.center)
        return self.tr("The sphere is at {:.0f}, {:.0f}, {:.0f} mm.").format(x, y, z)

    def refresh(self, view: Snapshot | None) -> None:
        self._show()
        self.remote.show_state()
