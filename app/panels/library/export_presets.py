"""Named sets of formats and options, kept in the settings."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QPushButton, QWidget

from app.storage.settings import SettingsStore
from app.viewmodels.export_choice import ExportChoice, choice_from
from app.widgets.question import question

LONGEST = 60  # characters of a name


class Presets(QWidget):
    """A box to choose from; ``read`` gives the choice in the fields, ``show`` fills them."""

    def __init__(
        self,
        store: SettingsStore,
        read: Callable[[], ExportChoice],
        show: Callable[[ExportChoice], None],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._store, self._read, self._show = store, read, show
        self.box = QComboBox()
        self.box.setAccessibleName(self.tr("Preset"))
        self.box.currentIndexChanged.connect(self._chosen)
        self.box.activated.connect(self._chosen)  # again, after the fields were changed
        self.save_button = QPushButton(self.tr("Keep as…"))
        self.save_button.clicked.connect(self._ask_name)
        self.remove_button = QPushButton(self.tr("Remove"))
        self.remove_button.clicked.connect(self._remove)
        self._gone: tuple[str, dict[str, object]] | None = None
        self.undo_button = QPushButton(self.tr("Undo"))
        self.undo_button.clicked.connect(self._put_back)
        self.undo_button.hide()
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(QLabel(self.tr("Preset")))
        row.addWidget(self.box, 1)
        row.addWidget(self.save_button)
        row.addWidget(self.remove_button)
        row.addWidget(self.undo_button)
        self._fill("")

    def _fill(self, chosen: str) -> None:
        with QSignalBlocker(self.box):
            self.box.clear()
            self.box.addItem(self.tr("none: as below"), "")
            for name in sorted(self._store.value.export_presets):
                self.box.addItem(name, name)
            self.box.setCurrentIndex(max(0, self.box.findData(chosen)))
        self.remove_button.setEnabled(bool(self.box.currentData()))

    def _chosen(self) -> None:
        name = self.box.currentData()
        self.remove_button.setEnabled(bool(name))
        if name:
            self._show(choice_from(self._store.value.export_presets.get(name)))

    def _ask_name(self) -> None:
        title, words = self.tr("Keep these formats and options"), self.tr("Name of the preset")
        dialog = question(self, title, words, self.box.currentData() or "")
        dialog.textValueSelected.connect(self.keep)
        dialog.open()

    def keep(self, name: str) -> None:
        """Keep what is chosen under this name, instead of what it stood for."""
        name = " ".join(name.split())[:LONGEST]
        if name:
            kept = {**self._store.value.export_presets, name: self._read().as_dict()}
            self._store.update(export_presets=kept)
            self._fill(name)

    def _remove(self) -> None:
        name = self.box.currentData()
        before = self._store.value.export_presets
        self._gone = name, before[name]
        self._store.update(export_presets={k: v for k, v in before.items() if k != name})
        self.undo_button.setToolTip(self.tr("Put back the preset {}").format(name))
        self.undo_button.show()
        self._fill("")

    def _put_back(self) -> None:
        """The preset that was removed last, unless another one was kept under its name."""
        if self._gone is not None:
            (name, preset), self._gone = self._gone, None
            self._store.update(export_presets={name: preset, **self._store.value.export_presets})
            self._fill(name)
        self.undo_button.hide()
