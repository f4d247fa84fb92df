"""What the window remembers between runs: one small JSON file, versioned, replaced atomically."""

from __future__ import annotations

import dataclasses
import json
import logging
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import platformdirs

VERSION = 1
_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Settings:
    """The user's choices; every field has a default that serves a first start."""

    version: int = VERSION
    theme: str = "system"  # "system", "light" or "dark"
    geometry: str = ""  # base64 of QWidget.saveGeometry
    layout: str = ""  # base64 of QMainWindow.saveState
    sessions_folder: str = ""
    participant: str = ""
    task: str = ""
    profile: str = ""  # path of the colour profile; empty: the shipped one
    engine: str = "chain"  # what tracks
    hand: str = "reference-right"
    glove: str = "vist-small"
    port: str = ""
    camera: str = ""  # index, file or address of a side-by-side picture; empty: the first one
    calibration: str = ""  # path of the stereo calibration


class SettingsStore:
    """Reads and writes `Settings`. A damaged or newer file is set aside, never overwritten."""

    def __init__(self, path: Path | None = None) -> None:
        folder = Path(platformdirs.user_config_dir("glovetrack", appauthor=False))
        self.path = path or folder / "window.json"
        self.value = self._read()

    def update(self, **changes: Any) -> None:
        """Change some fields and write the file."""
        self.value = dataclasses.replace(self.value, **changes)
        self.path.parent.mkdir(parents=True, exist_ok=True)
        temporary = self.path.with_suffix(".tmp")
        temporary.write_text(json.dumps(dataclasses.asdict(self.value), indent=2), "utf-8")
        temporary.replace(self.path)

    def _read(self) -> Settings:
        if not self.path.exists():
            return Settings()
        try:
            return _settings_from(json.loads(self.path.read_text("utf-8")))
        except (OSError, ValueError) as error:
            aside = self.path.with_suffix(".unreadable.json")
            _log.warning("The window's settings could not be read (%s); kept as %s.", error, aside)
            self.path.replace(aside)
            return Settings()


def _settings_from(data: Any) -> Settings:
    """Settings from JSON. Unknown keys are dropped; wrong types and versions are ValueErrors."""
    if not isinstance(data, dict) or data.get("version") != VERSION:
        raise ValueError("another version of Glovetrack wrote them")
    default = Settings()
    known = {f.name for f in dataclasses.fields(Settings)}
    values = {k: v for k, v in data.items() if k in known}
    for key, value in values.items():
        if type(value) is not type(getattr(default, key)):
            raise ValueError(f"{key} has a wrong type")
    return dataclasses.replace(default, **values)


def sessions_folder(settings: Settings) -> Path:
    """Where recordings go: the user's choice, else the documents folder."""
    if settings.sessions_folder:
        return Path(settings.sessions_folder)
    return Path(platformdirs.user_documents_dir()) / "Glovetrack"
