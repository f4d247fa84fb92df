"""Images stored for tuning colours: both cameras side by side as PNG files in a folder."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from app.storage.removed_file import RemovedFile, remove_file
from tracker.base.errors import FileError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice

Image = NDArray[np.uint8]
MOST = 24
"""Images stored per camera; adding one more deletes the oldest."""


@dataclass(frozen=True, eq=False)
class StoredImage:
    """Both images (h, w, 3) BGR of an instant; ``right`` is None for a single image."""

    name: str
    left: Image
    right: Image | None = None


def read_image(path: Path) -> StoredImage:
    """Read a PNG (or any image); if it is at least twice as wide as high, it is a side-by-side
    pair.

    Raises FileError.
    """
    image = cv2.imread(str(path), cv2.IMREAD_COLOR)
    if image is None:
        raise FileError(notice("window.image_not_readable", file=path.name))
    pixels = np.asarray(image, np.uint8)
    height, width = pixels.shape[:2]
    if width < 2 * height:
        return StoredImage(path.stem, pixels)
    half = width // 2
    left, right = pixels[:, :half], pixels[:, half : 2 * half]
    return StoredImage(path.stem, np.ascontiguousarray(left), np.ascontiguousarray(right))


def write_image(path: Path, shot: StoredImage) -> None:
    """Write the pair side by side, lossless. Raises FileError."""
    sides = [shot.left] if shot.right is None else [shot.left, shot.right]
    ok, data = cv2.imencode(".png", np.hstack(sides), [cv2.IMWRITE_PNG_COMPRESSION, 3])
    if not ok:
        raise FileError(notice("window.image_not_encoded", file=path.name))
    write_with_folder(path, data.tobytes())


class ImageFolder:
    """The stored images of one camera, by name; the newest last."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def names(self) -> list[str]:
        return sorted(p.stem for p in self.folder.glob("*.png"))

    def free_name(self, now: datetime) -> str:
        """An unused name from the date and time."""
        name = stem = now.strftime("%Y-%m-%d %H-%M-%S")
        number = 2
        while self.path(name).exists():
            name, number = f"{stem} ({number})", number + 1
        return name

    def path(self, name: str) -> Path:
        return self.folder / f"{name}.png"

    def load(self, name: str) -> StoredImage:
        return read_image(self.path(name))

    def store(self, shot: StoredImage) -> None:
        """Write an image; delete the oldest ones beyond `MOST`."""
        write_image(self.path(shot.name), shot)
        for old in self.names()[:-MOST]:
            self.remove(old)

    def remove(self, name: str) -> RemovedFile:
        """Raises FileError."""
        return remove_file(self.path(name))
