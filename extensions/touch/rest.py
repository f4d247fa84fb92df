"""Touches in a track: a fingertip at rest near a cross, at the height of its paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from extensions.touch.pose import SheetPose
from extensions.touch.protocol import Cued, TouchCue
from extensions.touch.sheet import CROSSES
from extensions.touch.track import TipTrack
from tracker.messages import Array

WINDOW = 0.10  # s on both sides over which a speed is taken
SPEED = 0.025  # m/s below which a tip rests
SHORTEST = 0.25  # s
EDGE = 0.05  # s left out at both ends: the tip still slows down
UNDERWAY = WINDOW + EDGE + 0.05  # s after the cue, by which a rest has begun before it
NEAR, HIGH = 0.060, 0.045
"""m off a cross, and its paper, within which a touch that was asked for is found, however wrong."""
OTHER, SURELY = 0.008, 0.030
"""m: another cross was touched if the tip is this near to it, and this far from the one asked."""
FREE, FREE_HIGH = 0.015, 0.025  # m: `NEAR` and `HIGH` without a cue
ALONE = 0.012  # m by which the next cross, or finger, must be farther without a cue


@dataclass(frozen=True, eq=False)
class CrossTouch:
    """A fingertip on a cross from ``begin`` to ``end`` s; means over that time.

    p_G (3,) m of the tip keypoint, R_GB (3, 3), sd m claimed, radius m, target_G (3,) m;
    ``distance`` m of the target from the left lens, where that is known.
    ``asked`` is the cross of the cue, which another than ``cue.target`` may have been touched
    instead of.
    """

    cue: TouchCue
    begin: float
    end: float
    p_G: Array
    R_GB: Array
    sd: float
    radius: float
    target_G: Array
    asked: str = ""
    distance: float = float("nan")


def find_touches(
    tracks: Mapping[str, TipTrack], cued: Sequence[Cued], pose: SheetPose
) -> tuple[list[CrossTouch], list[TouchCue]]:
    """The touches that were asked for, and the cues for which none was found."""
    found: list[CrossTouch] = []
    missed: list[TouchCue] = []
    for c in cued:
        if c.cue.what != "touch":
            continue
        touch = _asked_touch(tracks, c, pose)
        if touch is None:
            missed.append(c.cue)
        else:
            found.append(touch)
    return found, missed


def find_free_touches(tracks: Mapping[str, TipTrack], pose: SheetPose) -> list[CrossTouch]:
    """Touches without cues: rests near one cross and with one finger only."""
    found: list[CrossTouch] = []
    for finger, track in tracks.items():
        for begin, end in rests(track):
            middle = _mean(track, begin, end)
            names, off = _crosses_near(middle, pose, FREE_HIGH)
            if off[0] > FREE or off[1] - off[0] < ALONE:
                continue
            others = [_nearest(t, begin, end, pose) for f, t in tracks.items() if f != finger]
            if min(others, default=np.inf) > off[0] + ALONE:
                cue = TouchCue(len(found) + 1, "touch", finger, names[0], "free")
                found.append(_touch(track, cue, begin, end, pose))
    return sorted(found, key=lambda touch: touch.begin)


def rests(track: TipTrack) -> list[tuple[float, float]]:
    """(begin, end) s of each time for which the tip rests."""
    if len(track.t) < 3:
        return []
    speed = _speed(track)
    still = np.r_[False, (speed < SPEED) & track.known, False]
    begins = np.flatnonzero(~still[:-1] & still[1:])
    ends = np.flatnonzero(still[:-1] & ~still[1:]) - 1
    spans = [(float(track.t[b]), float(track.t[e])) for b, e in zip(begins, ends, strict=True)]
    return [(b + EDGE, e - EDGE) for b, e in spans if e - b >= SHORTEST]


def _speed(track: TipTrack) -> Array:
    """(n,) m/s over the time around each instant; infinite at gaps."""
    before = np.searchsorted(track.t, track.t - WINDOW)
    after = np.searchsorted(track.t, track.t + WINDOW, side="right") - 1
    dt = track.t[after] - track.t[before]
    moved = np.linalg.norm(track.p_G[after] - track.p_G[before], axis=1)
    speed = np.where(dt >= WINDOW, moved / np.maximum(dt, 1e-9), np.inf)
    return np.where(np.isfinite(speed), speed, np.inf)


def _asked_touch(tracks: Mapping[str, TipTrack], c: Cued, pose: SheetPose) -> CrossTouch | None:
    """The longest rest on a cross while it was asked for; a finger that still rests on the cross
    before when it is asked for the next one counts only if it does not rest again."""
    if c.cue.finger not in tracks:
        return None
    track = tracks[c.cue.finger].between(c.begin, c.end)
    best = None
    spans = rests(track)
    if len(spans) > 1 and spans[0][0] < c.begin + UNDERWAY:
        spans = spans[1:]
    for begin, end in spans:
        names, off = _crosses_near(_mean(track, begin, end), pose, HIGH)
        asked_off = dict(zip(names, off, strict=True))[c.cue.target]
        other = off[0] < OTHER and asked_off > SURELY
        shorter = best is not None and end - begin < best[1] - best[0]
        if shorter or not (other or asked_off < NEAR):
            continue
        best = (begin, end, names[0] if other else c.cue.target)
    if best is None:
        return None
    begin, end, name = best
    cue = TouchCue(c.cue.number, "touch", c.cue.finger, name, c.cue.how)
    return _touch(track, cue, begin, end, pose, c.cue.target)


def _crosses_near(p_G: Array, pose: SheetPose, highest: float) -> tuple[list[str], Array]:
    """Names of the crosses, nearest first, and their distances m; those that the tip is too high
    above, or below, are infinitely far."""
    up_G = -pose.R_GS[:, 2]
    off = []
    for cross in CROSSES:
        away = p_G - pose.target(cross.p_S)
        high = float(away @ up_G)
        flat = float(np.linalg.norm(away - high * up_G))
        off.append(flat if abs(high) < highest else np.inf)
    order = np.argsort(off, kind="stable")
    return [CROSSES[k].name for k in order], np.array(off)[order]


def _nearest(track: TipTrack, begin: float, end: float, pose: SheetPose) -> float:
    return float(_crosses_near(_mean(track, begin, end), pose, FREE_HIGH)[1][0])


def _mean(track: TipTrack, begin: float, end: float) -> Array:
    part = track.between(begin, end)
    known = part.p_G[part.known]
    return known.mean(axis=0) if len(known) else np.full(3, np.nan)


def _touch(
    track: TipTrack, cue: TouchCue, begin: float, end: float, pose: SheetPose, asked: str = ""
) -> CrossTouch:
    part = track.between(begin, end)
    target = next(c for c in CROSSES if c.name == cue.target)
    u, _, vt = np.linalg.svd(part.R_GB[part.known].mean(axis=0))
    return CrossTouch(
        cue=cue,
        begin=begin,
        end=end,
        p_G=part.p_G[part.known].mean(axis=0),
        R_GB=u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt,
        sd=float(np.mean(part.sd[part.known])),
        radius=track.radius,
        target_G=pose.target(target.p_S),
        asked=asked or cue.target,
    )
