"""The Device settings panel: all values of gloves and cameras; some can be changed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Protocol

from PySide6.QtCore import Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QHeaderView,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import CurrentEngine, EngineChanges
from app.engines.snapshot import Snapshot
from app.jobs.motor_test import MotorTest, apply_changes, read_settings, save_settings
from app.jobs.own_gloves import OwnGloveSettings
from app.panels.panel import Panel
from app.storage.settings import SettingsOf
from app.viewmodels.device_settings import (
    AUTOMATIC,
    DeviceValue,
    Value,
    device_values,
    differences,
    is_allowed,
    is_motor,
    motor_of,
    report_of,
    to_file,
    value_text,
)
from app.widgets.measures import NEAR, TIGHT
from app.widgets.one_line import OneLine
from app.words import error_text, tr
from tracker.base.errors import GlovetrackError

REPORT_HEIGHT = 90  # px


class DevicesHost(CurrentEngine, EngineChanges, Protocol):
    """What the panel uses of the engine host."""


class DevicesPanel(Panel):
    """Shows values that the engine already has; no device is queried."""

    period = 0.5

    def __init__(
        self, host: DevicesHost, store: SettingsOf[OwnGloveSettings], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._store = store
        self.motors = MotorTest(host, store, self)
        self.values: dict[str, DeviceValue] = {}
        self.edits: dict[str, Value] = {}  # changes that have not been applied
        self._requested: dict[str, Value] = {}  # changes that have been applied
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
        self.edits, self._requested, self.values = {}, {}, {}
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
        self.values = {value.key: value for value in device_values(view, self._requested)}
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
        self._requested |= self.edits
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


# ---- the tree of devices and their values, with fields for those that can be changed

NAME, VALUE, STATE = range(3)


class DeviceTree(QTreeWidget):
    """``edited``: key and new value of a setting; ``motor``: key of a motor to run."""

    edited = Signal(str, object)
    motor = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setHeaderLabels([self.tr("Setting"), self.tr("Current value"), self.tr("State")])
        self.setAccessibleName(self.tr("Device settings"))
        self.setUniformRowHeights(False)
        self.setSelectionMode(QTreeWidget.SelectionMode.NoSelection)
        self.header().setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        for column, width in ((NAME, 190), (VALUE, 190)):
            self.setColumnWidth(column, width)
        self.items: dict[str, QTreeWidgetItem] = {}
        self.fields: dict[str, QComboBox] = {}
        self._made_of: list[tuple[str, object]] = []

    def show_values(self, values: Sequence[DeviceValue], edits: Mapping[str, Value]) -> None:
        """Update the texts; rebuild the tree only if the set of values has changed."""
        made_of: list[tuple[str, object]] = [
            (v.key, (v.changeable, v.choices, v.path)) for v in values
        ]
        if made_of != self._made_of:
            self._made_of = made_of
            self._make(values)
        for value in values:
            self._show(value, edits)

    def _make(self, values: Sequence[DeviceValue]) -> None:
        self.clear()
        self.items, self.fields = {}, {}
        branches: dict[tuple[str, ...], QTreeWidgetItem] = {}
        for value in values:
            item = QTreeWidgetItem([value.path[-1]])
            self._branch(branches, value.path[:-1]).addChild(item)
            self.items[value.key] = item
            if value.changeable:
                self.setItemWidget(item, VALUE, self._field(value))
            elif is_motor(value):
                button = QPushButton(self.tr("Run"))
                button.setToolTip(self.tr("Run this motor for 0.8 s and measure its vibration"))
                button.clicked.connect(lambda _on=False, key=value.key: self.motor.emit(key))
                self.setItemWidget(item, VALUE, button)
        for path, branch in branches.items():
            branch.setExpanded(len(path) < 3)  # there are many IMUs

    def _branch(
        self, branches: dict[tuple[str, ...], QTreeWidgetItem], path: tuple[str, ...]
    ) -> QTreeWidgetItem:
        if not path:
            return self.invisibleRootItem()
        if path not in branches:
            branches[path] = QTreeWidgetItem([path[-1]])
            self._branch(branches, path[:-1]).addChild(branches[path])
        return branches[path]

    def _field(self, value: DeviceValue) -> QComboBox:
        """A list of choices; for a control with a range, any number can be entered, too."""
        field = QComboBox()
        field.setAccessibleName(value.path[-1])
        for choice in value.choices:
            field.addItem(value_text(choice, value.unit), choice)
        if value.choices == (AUTOMATIC,):
            field.setEditable(True)
            _line(field).editingFinished.connect(lambda: self._typed(value.key, field))
        field.activated.connect(lambda _i: self._chosen(value.key, field))
        self.fields[value.key] = field
        return field

    def _chosen(self, key: str, field: QComboBox) -> None:
        self.edited.emit(key, field.currentData())

    def _typed(self, key: str, field: QComboBox) -> None:
        if not _line(field).isModified():
            return
        _line(field).setModified(False)
        text = field.currentText().strip().replace(",", ".")
        try:
            wanted: Value = float(text)
        except ValueError:
            wanted = AUTOMATIC if text == tr("automatic") else text
        self.edited.emit(key, wanted)

    def _show(self, value: DeviceValue, edits: Mapping[str, Value]) -> None:
        item, is_edited = self.items[value.key], value.key in edits
        shown = edits.get(value.key, value.value)
        state = self.tr("changed, not applied") if is_edited else tr(value.confirmed.value)
        if value.detail:
            state = f"{state} ({value.detail})"
        field = self.fields.get(value.key)
        if field is not None and not field.hasFocus():
            _put(field, shown, value.unit)
        elif field is None and not is_motor(value):
            _text(item, VALUE, value.text)
            faint = self.palette().brush(QPalette.ColorGroup.Disabled, QPalette.ColorRole.Text)
            item.setForeground(VALUE, faint)
        font = item.font(NAME)
        if font.bold() != is_edited:
            font.setBold(is_edited)
            item.setFont(NAME, font)
        _text(item, STATE, state)

    def search(self, text: str) -> None:
        """Hide all values that do not contain every word."""
        words = text.casefold().split()
        for item in self.items.values():
            item.setHidden(not all(word in _path_of(item).casefold() for word in words))
        _hide_empty(self.invisibleRootItem(), bool(words))


def _line(field: QComboBox) -> QLineEdit:
    """The line edit of a field."""
    line = field.lineEdit()
    assert line is not None  # the field is editable
    return line


def _put(field: QComboBox, value: Value, unit: str) -> None:
    index = field.findData(value)
    if index >= 0:
        field.setCurrentIndex(index)
        if not field.isEditable():
            return
    text = value_text(value, unit)
    if field.isEditable() and field.currentText() != text:
        field.setEditText(text)
        _line(field).setModified(False)


def _text(item: QTreeWidgetItem, column: int, text: str) -> None:
    if item.text(column) != text:
        item.setText(column, text)


def _path_of(item: QTreeWidgetItem) -> str:
    parent = item.parent()
    return f"{_path_of(parent)} {item.text(NAME)}" if parent is not None else item.text(NAME)


def _hide_empty(item: QTreeWidgetItem, expand: bool) -> bool:
    """Hide branches without visible values; whether any value is visible."""
    if item.childCount() == 0:
        return not item.isHidden()
    below = (item.child(i) for i in range(item.childCount()))
    seen = [_hide_empty(child, expand) for child in below if child is not None]
    item.setHidden(not any(seen))
    if expand:
        item.setExpanded(True)
    return any(seen)
