"""Two recordings on one time axis: that of the first one's replay, in s from its first measurement.

``offset``: start of the second recording on this axis.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.words import local, tr
from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.messages import Array, StereoFrame, Validity
from tracker.session.align import (
    Match,
    SessionAlignment,
    alignment_path,
    best_match,
    course_of_angles,
    keep,
    read_alignment,
)
from tracker.session.export.series import read_series
from tracker.session.holes import LONGEST_FILLED, durations, with_breaks
from tracker.session.images import PackedFrame
from tracker.session.motion import instants
from tracker.session.reader import SessionReader

LATEST = 0.3  # maximum age of an image in s at which it is shown for an instant
Image = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class RecordingAngles:
    """``t`` (N,) s from the first measurement; ``angles`` (N, J) rad, NaN where lost.

    ``start``: the first measurement, s of its monotonic clock, and ``wall_ns`` since 1970.
    """

    path: Path
    start: float
    wall_ns: int
    duration: float
    names: tuple[str, ...]
    t: Array
    angles: Array

    def curve(self, name: str) -> tuple[Array, Array]:
        """Times (s) and values (rad) of an angle, as a line."""
        return with_breaks(self.t, self.angles[:, self.names.index(name)])


@dataclass(frozen=True)
class AngleDifference:
    """Difference of a joint angle, rad, over ``common`` s in which it is known in both
    recordings."""

    rms: float
    largest: float
    common: float


@dataclass(frozen=True, eq=False)
class TwoRecordings:
    first: RecordingAngles
    second: RecordingAngles

    @property
    def names(self) -> tuple[str, ...]:
        """The joint angles that both have, in the order of the first."""
        return tuple(n for n in self.first.names if n in self.second.names)

    @property
    def by_clock(self) -> float | None:
        """The offset according to the computers' clocks; None if the recordings do not overlap."""
        offset = (self.second.wall_ns - self.first.wall_ns) / NS
        apart = offset > self.first.duration or offset < -self.second.duration
        return None if apart else offset

    def by_movement(self) -> Match:
        """The offset with the best match of angular velocities. Raises FileError without an
        unambiguous match."""
        one, other = (
            course_of_angles(take.wall_ns, take.t, take.angles[:, columns])
            for take, columns in ((t, [t.names.index(n) for n in self.names]) for t in self._both)
        )
        return best_match(one, other)

    @property
    def kept(self) -> float | None:
        """The offset stored next to the second recording for the first; None without one."""
        path = alignment_path(self.second.path)
        if not path.is_file():
            return None
        try:
            found = read_alignment(path)
        except FileError:
            return None
        return found.offset_s if found.first == self.first.path.name else None

    def save(self, offset: float) -> Path:
        """Store the offset next to the second recording; returns the file. Raises FileError."""
        path = alignment_path(self.second.path)
        by_clock = (self.second.wall_ns - self.first.wall_ns) / NS
        names = self.first.path.name, self.second.path.name
        keep(SessionAlignment(*names, "hand", offset, offset - by_clock), path, force=True)
        return path

    @property
    def _both(self) -> tuple[RecordingAngles, RecordingAngles]:
        return self.first, self.second

    def shift(self, offset: float) -> float:
        """s by which the monotonic clock of the second is ahead of the first."""
        return self.second.start - self.first.start - offset

    def curves(self, name: str, offset: float) -> tuple[Array, Array, Array, Array]:
        """Times and values (rad) of the first, then of the second on the first one's axis; NaN
        where lost and in holes."""
        t, first = self.first.curve(name)
        t_second, second = self.second.curve(name)
        return t, first, t_second + offset, second

    def difference(self, name: str, offset: float) -> Array:
        """Second minus first at the times of the first one's curve, rad; NaN where either is
        unknown."""
        t, first, t_second, second = self.curves(name, offset)
        return between(t, t_second, second) - first

    def figures(self, name: str, offset: float) -> AngleDifference | None:
        """None if the recordings have no instant in common."""
        difference = self.difference(name, offset)
        known = np.isfinite(difference)
        if not known.any():
            return None
        some, t = difference[known], self.curves(name, offset)[0][known]
        return AngleDifference(
            float(np.sqrt(np.mean(some**2))), float(np.abs(some).max()), float(durations(t).sum())
        )


def between(t: Array, known_t: Array, values: Array) -> Array:
    """Linear interpolation of ``values`` at ``t``; NaN outside, and where the next value is far."""
    good = np.isfinite(values)
    known_t, values = known_t[good], values[good]
    if len(known_t) < 2:
        return np.full(len(t), np.nan)
    out = np.interp(t, known_t, values, left=np.nan, right=np.nan)
    after = np.clip(np.searchsorted(known_t, t), 1, len(known_t) - 1)
    out[known_t[after] - known_t[after - 1] > LONGEST_FILLED] = np.nan
    return out


def read_angles(path: Path) -> RecordingAngles:
    """A session's joint angles. Raises FileError if the file is not a session."""
    with SessionReader(path) as reader:
        series = read_series(reader, segments=False)
        return RecordingAngles(
            path,
            reader.anchor.monotonic(reader.span_ns[0]),
            reader.span_ns[0],
            reader.duration,
            series.joint_names,
            instants(reader, series),
            np.where(series.angle_state == int(Validity.LOST), np.nan, series.angles),
        )


def figures_text(figures: AngleDifference | None) -> str:
    """One line."""
    if figures is None:
        return tr("The recordings have no tracked instant in common here.")
    rms, largest = np.rad2deg([figures.rms, figures.largest])
    return tr("differ by {:.1f}° (rms), {:.1f}° at most, over {:.1f} s").format(
        local(rms), local(largest), local(figures.common)
    )


class RecordingImages:
    """Images of one file, opened on first use. Not thread-safe."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._reader: SessionReader | None = None

    def at(self, position: float) -> Image | None:
        """(h, w, 3) BGR of the left camera, or of the right one if it is the only one, ``position``
        s after the first measurement; None without an image or if it is damaged."""
        if self._reader is None:
            self._reader = SessionReader(self._path)
        reader = self._reader
        t = reader.anchor.monotonic(reader.span_ns[0]) + position
        try:
            found = [
                m
                for m in reader.packed_messages((StereoFrame,), t - LATEST, t + 1e-3)
                if isinstance(m, PackedFrame)
            ]
            frame = found[-1].unpack() if found else None
        except FileError:
            return None  # the replay reports the damage
        if frame is None:
            return None
        return frame.left if frame.left is not None else frame.right

    def close(self) -> None:
        """Close the file."""
        if self._reader is not None:
            self._reader.close()
            self._reader = None
