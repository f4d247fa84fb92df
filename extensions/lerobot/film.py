"""Encodes videos with the system's ffmpeg, in the format that most players support (H.264)."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType

from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice

PROGRAM = "ffmpeg"
KEYFRAMES = 2  # frames between key frames: fast random access
QUALITY = 23  # x264's constant rate factor
END_WAIT = 600.0  # s


def check_program() -> str:
    """Path of ffmpeg. Raises ConfigError if it is not installed."""
    found = shutil.which(PROGRAM)
    if found is None:
        raise ConfigError(notice("lerobot.needs_program", program=PROGRAM))
    return found


class DatasetFilm:
    """Writes encoded images as the frames of the video ``path``.

    Frames numbered ``starts``, where episodes begin, are key frames.
    """

    def __init__(self, path: Path, fps: int, kind: str, starts: Sequence[int]) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self._path = path
        codec = "png" if kind == "png" else "mjpeg"
        given = ["-f", "image2pipe", "-c:v", codec, "-framerate", str(fps), "-i", "-"]
        even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"]
        coded = ["-c:v", "libx264", "-crf", str(QUALITY), "-g", str(KEYFRAMES), "-bf", "0"]
        before = (max(k - 0.5, 0.0) / fps for k in starts)  # the next frame becomes a key frame
        keys = ["-force_key_frames", ",".join(f"{t:.6f}" for t in before)]
        made = [*even, *coded, *keys, "-pix_fmt", "yuv420p", "-movflags", "+faststart", str(path)]
        self._log = path.with_suffix(".log")
        with self._log.open("wb") as log:
            self._process = subprocess.Popen(
                [check_program(), "-y", "-loglevel", "error", *given, *made],
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=log,
            )

    def __enter__(self) -> DatasetFilm:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if kind is None:
            self.close()
        else:
            self._process.kill()
            self._process.wait()

    def write(self, image: bytes) -> None:
        """Append an image. Raises FileError if ffmpeg has ended."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(image)
        except OSError:
            self.close()

    def close(self) -> None:
        """Finish the video. Raises FileError with ffmpeg's message if it failed."""
        assert self._process.stdin is not None
        with suppress(OSError):  # ffmpeg has ended; its exit status is checked below
            self._process.stdin.close()
        status = self._process.wait(END_WAIT)
        log = self._log.read_text("utf-8", "replace").strip().splitlines()
        self._log.unlink()
        if status:
            why = log[-1] if log else f"exit status {status}"
            raise FileError(
                notice("lerobot.film_failed", program=PROGRAM, path=self._path, why=why)
            )
