"""Points of a recorded hand over time, independent of the file format."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array


@dataclass(frozen=True, eq=False)
class PointTrack:
    """Named points at times t (n,) s from 0: points (n, T, 3), NaN where missing.

    ``targets`` (T,) is the position of each point on the hand: a keypoint's name, or
    "dorsum:<name>" for a marker on the back of the hand. ``up`` (3,) points against gravity in the
    file's frame. ``unit`` is metres per unit of ``points``, None if unknown.
    """

    t: Array
    points: Array
    targets: tuple[str, ...]
    up: Array
    side: str
    unit: float | None

    def checked(self, path: str) -> PointTrack:
        """Returns itself, if a hand can be fitted to it. Raises FileError."""
        if len(self.t) < 20:
            raise FileError(notice("motion.few_frames", path=path, frames=len(self.t)))
        if not np.all(np.diff(self.t) > 0):
            raise FileError(notice("motion.times", path=path))
        whole = np.isfinite(self.points).all(axis=2)
        if whole.sum(axis=1).max() < 6:
            raise FileError(notice("motion.few_points", path=path))
        return self


def mirrored(track: PointTrack, side: str) -> PointTrack:
    """The track for a hand of ``side``: mirrored in a plane that contains ``up`` if necessary."""
    if track.side == side:
        return track
    across = np.cross(track.up, [1.0, 0, 0])
    if np.linalg.norm(across) < 0.1:
        across = np.cross(track.up, [0, 1.0, 0])
    across /= np.linalg.norm(across)
    points = track.points - 2 * (track.points @ across)[..., None] * across
    return PointTrack(track.t, points, track.targets, track.up, side, track.unit)


def resampled(track: PointTrack, rate_hz: float) -> PointTrack:
    """At a uniform rate, by linear interpolation between neighbours; gaps are preserved."""
    t = np.arange(0.0, track.t[-1], 1 / rate_hz)
    after = np.clip(np.searchsorted(track.t, t, side="right"), 1, len(track.t) - 1)
    t0, t1 = track.t[after - 1], track.t[after]
    share = ((t - t0) / (t1 - t0))[:, None, None]
    points = track.points[after - 1] * (1 - share) + track.points[after] * share
    points[t1 - t0 > 0.1] = np.nan  # a gap in the file, not two neighbours
    return PointTrack(t, points, track.targets, track.up, track.side, track.unit)
