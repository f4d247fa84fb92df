"""Colour profiles per camera in the user's settings folder: tuned once, there at every start."""

from __future__ import annotations

import logging
from pathlib import Path

from tracker.base.errors import GlovetrackError
from tracker.base.files import slug, write_kept
from tracker.vision.colours import ColourProfile, load_profile, profile_to_toml

_log = logging.getLogger(__name__)


class ColourStore:
    """One TOML file per camera in ``folder``, named by the camera."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def path(self, camera: str) -> Path:
        return self.folder / f"{slug(camera)}.toml"

    def cameras(self) -> list[str]:
        """Names of the files that are there, without their suffix."""
        return sorted(p.stem for p in self.folder.glob("*.toml"))

    def load(self, camera: str, like: ColourProfile) -> ColourProfile | None:
        """The camera's profile if there is one with the hues of ``like``, in their order.

        One that cannot be read is said in the log and left where it is.
        """
        path = self.path(camera)
        if not path.is_file():
            return None
        try:
            profile = load_profile(path)
        except GlovetrackError as error:
            _log.warning("The colours of %s were not taken: %s", camera, error)
            return None
        return profile if profile.hue_names == like.hue_names else None

    def save(self, camera: str, profile: ColourProfile) -> None:
        """Raises FileError where the disk refuses."""
        write_kept(self.path(camera), profile_to_toml(profile))
