"""The tree of all signals, which can be searched, ticked and dragged into graphs."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from PySide6.QtCore import QMimeData, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QLineEdit, QTreeWidget, QTreeWidgetItem, QVBoxLayout, QWidget

from app.viewmodels.signals import Signal as Figure
from app.viewmodels.signals import matches
from app.widgets.measures import TIGHT

MIME = "application/x-glovetrack-signals"
KEY = int(Qt.ItemDataRole.UserRole)
MOST_EXPANDED = 60  # maximum number of matches that a search expands


def keys_in(data: QMimeData) -> list[str]:
    """Keys of the dragged signals; empty if something else is dragged."""
    if not data.hasFormat(MIME):
        return []
    return bytes(data.data(MIME).data()).decode().split("\n")


class DraggedTree(QTreeWidget):
    """A tree whose items can be dragged."""

    def __init__(self) -> None:
        super().__init__()
        self.setHeaderHidden(True)
        self.setUniformRowHeights(True)
        self.setDragEnabled(True)
        self.setDragDropMode(QTreeWidget.DragDropMode.DragOnly)
        self.setSelectionMode(QTreeWidget.SelectionMode.ExtendedSelection)

    def mimeData(self, items: Sequence[QTreeWidgetItem]) -> QMimeData:
        """The signals of the dragged leaves, and the visible signals of dragged branches."""
        data = QMimeData()
        keys = dict.fromkeys(key for item in items for key in leaf_keys(item))
        data.setData(MIME, "\n".join(keys).encode())
        return data


def leaf_keys(item: QTreeWidgetItem) -> list[str]:
    """Keys of an item and of all visible items below it."""
    if item.isHidden():
        return []
    own = item.data(0, KEY)
    return [own] if own else [key for child in children(item) for key in leaf_keys(child)]


def children(item: QTreeWidgetItem) -> list[QTreeWidgetItem]:
    """Child items, in order."""
    found = (item.child(i) for i in range(item.childCount()))
    return [child for child in found if child is not None]


class SignalTree(QWidget):
    """``toggled``: the key of a signal and whether it is ticked."""

    toggled = Signal(str, bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search signals"))
        self.search.setAccessibleName(self.tr("Search signals"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._find)
        self.tree = DraggedTree()
        self.tree.setAccessibleName(self.tr("Signals"))
        self.tree.itemChanged.connect(self._changed)
        self.tree.itemActivated.connect(self._activated)
        self._leaves: dict[str, tuple[Figure, QTreeWidgetItem]] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(TIGHT)
        column.addWidget(self.search)
        column.addWidget(self.tree, 1)

    def show_signals(self, signals: Iterable[Figure]) -> None:
        """Show all signals; expanded branches remain expanded."""
        expanded = self._expanded()
        with QSignalBlocker(self.tree):
            self.tree.clear()
            self._leaves.clear()
            branches: dict[tuple[str, ...], QTreeWidgetItem] = {}
            for signal in signals:
                leaf = QTreeWidgetItem([signal.path[-1]])
                leaf.setData(0, KEY, signal.key)
                leaf.setToolTip(
                    0, f"{signal.label} ({signal.unit})" if signal.unit else signal.label
                )
                leaf.setCheckState(0, Qt.CheckState.Unchecked)
                self._branch(branches, signal.path[:-1]).addChild(leaf)
                self._leaves[signal.key] = signal, leaf
            for path, item in branches.items():
                item.setExpanded(path in expanded if expanded else len(path) == 1)
        self._find(self.search.text())

    def _branch(
        self, branches: dict[tuple[str, ...], QTreeWidgetItem], path: tuple[str, ...]
    ) -> QTreeWidgetItem:
        if not path:
            return self.tree.invisibleRootItem()
        if path not in branches:
            branches[path] = QTreeWidgetItem([path[-1]])
            self._branch(branches, path[:-1]).addChild(branches[path])
        return branches[path]

    def _expanded(self) -> set[tuple[str, ...]]:
        found: set[tuple[str, ...]] = set()

        def look(item: QTreeWidgetItem, path: tuple[str, ...]) -> None:
            for child in children(item):
                here = (*path, child.text(0))
                if child.isExpanded():
                    found.add(here)
                look(child, here)

        look(self.tree.invisibleRootItem(), ())
        return found

    def tick(self, keys: Collection[str]) -> None:
        """Tick the signals of the selected graph."""
        with QSignalBlocker(self.tree):
            for key, (_, leaf) in self._leaves.items():
                wanted = Qt.CheckState.Checked if key in keys else Qt.CheckState.Unchecked
                if leaf.checkState(0) != wanted:
                    leaf.setCheckState(0, wanted)

    def _changed(self, item: QTreeWidgetItem) -> None:
        key = item.data(0, KEY)
        if key:
            self.toggled.emit(key, item.checkState(0) == Qt.CheckState.Checked)

    def _activated(self, item: QTreeWidgetItem) -> None:
        """Toggle a signal by double-click or Enter."""
        if item.data(0, KEY):
            on = item.checkState(0) == Qt.CheckState.Checked
            item.setCheckState(0, Qt.CheckState.Unchecked if on else Qt.CheckState.Checked)

    def _find(self, text: str) -> None:
        """Hide all signals that do not contain every word."""
        words = text.casefold().split()
        found = 0
        for signal, leaf in self._leaves.values():
            is_match = matches(signal, words)
            found += is_match
            leaf.setHidden(not is_match)
        self._hide_empty(self.tree.invisibleRootItem(), bool(words) and found <= MOST_EXPANDED)

    def _hide_empty(self, item: QTreeWidgetItem, expand: bool) -> bool:
        """Hide branches without visible signals; whether any signal is visible."""
        if item.childCount() == 0:
            return not item.isHidden()
        seen = [self._hide_empty(child, expand) for child in children(item)]
        if item is not self.tree.invisibleRootItem():
            item.setHidden(not any(seen))
            if expand:
                item.setExpanded(True)
        return any(seen)
