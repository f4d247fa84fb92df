"""Films: H.264 by the system's ffmpeg where there is one, which plays everywhere, else MPEG-4."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from contextlib import suppress
from pathlib import Path
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import FileError
from tracker.base.files import DiskError

Image = NDArray[np.uint8]
_ENCODERS = (
    ("libx264", ["-preset", "veryfast", "-crf", "20"]),
    ("libopenh264", ["-b:v", "6M"]),
)
"""Of ffmpeg, in this order, and what each is told."""
_LOOK, _END = 20.0, 600.0  # s that ffmpeg may take to tell its encoders, and to end a film
PLAIN = "MPEG-4 part 2 (OpenCV)"
NO_FFMPEG = (
    "There is no ffmpeg with H.264 on this computer: the film is MPEG-4 part 2, which browsers and "
    "some players do not show."
)


class Film(Protocol):
    """Takes images (h, w, 3) BGR of one size. ``codec`` in words."""

    codec: str

    def write(self, image: Image) -> None: ...

    def close(self) -> None: ...


def open_film(path: Path, rate: float, image: Image) -> Film:
    """A film of images like ``image`` at ``rate`` Hz. Raises FileError where none can be made."""
    encoder = h264()
    return Mpeg4Film(path, rate, image) if encoder is None else H264Film(path, rate, image, encoder)


def h264() -> tuple[str, list[str]] | None:
    """ffmpeg's encoder for H.264 and its arguments; None without one."""
    program = shutil.which("ffmpeg")
    if program is None:
        return None
    try:
        asked = [program, "-hide_banner", "-encoders"]
        told = subprocess.run(asked, capture_output=True, text=True, timeout=_LOOK, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return None
    known = told.stdout.split()
    return next(((name, words) for name, words in _ENCODERS if name in known), None)


class H264Film:
    """Images go to ffmpeg as they are; an odd last row or column is left out."""

    def __init__(
        self, path: Path, rate: float, image: Image, encoder: tuple[str, list[str]]
    ) -> None:
        name, words = encoder
        self.codec = f"H.264 ({name})"
        self._path = path
        self._words = tempfile.TemporaryFile()  # noqa: SIM115  closed with the film
        size = f"{image.shape[1]}x{image.shape[0]}"
        given = ["-f", "rawvideo", "-pix_fmt", "bgr24", "-s", size, "-r", f"{rate:.6f}", "-i", "-"]
        even = ["-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2", "-pix_fmt", "yuv420p"]
        made = ["-c:v", name, *words, "-movflags", "+faststart", "-f", "mp4", str(path)]
        quiet = ["ffmpeg", "-hide_banner", "-loglevel", "error", "-y"]
        self._process = subprocess.Popen(
            [*quiet, *given, *even, *made],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._words,
        )

    def write(self, image: Image) -> None:
        """Raises DiskError in ffmpeg's words where it has ended."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(np.ascontiguousarray(image).data)
        except OSError:
            self.close()
            raise DiskError(f"{self._path.name} could not be written by ffmpeg.") from None

    def close(self) -> None:
        """Raises DiskError where no whole film has come of it."""
        assert self._process.stdin is not None
        if self._words.closed:
            return
        with suppress(OSError):  # it has ended already: its status tells why
            self._process.stdin.close()
        try:
            status = self._process.wait(_END)
        except subprocess.TimeoutExpired:
            self._process.kill()
            status = self._process.wait()
        self._words.seek(0)
        said = self._words.read().decode("utf-8", "replace").strip().splitlines()
        self._words.close()
        if status:
            why = said[-1] if said else f"it ended with {status}"
            raise DiskError(f"{self._path.name} could not be written by ffmpeg: {why[:200]}")


class Mpeg4Film:
    """OpenCV's own, where there is no ffmpeg."""

    codec = PLAIN

    def __init__(self, path: Path, rate: float, image: Image) -> None:
        size = image.shape[1], image.shape[0]
        self._writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"mp4v"), rate, size)
        if not self._writer.isOpened():
            raise FileError(f"OpenCV on this computer cannot write {path.name}.")

    def write(self, image: Image) -> None:
        self._writer.write(image)

    def close(self) -> None:
        self._writer.release()
