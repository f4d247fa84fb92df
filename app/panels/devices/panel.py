"""The Device settings panel: all values of gloves and cameras; some can be changed."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from PySide6.QtWidgets import (
    QFileDialog,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import CurrentEngine, EngineChanges
from app.engines.snapshot import Snapshot
from app.jobs.device_changes import apply_changes, read_settings, save_settings
from app.jobs.motor_test import MotorTest
from app.panels.devices.tree import DeviceTree
from app.panels.panel import Panel
from app.storage.settings import SettingsStore
from app.viewmodels.device_settings import (
    DeviceValue,
    Value,
    device_values,
    differences,
    is_allowed,
    motor_of,
    report_of,
    to_file,
)
from app.widgets.measures import NEAR, TIGHT
from app.widgets.one_line import OneLine
from app.words import error_text
from tracker.base.errors import GlovetrackError

REPORT_HEIGHT = 90  # px


class DevicesHost(CurrentEngine, EngineChanges, Protocol):
    """What the panel uses of the engine host."""


class DevicesPanel(Panel):
    """Shows values that the engine already has; no device is queried."""

    period = 0.5

    def __init__(
        self, host: DevicesHost, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._store = store
        self.motors = MotorTest(host, store, self)
        self.values: dict[str, DeviceValue] = {}
        self.edits: dict[str, Value] = {}  # changes that have not been applied
        self._asked: dict[str, Value] = {}  # changes that have been applied
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search settings"))
        self.search.setAccessibleName(self.tr("Search settings"))
        self.search.setClearButtonEnabled(True)
        self.tree = DeviceTree()
        self.report = QPlainTextEdit()
        self.report.setReadOnly(True)
        self.report.setMaximumHeight(REPORT_HEIGHT)
        self.report.hide()
        self.apply = QPushButton(self.tr("Apply"))
        self.revert = QPushButton(self.tr("Revert"))
        self.save = QPushButton(self.tr("Save as file…"))
        self.load = QPushButton(self.tr("Load…"))
        head = OneLine()
        for button in (self.apply, self.revert, self.save, self.load):
            head.add(button)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(TIGHT)
        for widget in (self.search, self.tree, self.report, head):
            column.addWidget(widget)
        self._connect()
        self._enable()

    def _connect(self) -> None:
        self.search.textChanged.connect(self.tree.search)
        self.tree.edited.connect(self.edit)
        self.tree.motor.connect(self._run_motor)
        self.motors.measured.connect(self._show_report)
        self.apply.clicked.connect(self.apply_edits)
        self.revert.clicked.connect(self.revert_edits)
        self.save.clicked.connect(self._ask_save)
        self.load.clicked.connect(self._ask_load)
        self.host.opened.connect(lambda _setup: self._forget())
        self.host.closed.connect(self._forget)

    def _forget(self) -> None:
        self.edits, self._asked, self.values = {}, {}, {}
        self.tree.show_values([], {})
        self._show_report("")
        self._enable()

    def _show_report(self, text: str) -> None:
        self.report.setPlainText(text)
        self.report.setVisible(bool(text))

    def _enable(self) -> None:
        for button in (self.apply, self.revert):
            button.setEnabled(bool(self.edits))
        for button in (self.save, self.load):
            button.setEnabled(bool(self.values))

    def refresh(self, view: Snapshot | None) -> None:
        if view is None:
            return
        known = len(self.values)
        self.values = {value.key: value for value in device_values(view, self._asked)}
        self.tree.show_values(list(self.values.values()), self.edits)
        if len(self.values) != known:
            self.tree.search(self.search.text())
        self._enable()

    # --- changing

    def edit(self, key: str, wanted: Value) -> None:
        """Store a change until it is applied; values that the device does not support are
        rejected."""
        value = self.values.get(key)
        if value is None:
            return
        if not is_allowed(value, wanted):
            text = self.tr("{}: the value {} is not possible ({}).")
            self._show_report(text.format(value.path[-1], wanted, value.detail or value.text))
            self.edits.pop(key, None)
        elif wanted == value.value:
            self.edits.pop(key, None)
        else:
            self.edits[key] = wanted
            self._show_report("")
        self._show_edits()

    def apply_edits(self) -> None:
        """Send the changes to the devices and store them for the next start."""
        setup = self.host.setup
        if setup is None:
            return
        try:
            apply_changes(setup, self._store, list(self.values.values()), self.edits)
        except GlovetrackError as error:
            self._show_report(error_text(error))
            return
        self._asked |= self.edits
        self.edits = {}
        self._show_edits()

    def revert_edits(self) -> None:
        """Discard changes that have not been applied."""
        self.edits = {}
        self._show_report("")
        self._show_edits()

    def _show_edits(self) -> None:
        self.tree.show_values(list(self.values.values()), self.edits)
        self._enable()

    def _run_motor(self, key: str) -> None:
        side, channel = motor_of(key)
        if not self.motors.run(side, channel):
            self._show_report(self.tr("The motor was not run: the glove is disconnected."))

    # --- files

    def _ask_save(self) -> None:
        words, kinds = self.tr("Save the device settings"), self.tr("TOML (*.toml)")
        name, _ = QFileDialog.getSaveFileName(self, words, "devices.toml", kinds)
        if name:
            self.save_as(Path(name))

    def save_as(self, path: Path) -> None:
        """Write all known values as TOML."""
        try:
            save_settings(to_file(list(self.values.values())), path)
        except GlovetrackError as error:
            self._show_report(error_text(error))

    def _ask_load(self) -> None:
        words, kinds = self.tr("Load device settings"), self.tr("TOML (*.toml)")
        name, _ = QFileDialog.getOpenFileName(self, words, "", kinds)
        if name:
            self.load_from(Path(name))

    def load_from(self, path: Path) -> None:
        """Report the differences; those that can be applied become changes."""
        try:
            found = differences(read_settings(path), path.name, list(self.values.values()))
        except GlovetrackError as error:
            self._show_report(error_text(error))
            return
        self.edits = {d.key: d.stored for d in found if d.can_apply}
        self._show_report(report_of(found, path.name))
        self._show_edits()
