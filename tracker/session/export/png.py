"""PNG: the overlay as a folder of numbered images, with a table of their instants."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2

from tracker.errors import FileError
from tracker.session.export.csv import seconds_text
from tracker.session.export.motion import ExportOptions, Motion
from tracker.session.export.overlay import Overlay
from tracker.session.reader import SessionReader

TABLE = "pictures.csv"


def export_png(reader: SessionReader, path: Path, options: ExportOptions) -> Motion:
    """``path`` becomes a folder of 000000.png… and ``pictures.csv`` (file, t in s).

    Raises FileError if the session has no images.
    """
    overlay = Overlay(reader, options)
    zero = int(overlay.motion.stamp_ns[0]) if "time" in options.anonymous else 0
    path.mkdir()
    lines = ["file,t"]
    for k, (stamp, image) in enumerate(overlay.images()):
        name = f"{k:06d}.png"
        if not cv2.imwrite(str(path / name), image):
            raise FileError(f"{name} cannot be written: the disk may be full.")
        lines.append(f"{name},{seconds_text(stamp - zero)}")
    (path / TABLE).write_text("\n".join(lines) + "\n", "utf-8")
    return replace(overlay.motion, notes={"pictures": len(lines) - 1})
