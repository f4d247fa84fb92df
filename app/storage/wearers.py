"""Profiles of the people who wear the glove, in the user's settings folder."""

from __future__ import annotations

from pathlib import Path

from app.storage.removed_file import RemovedFile, remove_file
from tracker.base.errors import FileError
from tracker.base.files import person_file_name
from tracker.base.toml_reader import read_text
from tracker.fusion.chain.calibration.profile_file import (
    WearerFile,
    is_for,
    read_wearer,
    wearer_text,
    write_wearer,
)
from tracker.fusion.chain.layout import ChainLayout

SUFFIX = ".toml"


def _is_same(path: Path, wearer: WearerFile) -> bool:
    """Whether the file contains exactly this profile."""
    try:
        return read_text(path) == wearer_text(wearer)
    except FileError:
        return False


class WearerStore:
    """One file per wearer in ``folder``, with the name it was saved under."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def names(self, layout: ChainLayout | None = None) -> list[str]:
        """All profiles, or those for the hand and glove of ``layout``."""
        paths = self.folder.glob(f"*{SUFFIX}")
        return sorted(p.stem for p in paths if layout is None or is_for(p, layout))

    def path(self, name: str) -> Path:
        return self.folder / f"{person_file_name(name)}{SUFFIX}"

    def load(self, name: str, layout: ChainLayout) -> WearerFile:
        """Raises FileError if there is none, or if it is for another glove."""
        return read_wearer(self.path(name), layout)

    def save(self, name: str, wearer: WearerFile) -> str:
        """Write the file and return its name: ``name``, or with the glove's name appended if a
        profile of that name is for another hand or glove. Raises FileError."""
        if self.path(name).exists() and not is_for(self.path(name), wearer.layout):
            name = f"{name} {wearer.layout.glove.name}"
        write_wearer(self.path(name), wearer)
        return person_file_name(name)

    def take_in(self, path: Path, layout: ChainLayout) -> str:
        """Import a file under its own name, with a number if another profile has that name; returns
        the name. Raises FileError."""
        wearer = read_wearer(path, layout)
        stem = person_file_name(path.stem)[:50].strip(" ._") or person_file_name("")
        name, n = stem, 1
        while self.path(name).exists():
            if _is_same(self.path(name), wearer):
                return name
            n += 1
            name = f"{stem}_{n}"
        return self.save(name, wearer)

    def remove(self, name: str) -> RemovedFile:
        """Raises FileError if it does not exist or cannot be removed."""
        return remove_file(self.path(name))
