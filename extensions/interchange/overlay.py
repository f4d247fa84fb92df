"""Exports images with the tracked hand drawn in, and other views, as a video or PNG files."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from extensions.interchange.views import FilmView, side_by_side, views_of
from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.files import DiskError
from tracker.base.notices import notice
from tracker.messages import StereoFrame
from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries, seconds_text
from tracker.session.images import PackedFrame, encode_image
from tracker.session.reader import SessionReader

Image = NDArray[np.uint8]
_NEAR_NS = 50_000_000
TABLE = "pictures.csv"
_LATE_S = 0.2  # s: largest delay between exposure and arrival of an image


@dataclass(frozen=True, eq=False)
class Overlay:
    """Draws a session's motion into its images, one at a time."""

    reader: SessionReader
    options: ExportOptions
    motion: EstimateSeries = field(init=False)

    def __post_init__(self) -> None:
        span = ExportOptions(start=self.options.start, stop=self.options.stop)
        object.__setattr__(self, "motion", load_series(self.reader, span, segments=True))

    def images(self) -> Iterator[tuple[int, Image]]:
        """Yields (stamp in ns, image (h, w, 3) BGR) of the selected images in the tracked time, at
        ``rate``, for which images are omitted or repeated. Raises FileError if there is none."""
        rig, first, before, given = self.reader.rig(), 0, None, 0
        views = views_of(self.options.views, self.reader, self.motion, rig)
        for stamp, row, frame in self._chosen():
            if not given:
                first = stamp
            times = 1
            if self.options.rate is not None:
                due = (stamp - first) / NS * self.options.rate
                times = int(due + 0.499) + 1 - given  # halfway belongs to the previous one
            if times < 1:
                continue
            whole = frame.unpack()
            image = self._drawn(whole, row, views) if whole is not None else None
            if image is None:
                continue
            for _ in range(times - 1):  # missing images repeat the last one
                yield stamp, image if before is None else before
            yield stamp, image
            before, given = image, given + times
        if not given:
            raise FileError(notice("film.no_images", path=self.reader.path))

    def frame_rate(self) -> float:
        """Rate of `images` in Hz, estimated from the first hundred."""
        if self.options.rate is not None:
            return self.options.rate
        stamps: list[int] = []
        for stamp, _, _ in self._chosen():
            stamps.append(stamp)
            if len(stamps) == 100:
                break
        steps = np.diff(stamps)
        return NS / float(np.median(steps)) if len(steps) else 30.0

    def _chosen(self) -> Iterator[tuple[int, int, PackedFrame]]:
        """Yields stamp, row of the motion and image for every n-th image with an estimate
        nearby."""
        anchor, stamps = self.reader.anchor, self.motion.stamp_ns
        start, stop = anchor.monotonic(int(stamps[0])), anchor.monotonic(int(stamps[-1]))
        near = self.reader.packed_messages((StereoFrame,), start - _LATE_S, stop + _LATE_S)
        count = 0
        for frame in near:
            assert isinstance(frame, PackedFrame)
            stamp = anchor.wall(frame.t)
            row = int(np.argmin(np.abs(stamps - stamp)))
            if "left" not in frame.parts or abs(int(stamps[row]) - stamp) > _NEAR_NS:
                continue
            if count % self.options.every == 0:
                yield stamp, row, frame
            count += 1

    def _drawn(self, frame: StereoFrame, row: int, views: Sequence[FilmView]) -> Image | None:
        """All views of an instant; None without the first view's image."""
        return side_by_side([view.draw(frame, row) for view in views])


def export_mp4(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write a video. Raises FileError if the session has no images or MP4 cannot be written."""
    overlay = Overlay(reader, options)
    rate, count = overlay.frame_rate(), 0
    film: Film | None = None
    try:
        for _, image in overlay.images():
            film = film or open_film(path, rate, image)
            film.write(image)
            count += 1
    finally:
        if film is not None:
            film.close()
    _check(path, count)
    codec = PLAIN if film is None else film.codec
    notes: dict[str, object] = {
        "pictures": count,
        "pictures_per_second": round(rate, 3),
        "views": list(options.views),
        "codec": codec,
    }
    if codec == PLAIN:
        notes["said"] = [NO_FFMPEG]
    return replace(overlay.motion, notes=notes)


def _check(path: Path, count: int) -> None:
    """Check the last image, since OpenCV does not report failed writes. Raises DiskError."""
    film = cv2.VideoCapture(str(path))
    found = round(film.get(cv2.CAP_PROP_FRAME_COUNT))
    film.set(cv2.CAP_PROP_POS_FRAMES, max(count - 1, 0))
    whole, _ = film.read()
    film.release()
    if found != count or not whole:
        raise DiskError(notice("export.incomplete", file=path.name))


def export_png(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write the folder ``path`` with 000000.png… and ``pictures.csv`` (file, t in s).

    Raises FileError if the session has no images.
    """
    overlay = Overlay(reader, options)
    zero = int(overlay.motion.stamp_ns[0]) if "time" in options.anonymous else 0
    path.mkdir()
    lines = ["file,t"]
    for k, (stamp, image) in enumerate(overlay.images()):
        name = f"{k:06d}.png"
        (path / name).write_bytes(encode_image(image, "png", 0))
        lines.append(f"{name},{seconds_text(stamp - zero)}")
    (path / TABLE).write_text("\n".join(lines) + "\n", "utf-8")
    return replace(overlay.motion, notes={"pictures": len(lines) - 1})


# ---- writes videos: H.264 with the system's ffmpeg if available, otherwise MPEG-4

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
