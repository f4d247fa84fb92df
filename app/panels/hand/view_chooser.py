"""Which 3D view draws: asks for the graphics card, tries it, remembers where it failed."""

from __future__ import annotations

import importlib
import importlib.util

from PySide6.QtCore import QObject, Signal

from app.platform.graphics import GraphicsQuery, is_card
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsStore
from app.widgets.view3d.view_3d import View3D

AUTO, CARD, PAINTED = "auto", "card", "painted"
PROVEN = 30
"""Images after which the graphics card's view is taken to work."""


def is_there() -> bool:
    """Whether what the graphics card's view is made of has been installed."""
    return all(importlib.util.find_spec(name) is not None for name in ("pyvistaqt", "vtkmodules"))


class ViewChooser(QObject):
    """Follows the setting ``view_3d``. A card whose driver ends the program is tried once only."""

    refused = Signal(str)

    def __init__(
        self, view: View3D, store: SettingsStore, tasks: TaskOwner, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._view, self._store, self._tasks = view, store, tasks
        self._query = GraphicsQuery(self)
        self._query.answered.connect(self._answered)
        self._started = False
        self._drawn = 0

    def start(self) -> None:
        """Choose, the first time that the view is in sight."""
        if self._started:
            return
        self._started = True
        if self._store.value.card_trial:  # the program ended before the card had proven itself
            self._store.update(card_trial=False, view_3d=PAINTED)
            self.refused.emit(
                self.tr(
                    "The 3D driver of the graphics card ended the program last time, so the hand "
                    "is painted without it. The View menu brings the card back."
                )
            )
        self._follow()

    def choose(self, setting: str) -> None:
        """What the user wants from now on."""
        self._store.update(view_3d=setting)
        self._started = True
        self._follow()

    def _follow(self) -> None:
        setting = self._store.value.view_3d
        if setting == CARD:
            self._prepare()
        elif setting == AUTO and is_there():
            self._query.start()
        elif self._view.on_card:
            self._view.use_painted()

    def _answered(self, renderer: str) -> None:
        if is_card(renderer):
            self._prepare()

    def _prepare(self) -> None:
        """Import what the card's view needs: two seconds, so beside the window."""
        if not is_there():
            self._stay_painted(
                self.tr(
                    "The 3D view of the graphics card is not part of this installation; "
                    "the hand is painted without it."
                )
            )
            return

        def load(_progress: JobProgress) -> bool:
            try:
                importlib.import_module("pyvistaqt")
            except ImportError:
                return False
            return True

        self._tasks.run(self.tr("Preparing the 3D view"), load, self._use)

    def _use(self, there: bool) -> None:
        if self._view.on_card or self._store.value.view_3d == PAINTED:
            return
        self._drawn = 0
        self._store.update(card_trial=True)
        if not there or not self._view.use_card():
            self._store.update(card_trial=False)
            self._stay_painted(self.tr("The 3D view cannot use the graphics card; it is painted."))

    def _stay_painted(self, reason: str) -> None:
        """Say why, to those who have asked for the card."""
        if self._store.value.view_3d == CARD:
            self.refused.emit(reason)

    def drawn(self) -> None:
        """An image has been drawn."""
        if self._store.value.card_trial:
            self._drawn += 1
            if self._drawn >= PROVEN or not self._view.on_card:
                self._store.update(card_trial=False)

    def shut_down(self) -> None:
        self._query.stop()
        if self._store.value.card_trial:
            self._store.update(card_trial=False)
