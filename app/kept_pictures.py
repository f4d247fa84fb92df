"""Pictures kept for tuning colours: both cameras side by side as PNG files in a folder."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.errors import FileError

Picture = NDArray[np.uint8]
MOST = 24
"""Pictures kept for a camera; the oldest goes when one more comes."""


@dataclass(frozen=True, eq=False)
class KeptPicture:
    """Both pictures (h, w, 3) BGR of an instant; ``right`` is None for a single picture."""

    name: str
    left: Picture
    right: Picture | None = None


def read_picture(path: Path) -> KeptPicture:
    """A PNG (or any picture); twice as wide as high or more, it is a side-by-side pair.

    Raises FileError in words.
    """
    image = cv2.imread(str(path), cv2.IMREAD_COLOR)
    if image is None:
        raise FileError(f"{path.name} is no picture that can be read.")
    pixels = np.asarray(image, np.uint8)
    height, width = pixels.shape[:2]
    if width < 2 * height:
        return KeptPicture(path.stem, pixels)
    half = width // 2
    left, right = pixels[:, :half], pixels[:, half : 2 * half]
    return KeptPicture(path.stem, np.ascontiguousarray(left), np.ascontiguousarray(right))


def write_picture(path: Path, shot: KeptPicture) -> None:
    """The pair side by side, lossless. Raises FileError in words."""
    sides = [shot.left] if shot.right is None else [shot.left, shot.right]
    ok, data = cv2.imencode(".png", np.hstack(sides), [cv2.IMWRITE_PNG_COMPRESSION, 3])
    if not ok:
        raise FileError(f"{path.name}: the picture could not be packed.")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data.tobytes())
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(f"The picture was not saved to {path}: {reason}.") from error


class PictureFolder:
    """The kept pictures of one camera, by name; the newest last."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def names(self) -> list[str]:
        return sorted(p.stem for p in self.folder.glob("*.png"))

    def free_name(self, now: datetime) -> str:
        """A name of the time of day that no kept picture has."""
        name = stem = now.strftime("%Y-%m-%d %H-%M-%S")
        number = 2
        while self.path(name).exists():
            name, number = f"{stem} ({number})", number + 1
        return name

    def path(self, name: str) -> Path:
        return self.folder / f"{name}.png"

    def load(self, name: str) -> KeptPicture:
        return read_picture(self.path(name))

    def keep(self, shot: KeptPicture) -> None:
        """Write a picture; beyond `MOST` the oldest ones go."""
        write_picture(self.path(shot.name), shot)
        for old in self.names()[:-MOST]:
            self.remove(old)

    def remove(self, name: str) -> None:
        self.path(name).unlink(missing_ok=True)
