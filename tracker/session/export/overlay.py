"""The left images with the tracked hand drawn over them, as a film (MP4) or a folder of PNG."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.clock import NS
from tracker.errors import FileError
from tracker.files import DiskError
from tracker.messages import Array, StereoFrame, Validity
from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries, seconds_text
from tracker.session.export.skeleton import bone_tree
from tracker.session.images import PackedFrame, encode_image
from tracker.session.reader import SessionReader
from tracker.vision.rig import StereoRig

Image = NDArray[np.uint8]
_COLOUR = {Validity.MEASURED: (80, 220, 80), Validity.INFERRED: (60, 180, 250)}  # BGR
_NEAR_NS = 50_000_000
TABLE = "pictures.csv"
_LATE_S = 0.2  # s that an image may arrive after its exposure


@dataclass(frozen=True, eq=False)
class Overlay:
    """A session's motion and its images, drawn one at a time."""

    reader: SessionReader
    options: ExportOptions
    motion: EstimateSeries = field(init=False)

    def __post_init__(self) -> None:
        span = ExportOptions(start=self.options.start, stop=self.options.stop)
        object.__setattr__(self, "motion", load_series(self.reader, span))

    def images(self) -> Iterator[tuple[int, Image]]:
        """(stamp ns, (h, w, 3) BGR) of every chosen image of the tracked time, at ``rate`` with
        images left out or repeated. Raises FileError if there is none."""
        rig, first, before, given = self.reader.rig(), 0, None, 0
        for stamp, row, frame in self._chosen():
            if not given:
                first = stamp
            times = 1
            if self.options.rate is not None:
                due = (stamp - first) / NS * self.options.rate
                times = int(due + 0.499) + 1 - given  # one half way belongs to the one before
            if times < 1:
                continue
            image = self._drawn(frame.unpack(), row, rig)
            if image is None:
                continue
            for _ in range(times - 1):  # where images are missing the last one stands still
                yield stamp, image if before is None else before
            yield stamp, image
            before, given = image, given + times
        if not given:
            raise FileError(f"{self.reader.path} holds no images of the tracked time.")

    def frame_rate(self) -> float:
        """Of what `images` gives, a second, judged by the first hundred."""
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
        """Stamp, row of the motion and the image: of every n-th with an estimate near it."""
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

    def _drawn(self, frame: StereoFrame, row: int, rig: StereoRig) -> Image | None:
        """A copy of the left image with bones and keypoints; what is lost is not drawn."""
        if frame.left is None:
            return None
        m, pose = self.motion, frame.pose or rig.pose
        uv: Array = rig.left.unrectify(rig.project((m.keypoints[row] - pose.p_GC) @ pose.R_GC))
        image = frame.left.copy()
        names, parent = bone_tree(m.keypoint_names)
        columns = [m.keypoint_names.index(n) for n in names]
        for i, a in enumerate(parent):
            state = Validity(int(m.state[row, columns[i]]))
            if not np.isfinite(uv[columns[i]]).all() or state not in _COLOUR:
                continue
            here = _pixel(uv[columns[i]])
            if a >= 0 and np.isfinite(uv[columns[a]]).all():
                cv2.line(image, _pixel(uv[columns[a]]), here, _COLOUR[state], 2, cv2.LINE_AA)
            cv2.circle(image, here, 3, _COLOUR[state], -1, cv2.LINE_AA)
        return image


def _pixel(uv: Array) -> tuple[int, int]:
    """Whole pixels, held to what OpenCV can draw."""
    u, v = np.clip(np.round(uv), -30000, 30000).astype(int)
    return int(u), int(v)


def export_mp4(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Raises FileError if the session has no images, or this computer cannot write MP4."""
    overlay = Overlay(reader, options)
    rate, count = overlay.frame_rate(), 0
    writer: cv2.VideoWriter | None = None
    try:
        for _, image in overlay.images():
            writer = writer or _open(path, rate, image)
            writer.write(image)
            count += 1
    finally:
        if writer is not None:
            writer.release()
    _check(path, count)
    notes: dict[str, object] = {"pictures": count, "pictures_per_second": round(rate, 3)}
    return replace(overlay.motion, notes=notes)


def _check(path: Path, count: int) -> None:
    """OpenCV tells of no write that failed. Raises DiskError if the last image is not there."""
    film = cv2.VideoCapture(str(path))
    found = round(film.get(cv2.CAP_PROP_FRAME_COUNT))
    film.set(cv2.CAP_PROP_POS_FRAMES, max(count - 1, 0))
    whole, _ = film.read()
    film.release()
    if found != count or not whole:
        raise DiskError(f"{path.name} could not be written as a whole: the disk may be full.")


def _open(path: Path, rate: float, image: Image) -> cv2.VideoWriter:
    size = image.shape[1], image.shape[0]
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"mp4v"), rate, size)
    if not writer.isOpened():
        raise FileError(f"OpenCV on this computer cannot write {path.name}.")
    return writer


def export_png(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """``path`` becomes a folder of 000000.png… and ``pictures.csv`` (file, t in s).

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
