"""Writes the colours of a camera to disk a moment after each change."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal

from app.storage.colour_store import ColourStore
from tracker.base.errors import GlovetrackError
from tracker.base.files import slug
from tracker.vision.colours import ColourProfile

DELAY_MS = 400
"""A slider that is being moved writes once."""


class ColourAutosave(QObject):
    """The store of one camera at a time; without a camera (a replay) nothing is kept."""

    failed = Signal(str)

    def __init__(self, store: ColourStore, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.store = store
        self.camera = ""
        self._waiting: ColourProfile | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.write)

    def open(self, camera: str, like: ColourProfile) -> ColourProfile | None:
        """Turn to another camera; its profile if one is kept that fits ``like``."""
        self.write()
        self.camera = slug(camera) if camera else ""
        return self.store.load(camera, like) if camera else None

    def others(self) -> list[str]:
        """Cameras whose colours could be taken over."""
        return [c for c in self.store.cameras() if c != self.camera]

    def changed(self, profile: ColourProfile) -> None:
        if self.camera:
            self._waiting = profile
            self._timer.start(DELAY_MS)

    def write(self) -> None:
        """Write what waits."""
        self._timer.stop()
        profile, self._waiting = self._waiting, None
        if profile is None:
            return
        try:
            self.store.save(self.camera, profile)
        except GlovetrackError as error:
            self.failed.emit(str(error))
