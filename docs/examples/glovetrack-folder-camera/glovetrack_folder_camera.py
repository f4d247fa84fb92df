"""A camera plug-in for Glovetrack: stereo pairs from NumPy files, one after the other.

It stands for a camera with a driver package of its own. Where this one reads a file, a real one
would start the driver's pipeline in ``open`` and wait for its next two images in ``read``.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from glovetrack.cameras import CaptureFormat, DeviceError, Pair

FOLDERS = "GLOVETRACK_FOLDER_CAMERAS"
"""Environment variable: folders that play a camera, parted as in PATH."""


class FolderDriver:
    """What the entry point names."""

    def cameras(self) -> Sequence[tuple[str, str]]:
        """A camera per folder: its path is its id."""
        listed = filter(None, os.environ.get(FOLDERS, "").split(os.pathsep))
        return [(folder, f"Folder {Path(folder).name}") for folder in listed]

    def open(self, camera: str, want: CaptureFormat) -> FolderCamera:
        """An image input that is not open yet."""
        return FolderCamera(Path(camera), want)


class FolderCamera:
    """Files ``*.npy`` of shape (2, height, width, 3), uint8, BGR: left and right."""

    live = False  # a real camera is live: it sends images in real time

    def __init__(self, folder: Path, want: CaptureFormat) -> None:
        self.name, self.fps = f"folder {folder.name}", want.fps or 30.0
        self._folder, self._files = folder, iter(())

    def open(self) -> None:
        files = sorted(self._folder.glob("*.npy"))
        if not files:
            raise DeviceError(f"There are no images in {self._folder}.")
        self._files = iter(files)

    def read(self) -> Pair | None:
        """Returns the next pair; None after a disconnection."""
        file: Any = next(self._files, None)
        if file is None:
            return None
        left, right = np.load(file)
        return left, right

    def close(self) -> None:
        self._files = iter(())
