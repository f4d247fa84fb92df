"""Tests beside the touches: lengths between crosses, return to a cross, pinches, a still hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import find_peaks

from extensions.touch.contact import Pulp
from extensions.touch.protocol import Cued
from extensions.touch.rest import CrossTouch
from extensions.touch.statistics import (
    LEVEL,
    RESAMPLES,
    SEED,
    ConfidenceInterval,
    mean_interval,
    sd_interval,
)
from extensions.touch.track import TipTrack
from tracker.messages import Array, IntArray

PAD = 0.006  # m from the tip to the middle of the pad
SAME_CROSS = 1e-3  # m, at most between two touches of one cross
APART = 0.3  # s between two pinches at least
OPENED = 0.015  # m by which the fingers open between two pinches at least
SMOOTH = 5  # estimates, median


@dataclass(frozen=True)
class Lengths:
    """Ruler test: ``error`` m, mean of found less known lengths; ``scale`` found over known."""

    count: int
    error: ConfidenceInterval
    sd: float
    scale: ConfidenceInterval


def ruler_test(
    touches: Mapping[str, Sequence[CrossTouch]], pulps: Mapping[str, Pulp]
) -> Lengths | None:
    """Lengths between crosses that one finger touched; None with fewer than two. Intervals by
    bootstrap over touches, since lengths that share one depend on each other."""
    pairs = [_lengths(some, pulps[finger]) for finger, some in touches.items()]
    rows = _length_rows(pairs)
    if rows.shape[0] < 2:
        return None
    rng = np.random.default_rng(SEED)
    counts = [len(found) for found, _ in pairs]
    picks = [[rng.integers(0, n, n) for n in counts] for _ in range(RESAMPLES)]
    drawn = _resampled(pairs, [np.array(of_finger) for of_finger in zip(*picks, strict=True)])
    low, high = np.percentile(drawn, [50 - 50 * LEVEL, 50 + 50 * LEVEL], axis=0)
    found, known = rows.T
    scale = float(found @ known / (known @ known))
    return Lengths(
        len(rows),
        ConfidenceInterval(float(np.mean(found - known)), float(low[0]), float(high[0])),
        float(np.std(found - known, ddof=1)),
        ConfidenceInterval(scale, float(low[1]), float(high[1])),
    )


def _lengths(touches: Sequence[CrossTouch], pulp: Pulp) -> tuple[Array, Array]:
    """(n, n) m between contacts and between their crosses."""
    target = np.array([t.target_G for t in touches])
    contact = target + pulp.error
    found, known = (np.linalg.norm(p[:, None] - p[None], axis=2) for p in (contact, target))
    return found, known


def _length_rows(pairs: Sequence[tuple[Array, Array]]) -> Array:
    """(m, 2) m: found and known length of each pair of touches on different crosses."""
    out = []
    for found, known in pairs:
        i, j = np.triu_indices(len(found), 1)
        out.append(np.column_stack([found[i, j], known[i, j]])[known[i, j] > SAME_CROSS])
    return np.concatenate(out)


def _resampled(pairs: Sequence[tuple[Array, Array]], picks: Sequence[IntArray]) -> Array:
    """(k, 2): mean error m, and the factor of the known lengths by least squares, of resamples with
    at least two lengths; ``picks`` (resamples, n) of each finger's touches."""
    sums = np.zeros((4, len(picks[0])))
    for (found, known), pick in zip(pairs, picks, strict=True):
        i, j = np.triu_indices(pick.shape[1], 1)
        at = pick[:, i], pick[:, j]
        f, g = found[at], known[at]
        apart = g > SAME_CROSS
        f, g = f * apart, g * apart
        sums += [apart.sum(axis=1), (f - g).sum(axis=1), (f * g).sum(axis=1), (g * g).sum(axis=1)]
    count, error, product, square = sums[:, sums[0] > 1]
    return np.column_stack([error / count, product / square])


def return_test(
    touches: Mapping[str, Sequence[CrossTouch]], pulps: Mapping[str, Pulp]
) -> ConfidenceInterval | None:
    """m: how far the contact after five seconds out of view is from that before, on one cross."""
    apart = []
    for finger, some in touches.items():
        error = pulps[finger].error
        for k, touch in enumerate(some):
            before = [
                j for j, t in enumerate(some)
                if t.cue.target == touch.cue.target and t.end < touch.begin
            ]  # fmt: skip
            if touch.cue.how == "away" and before:
                apart.append(float(np.linalg.norm(error[k] - error[before[-1]])))
    return mean_interval(np.array(apart)) if apart else None


@dataclass(frozen=True)
class Closure:
    """Pinches: ``gap`` m between the pads of thumb and index when closed, and its sd."""

    count: int
    gap: ConfidenceInterval
    sd: ConfidenceInterval


def pinch_closure(
    tracks: Mapping[str, TipTrack], cued: Sequence[Cued], pulps: Mapping[str, Pulp]
) -> Closure | None:
    """None without a cue for it, or without pinches."""
    if not {"thumb", "index"} <= tracks.keys():
        return None
    gaps: list[float] = []
    for c in (c for c in cued if c.cue.what == "pinch"):
        thumb, index = (tracks[f].between(c.begin, c.end) for f in ("thumb", "index"))
        apart = np.linalg.norm(_pad(thumb, pulps.get("thumb")) - _pad(index, pulps.get("index")),
                               axis=1)  # fmt: skip
        known = thumb.known & index.known
        gaps += _closed(thumb.t[known], apart[known])
    if len(gaps) < 2:
        return None
    found = np.array(gaps)
    sd = sd_interval(float(np.std(found, ddof=1)), len(found) - 1)
    return Closure(len(found), mean_interval(found), sd)


def _pad(track: TipTrack, pulp: Pulp | None) -> Array:
    """(n, 3) m in G of the middle of the pad's surface."""
    offset = np.array([-PAD, 0.0, -track.radius])
    return track.p_G + track.R_GB @ (offset if pulp is None else offset + pulp.offset)


def _closed(t: Array, apart: Array) -> list[float]:
    """m: the distance at each closure."""
    if len(t) < SMOOTH:
        return []
    padded = np.pad(apart, SMOOTH // 2, mode="edge")
    smooth = np.median(np.lib.stride_tricks.sliding_window_view(padded, SMOOTH), axis=1)
    rate = (len(t) - 1) / max(float(t[-1] - t[0]), 1e-9)
    peaks, _ = find_peaks(-smooth, distance=max(1, round(APART * rate)), prominence=OPENED)
    return [float(v) for v in smooth[peaks]]


@dataclass(frozen=True)
class Stillness:
    """A finger at rest: ``noise`` m, RMS per axis about the mean; ``jitter`` m, RMS per axis of the
    change from one estimate to the next, divided by √2; over ``seconds``."""

    finger: str
    noise: float
    jitter: float
    seconds: float


def stillness(tracks: Mapping[str, TipTrack], cued: Sequence[Cued]) -> list[Stillness]:
    """For each finger, in the longest cue for it."""
    spans = [c for c in cued if c.cue.what == "still"]
    if not spans:
        return []
    longest = max(spans, key=lambda c: c.end - c.begin)
    out = []
    for finger, track in tracks.items():
        part = track.between(longest.begin, longest.end)
        p_G = part.p_G[part.known]
        if len(p_G) > 10:
            noise = float(np.sqrt(np.mean((p_G - p_G.mean(axis=0)) ** 2)))
            jitter = float(np.sqrt(np.mean(np.diff(p_G, axis=0) ** 2) / 2))
            out.append(Stillness(finger, noise, jitter, float(part.t[-1] - part.t[0])))
    return out
