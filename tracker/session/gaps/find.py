"""Finds the intervals in which keypoints of a hand are not measured."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tracker.base.clock import NS
from tracker.hand.names import CHAINS
from tracker.messages import Array, IntArray, Validity
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.gaps.cause import CauseFinder
from tracker.session.holes import LONGEST_FILLED
from tracker.session.reader import SessionReader

HOLE, LOST, INFERRED = "hole", "lost", "inferred"
KINDS = (HOLE, LOST, INFERRED)
"""No estimates; estimates without a position; positions that no sensor measured lately."""
INFERRED_LIMIT = 0.5
"""s that a keypoint may be inferred before that counts as a gap."""
HAND, WRIST = "hand", "wrist"
_ROUNDING = 1e-9  # s


@dataclass(frozen=True)
class Gap:
    """An interval from ``start`` to ``stop``, s from the session's start, in which ``keypoints`` of
    a ``part`` (hand, wrist or a finger) of the hand of ``side`` are not measured; the stamps (ns
    since 1970) are those of the estimates before and after it. ``fillable``: both exist."""

    number: int
    side: str
    part: str
    keypoints: tuple[str, ...]
    kind: str
    cause: str
    start: float
    stop: float
    start_ns: int
    stop_ns: int
    fillable: bool

    @property
    def length(self) -> float:
        """s"""
        return self.stop - self.start


class Interval(NamedTuple):
    """Rows of the estimates before and after; -1 and N without one."""

    kind: str
    before: int
    after: int


class _Part(NamedTuple):
    interval: Interval
    part: str
    keypoints: tuple[str, ...]


def session_gaps(
    path: Path,
    limit: float = INFERRED_LIMIT,
    watch: Callable[[float], None] = lambda share: None,
) -> list[Gap]:
    """Gaps of all hands of a session by start, numbered from 1.

    ``limit``: *inferred* intervals up to this length (s) are not listed. ``watch`` receives the
    share that has been read, and may raise to stop it. Raises FileError if the session has no
    estimates.
    """
    with SessionReader(path) as reader:
        sides = reader.sides or ("",)
    found: list[Gap] = []
    for n, side in enumerate(sides):
        with SessionReader(path, watch=_watch_part(watch, n, len(sides)), side=side) as reader:
            found += hand_gaps(reader, recorded_series(reader, segments=False), limit)
    ordered = sorted(found, key=lambda g: (g.start, g.side, KINDS.index(g.kind), g.part))
    return [_numbered(gap, n) for n, gap in enumerate(ordered, 1)]


def _watch_part(watch: Callable[[float], None], n: int, of: int) -> Callable[[float], None]:
    return lambda share: watch((n + share) / of)


def _numbered(gap: Gap, number: int) -> Gap:
    return Gap(number, *(getattr(gap, f) for f in list(Gap.__dataclass_fields__)[1:]))


def hand_gaps(reader: SessionReader, hand: EstimateSeries, limit: float) -> list[Gap]:
    """Gaps of the reader's hand with their causes, without numbers."""
    first, last = reader.span_ns
    t = (hand.stamp_ns - first) / NS
    ends = (0.0, reader.duration)
    names = reader.info.keypoint_names
    causes = CauseFinder(reader)
    out = []
    for part in _parts(t, hand.state, names, limit, ends):
        interval = part.interval
        before, after = interval.before, interval.after
        start_ns = int(hand.stamp_ns[before]) if before >= 0 else first
        stop_ns = int(hand.stamp_ns[after]) if after < len(t) else last
        unsensed = not (hand.state[:, _rows(names, part.keypoints)] == Validity.MEASURED).any()
        cause = causes.of(part.keypoints, interval.kind, (start_ns, stop_ns), unsensed)
        if interval.kind == INFERRED and _is_filled(reader, part.keypoints, start_ns, stop_ns):
            continue
        out.append(
            Gap(
                0, reader.info.side, part.part, part.keypoints, interval.kind, cause,
                (start_ns - first) / NS, (stop_ns - first) / NS, start_ns, stop_ns,
                _is_fillable(interval, hand.state, _rows(names, part.keypoints)),
            )
        )  # fmt: skip
    return out


