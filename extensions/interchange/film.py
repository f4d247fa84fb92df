"""Writes videos: H.264 with the system's ffmpeg if available, otherwise MPEG-4."""

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
from tracker.base.notices import notice

Image = NDArray[np.uint8]
_ENCODERS = (
    ("libx264", ["-preset", "veryfast", "-crf", "20"]),
    ("libopenh264", ["-b:v", "6M"]),
)
"""Encoders of ffmpeg in order of preference, with their arguments."""
_LOOK, _END = 20.0, 600.0  # s: timeouts for listing encoders and for finishing a video
PLAIN = "MPEG-4 part 2 (OpenCV)"
NO_FFMPEG = (
    "ffmpeg with H.264 is not installed: the video is MPEG-4 part 2, which browsers and some "
    "players cannot show."
)


class Film(Protocol):
    """Takes images (h, w, 3) BGR of one size. ``codec`` is the name of the encoding."""

    codec: str

    def write(self, image: Image) -> None: ...

    def close(self) -> None: ...


def open_film(path: Path, rate: float, image: Image) -> Film:
    """Open a video for images like ``image`` at ``rate`` Hz. Raises FileError if that fails."""
    encoder = h264()
    return Mpeg4Film(path, rate, image) if encoder is None else H264Film(path, rate, image, encoder)


def h264() -> tuple[str, list[str]] | None:
    """ffmpeg's encoder for H.264 and its arguments; None without one."""
    program = shutil.which("ffmpeg")
    if program is None:
        return None
    try:
        asked = [program, "-hide_banner", "-encoders"]
        listing = subprocess.run(asked, capture_output=True, text=True, timeout=_LOOK, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return None
    known = listing.stdout.split()
    return next(((name, options) for name, options in _ENCODERS if name in known), None)


class H264Film:
    """Encodes with ffmpeg; an odd last row or column is cropped."""

    def __init__(
        self, path: Path, rate: float, image: Image, encoder: tuple[str, list[str]]
    ) -> None:
        name, options = encoder
        self.codec = f"H.264 ({name})"
        self._path = path
        self._log = tempfile.TemporaryFile()  # noqa: SIM115  closed with the video
        size = f"{image.shape[1]}x{image.shape[0]}"
        given = ["-f", "rawvideo", "-pix_fmt", "bgr24", "-s", size, "-r", f"{rate:.6f}", "-i", "-"]
        even = ["-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2", "-pix_fmt", "yuv420p"]
        made = ["-c:v", name, *options, "-movflags", "+faststart", "-f", "mp4", str(path)]
        quiet = ["ffmpeg", "-hide_banner", "-loglevel", "error", "-y"]
        self._process = subprocess.Popen(
            [*quiet, *given, *even, *made],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._log,
        )

    def write(self, image: Image) -> None:
        """Append an image. Raises DiskError if ffmpeg has ended."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(np.ascontiguousarray(image).data)
        except OSError:
            self.close()
            raise DiskError(notice("film.ffmpeg_failed", file=self._path.name)) from None

    def close(self) -> None:
        """Finish the video. Raises DiskError if it is incomplete."""
        assert self._process.stdin is not None
        if self._log.closed:
            return
        with suppress(OSError):  # ffmpeg has ended; its exit status is checked below
            self._process.stdin.close()
        try:
            status = self._process.wait(_END)
        except subprocess.TimeoutExpired:
            self._process.kill()
            status = self._process.wait()
        self._log.seek(0)
        log = self._log.read().decode("utf-8", "replace").strip().splitlines()
        self._log.close()
        if status:
            why = log[-1] if log else f"exit status {status}"
            raise DiskError(notice("film.ffmpeg_failed_why", file=self._path.name, why=why[:200]))


class Mpeg4Film:
    """Encodes with OpenCV if ffmpeg is not available."""

    codec = PLAIN

    def __init__(self, path: Path, rate: float, image: Image) -> None:
        size = image.shape[1], image.shape[0]
        self._writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"mp4v"), rate, size)
        if not self._writer.isOpened():
            raise FileError(notice("film.opencv_cannot", file=path.name))

    def write(self, image: Image) -> None:
        self._writer.write(image)

    def close(self) -> None:
        self._writer.release()
