"""Leap Motion hand tracks, decoded to NumPy archives: joints in mm, y up."""

from __future__ import annotations

import zipfile
import zlib
from pathlib import Path

import numpy as np

from tracker.base.errors import FileError
from tracker.base.files import check_regular
from tracker.hand.names import FINGERS
from tracker.simulation.recorded.track import PointTrack

MOST_BYTES = 500_000_000
"""Of a recording once unpacked; an hour at 120 Hz takes 220 MB."""
UNPACKING = (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError)
"""What damage to an archive raises; the last one where it says that a password is needed."""
TARGETS = (
    *(f"thumb_{part}" for part in ("cmc", "mcp", "ip", "tip")),
    *(f"{f}_{part}" for f in FINGERS for part in ("mcp", "pip", "dip", "tip")),
)


def read_leap(path: Path) -> PointTrack:
    """t (N,) s and joints (N, 5, 4, 3) mm: thumb to little finger, base to tip."""
    try:
        check_regular(path)
        with zipfile.ZipFile(path) as archive:
            if sum(part.file_size for part in archive.infolist()) > MOST_BYTES:
                raise FileError(f"{path} contains more than {MOST_BYTES // 10**6} MB.")
        with np.load(path, allow_pickle=False) as data:
            t, joints, side = data["t"], data["joints"], str(np.ravel(data["hand"])[0])
    except (OSError, ValueError, KeyError, EOFError, MemoryError, *UNPACKING) as error:
        raise FileError(f"{path} is not a decoded Leap recording: {error}.") from error
    if joints.shape != (len(t), 5, 4, 3) or side not in ("left", "right"):
        raise FileError(f"{path} does not hold five fingers of four joints, of one hand.")
    new = np.concatenate([[True], np.diff(t) > 1e-4])
    points = joints[new].reshape(-1, 20, 3).astype(float)
    up = np.array([0.0, 1.0, 0.0])
    return PointTrack(t[new] - t[0], points, TARGETS, up, side, 1e-3)
