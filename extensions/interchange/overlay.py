"""Exports images with the tracked hand drawn in, and other views, as a video or PNG files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from extensions.interchange.film import NO_FFMPEG, PLAIN, Film, open_film
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
