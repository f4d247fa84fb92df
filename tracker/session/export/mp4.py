"""MP4: the left pictures with the tracked hand drawn over them, by OpenCV's own writer."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.clock import nanoseconds
from tracker.errors import FileError
from tracker.messages import Array, StereoFrame, Validity
from tracker.session.export.motion import ExportOptions, Motion, load_motion
from tracker.session.export.skeleton import bone_tree
from tracker.session.reader import SessionReader
from tracker.vision.rig import StereoRig

_COLOUR = {Validity.MEASURED: (80, 220, 80), Validity.INFERRED: (60, 180, 250)}  # BGR
_NEAR_NS = 50_000_000


def export_mp4(reader: SessionReader, path: Path, options: ExportOptions) -> Motion:
    """Raises FileError if the session has no pictures, or this computer cannot write MP4."""
    motion = load_motion(reader, ExportOptions(start=options.start, stop=options.stop))
    rig = reader.rig()
    rate = options.rate or _frame_rate(reader)
    writer = None
    try:
        for frame in reader.messages([StereoFrame]):
            assert isinstance(frame, StereoFrame)
            row = _nearest(motion, reader.anchor.wall(frame.t))
            if frame.left is None or row is None:
                continue
            writer = writer or _open(path, rate, frame.left)
            writer.write(_drawn(frame, motion, row, rig))
    finally:
        if writer is not None:
            writer.release()
    if writer is None:
        raise FileError(f"{reader.path} holds no pictures of the tracked time.")
    return motion


def _open(path: Path, rate: float, image: NDArray[np.uint8]) -> cv2.VideoWriter:
    size = image.shape[1], image.shape[0]
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"mp4v"), rate, size)
    if not writer.isOpened():
        raise FileError(f"OpenCV on this computer cannot write {path}.")
    return writer


def _frame_rate(reader: SessionReader) -> float:
    """Pictures per second from the first hundred."""
    stamps: list[int] = []
    for frame in reader.messages([StereoFrame]):
        stamps.append(nanoseconds(frame.t))
        if len(stamps) == 100:
            break
    steps = np.diff(stamps)
    return 1e9 / float(np.median(steps)) if len(steps) else 30.0


def _nearest(m: Motion, stamp: int) -> int | None:
    row = int(np.argmin(np.abs(m.stamp_ns - stamp)))
    return row if abs(int(m.stamp_ns[row]) - stamp) <= _NEAR_NS else None


def _drawn(frame: StereoFrame, m: Motion, row: int, rig: StereoRig) -> NDArray[np.uint8]:
    """A copy of the left picture with bones and keypoints; what is lost is not drawn."""
    pose = frame.pose or rig.pose
    p_C = (m.keypoints[row] - pose.p_GC) @ pose.R_GC
    uv: Array = rig.left.unrectify(rig.project(p_C))
    assert frame.left is not None
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
