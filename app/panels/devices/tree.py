"""The tree of devices and their values, with fields for those that can be changed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QComboBox,
    QHeaderView,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from app.viewmodels.device_settings import AUTOMATIC, DeviceValue, Value, is_motor, value_text
from app.words import tr

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
