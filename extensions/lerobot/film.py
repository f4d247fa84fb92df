"""Films by the system's ffmpeg, which has what most browsers and readers take (H.264)."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType

from tracker.base.errors import ConfigError, FileError

PROGRAM = "ffmpeg"
KEYFRAMES = 2  # frames from one to the next: any is found quickly
QUALITY = 23  # x264's constant rate factor
END_WAIT = 600.0  # s


def check_program() -> str:
    """Where it is. Raises ConfigError where it is not."""
    found = shutil.which(PROGRAM)
    if found is None:
        raise ConfigError(
            f"Films need {PROGRAM}, which this computer has not; take the images as recorded."
        )
    return found


class DatasetFilm:
    """Encoded images, one after the other, become the frames of ``path``.

    Those numbered ``starts`` can be shown without any before them: episodes begin there.
    """

    def __init__(self, path: Path, fps: int, kind: str, starts: Sequence[int]) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self._path = path
        codec = "png" if kind == "png" else "mjpeg"
        given = ["-f", "image2pipe", "-c:v", codec, "-framerate", str(fps), "-i", "-"]
        even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"]
        coded = ["-c:v", "libx264", "-crf", str(QUALITY), "-g", str(KEYFRAMES), "-bf", "0"]
        before = (max(k - 0.5, 0.0) / fps for k in starts)  # the first frame from then on is a key
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
        """Raises FileError where ffmpeg has ended."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(image)
        except OSError:
            self.close()

    def close(self) -> None:
        """Raises FileError in ffmpeg's words where no film has come of it."""
        assert self._process.stdin is not None
        with suppress(OSError):  # it has ended already: its status says why
            self._process.stdin.close()
        status = self._process.wait(END_WAIT)
        words = self._log.read_text("utf-8", "replace").strip().splitlines()
        self._log.unlink()
        if status:
            why = words[-1] if words else f"it ended with {status}"
            raise FileError(f"{self._path} could not be made by {PROGRAM}: {why}.")
