"""Layouts of graphs, stored under a name."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QInputDialog, QMenu, QToolButton, QWidget

from app.storage.settings import SettingsStore
from app.viewmodels.graphs import Graph, from_setting, to_setting
from app.widgets.question import answer


class GraphLayouts(QObject):
    """A menu on ``button``. ``chosen``: the graphs (list of `Graph`) to show."""

    chosen = Signal(list)

    def __init__(self, panel: QWidget, button: QToolButton, store: SettingsStore) -> None:
        super().__init__(panel)
        self._panel, self._store = panel, store
        self.menu = QMenu(button)
        self.menu.aboutToShow.connect(self._list)
        button.setMenu(self.menu)

    @property
    def names(self) -> list[str]:
        """Names of the stored layouts."""
        return [name for name in self._stored if self._stored[name]]

    @property
    def _stored(self) -> dict[str, object]:
        stored = self._store.value.graphs.get("named")
        return stored if isinstance(stored, dict) else {}

    def _list(self) -> None:
        self.menu.clear()
        for name in self.names:
            self.menu.addAction(name, partial(self.show_layout, name))
        self.menu.addSeparator()
        self.menu.addAction(self.tr("Save these graphs…"), self._ask_name)
        delete = self.menu.addAction(self.tr("Delete a layout…"), self._ask_delete)
        delete.setEnabled(bool(self.names))

    def show_layout(self, name: str) -> None:
        """Show the graphs of that name."""
        graphs = from_setting(self._stored.get(name))
        self._store.update(graphs={**self._store.value.graphs, "shown": to_setting(graphs)})
        self.chosen.emit(graphs)

    def save(self, name: str, graphs: list[Graph]) -> None:
        """Store graphs under a name, replacing those stored before."""
        named = {**self._stored, name: to_setting(graphs)}
        self._store.update(graphs={**self._store.value.graphs, "named": named})

    def delete(self, name: str) -> None:
        """Delete a layout."""
        named = {n: value for n, value in self._stored.items() if n != name}
        self._store.update(graphs={**self._store.value.graphs, "named": named})

    def _ask_name(self) -> None:
        name = answer(self._panel, self.tr("Save these graphs"), self.tr("Name of the layout"))
        if name:
            self.save(name, from_setting(self._store.value.graphs.get("shown")))

    def _ask_delete(self) -> None:
        title, words = self.tr("Delete a layout"), self.tr("Layout")
        name, ok = QInputDialog.getItem(self._panel, title, words, self.names, editable=False)
        if ok:
            self.delete(name)
