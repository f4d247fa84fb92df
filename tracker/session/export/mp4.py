"""MP4: the overlay as a film, by OpenCV's own writer."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2

from tracker.errors import FileError
from tracker.session.export.motion import ExportOptions, Motion
from tracker.session.export.overlay import Image, Overlay
from tracker.session.reader import SessionReader


def export_mp4(reader: SessionReader, path: Path, options: ExportOptions) -> Motion:
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
    notes: dict[str, object] = {"pictures": count, "pictures_per_second": round(rate, 3)}
    return replace(overlay.motion, notes=notes)


def _open(path: Path, rate: float, image: Image) -> cv2.VideoWriter:
    size = image.shape[1], image.shape[0]
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"mp4v"), rate, size)
    if not writer.isOpened():
        raise FileError(f"OpenCV on this computer cannot write {path.name}.")
    return writer
