"""Colour profiles in the user's settings folder, one for each camera, saved after each change."""

from __future__ import annotations

import logging
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from app.words import error_text
from tracker.base.errors import GlovetrackError
from tracker.base.files import slug, write_with_folder
from tracker.vision.colours import ColourProfile, load_profile, profile_to_toml

_log = logging.getLogger(__name__)


DELAY_MS = 400
"""A moving slider causes only one write."""


class ColourStore:
    """One TOML file per camera in ``folder``, named by the camera."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def path(self, camera: str) -> Path:
        return self.folder / f"{slug(camera)}.toml"

    def cameras(self) -> list[str]:
        """Names of the existing files, without suffix."""
        return sorted(p.stem for p in self.folder.glob("*.toml"))

    def load(self, camera: str, like: ColourProfile) -> ColourProfile | None:
        """The camera's profile if it has the hues of ``like``, in the same order.

        A file that cannot be read is logged and not changed.
        """
        path = self.path(camera)
        if not path.is_file():
            return None
        try:
            profile = load_profile(path)
        except GlovetrackError as error:
            _log.warning("The colours of %s were not loaded: %s", camera, error)
            return None
        return profile if profile.hue_names == like.hue_names else None

    def save(self, camera: str, profile: ColourProfile) -> None:
        """Raises FileError if it cannot be written."""
        write_with_folder(self.path(camera), profile_to_toml(profile))


class ColourAutosave(QObject):
    """Stores the colours of one camera at a time; without a camera (a replay) nothing is stored."""

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
        """Switch to another camera; its stored profile if it matches ``like``."""
        self.write()
        self.camera = slug(camera) if camera else ""
        return self.store.load(camera, like) if camera else None

    def others(self) -> list[str]:
        """Cameras whose colours can be copied."""
        return [c for c in self.store.cameras() if c != self.camera]

    def changed(self, profile: ColourProfile) -> None:
        if self.camera:
            self._waiting = profile
            self._timer.start(DELAY_MS)

    def write(self) -> None:
        """Write a pending profile."""
        self._timer.stop()
        profile, self._waiting = self._waiting, None
        if profile is None:
            return
        try:
            self.store.save(self.camera, profile)
        except GlovetrackError as error:
            self.failed.emit(error_text(error))