def _is_filled(
    reader: SessionReader, keypoints: tuple[str, ...], start_ns: int, stop_ns: int
) -> bool:
    """Returns whether an edit interpolated all inferred values there."""
    return any(
        f.side == reader.info.side
        and f.start_ns <= start_ns
        and stop_ns <= f.stop_ns
        and set(keypoints) <= set(f.keypoints)
        for edit in reader.edits
        for f in edit.filled
    )


def _rows(names: Sequence[str], wanted: Sequence[str]) -> list[int]:
    return [names.index(name) for name in wanted]


def _is_fillable(interval: Interval, state: IntArray, rows: list[int]) -> bool:
    """Whether there is something to interpolate between."""
    if interval.before < 0 or interval.after >= len(state):
        return False
    if interval.kind != INFERRED:
        return True
    good = (state[:, rows] == Validity.MEASURED).all(axis=1)
    return bool(good[: interval.before + 1].any() and good[interval.after :].any())


def _parts(
    t: Array, state: IntArray, names: Sequence[str], limit: float, ends: tuple[float, float]
) -> Iterator[_Part]:
    """Intervals of keypoints; those that are the same for a whole finger or hand are combined."""
    of: dict[Interval, list[str]] = {}
    for k, name in enumerate(names):
        for interval in intervals(t, state[:, k], limit, ends):
            of.setdefault(interval, []).append(name)
    sensed = {n for k, n in enumerate(names) if (state[:, k] == Validity.MEASURED).any()}
    for interval, missing in of.items():
        whole = interval.kind == INFERRED and len(sensed) > 0 and sensed <= set(missing)
        if len(missing) == len(names) or whole:
            yield _Part(interval, HAND, tuple(missing))
            continue
        for part, group in itertools.groupby(missing, key=_part_of):
            yield _Part(interval, part, tuple(group))


def _part_of(keypoint: str) -> str:
    finger = keypoint.split("_")[0]
    return finger if finger in CHAINS else WRIST


def intervals(
    t: Array, state: IntArray, limit: float, ends: tuple[float, float]
) -> Iterator[Interval]:
    """The intervals of one keypoint with states (N,) at increasing times ``t`` (N,) s; the session
    lasts from ``ends[0]`` to ``ends[1]``. A keypoint that is never measured is inferred
    throughout."""
    n = len(t)
    known = np.flatnonzero(state != Validity.LOST)
    if not len(known):
        yield Interval(LOST, -1, n)
        return
    bounds = np.r_[-1, known, n]
    at = np.r_[ends[0], t, ends[1]][bounds + 1]
    far = np.diff(at) > LONGEST_FILLED + _ROUNDING
    lost = np.diff(bounds) > 1
    for i in np.flatnonzero(lost | far):
        yield Interval(LOST if lost[i] else HOLE, int(bounds[i]), int(bounds[i + 1]))
    if not (state == Validity.MEASURED).any():
        yield Interval(INFERRED, -1, n)
        return
    yield from _inferred(t, state, limit)


def _inferred(t: Array, state: IntArray, limit: float) -> Iterator[Interval]:
    """Inferred stretches without a hole, from one measured row to the next."""
    n = len(t)
    is_inferred = state == Validity.INFERRED
    apart = np.r_[True, np.diff(t) > LONGEST_FILLED + _ROUNDING]
    begins = np.flatnonzero(is_inferred & (apart | ~np.r_[False, is_inferred[:-1]]))
    for i in begins:
        after = np.flatnonzero(~is_inferred[i:] | np.r_[False, apart[i + 1 :]])
        j = int(i + after[0]) if len(after) else n  # the first row after it
        near_before = i > 0 and not apart[i] and state[i - 1] == Validity.MEASURED
        near_after = j < n and not apart[j] and state[j] == Validity.MEASURED
        before, behind = int(i - near_before), int(j if near_after else j - 1)
        if t[behind] - t[before] > limit:
            yield Interval(INFERRED, before, behind)
