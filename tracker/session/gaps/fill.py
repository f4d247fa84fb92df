"""Fills selected gaps of a hand: creates the estimates that replace those of a session."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.base.clock import NS
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity
from tracker.session.edits import Filled
from tracker.session.export.series import EstimateSeries
from tracker.session.gaps.find import HOLE, INFERRED, LOST, Gap
from tracker.session.gaps.interpolate import (
    SPEED_OVER,
    Mask,
    RecordedMotion,
    SessionSkeleton,
    fill_motion,
)
from tracker.session.gaps.merge import merged
from tracker.session.gaps.methods import LINEAR
from tracker.session.gaps.spread import Spread, grown
from tracker.session.holes import LONGEST_FILLED
from tracker.session.reader import SessionReader

MAX_GAP = 0.2
"""s up to which a gap is filled unless a longer limit is given."""
_LATEST = 1.0  # s that an estimate may have been written after its instant
_ROUNDING = 1e-9  # s
TOO_LONG, NO_ENDS = "too long", "nothing before or after it"
NOT_KNOWN = "its ends or the sensors are not known"


@dataclass(frozen=True)
class FillOptions:
    """``method`` of `METHODS`; gaps of ``kinds`` up to ``max_gap`` s."""

    method: str = LINEAR
    max_gap: float = MAX_GAP
    kinds: tuple[str, ...] = (HOLE, LOST)


class Left(NamedTuple):
    """A gap that was not filled, and why."""

    gap: Gap
    why: str


@dataclass(eq=False)
class HandFill:
    """The changes to one hand: the new estimates between the stamps of ``spans`` (ns), in order,
    the unchanged ones after each span, and the filled gaps."""

    estimates: list[Estimate] = field(default_factory=list)
    afterwards: list[Estimate] = field(default_factory=list)
    spans: list[tuple[int, int]] = field(default_factory=list)
    filled: list[Filled] = field(default_factory=list)
    left: list[Left] = field(default_factory=list)


def choose(gaps: Sequence[Gap], options: FillOptions) -> tuple[list[Gap], list[Left]]:
    """The gaps to fill, and those of the selected kinds that are not filled."""
    wanted = [gap for gap in gaps if gap.kind in options.kinds]
    left = [Left(g, NO_ENDS) for g in wanted if not g.fillable]
    left += [Left(g, TOO_LONG) for g in wanted if g.fillable and g.length > options.max_gap]
    return [g for g in wanted if g.fillable and g.length <= options.max_gap + _ROUNDING], left


def fill_hand(
    reader: SessionReader,
    hand: EstimateSeries,
    gaps: Sequence[Gap],
    method: str = LINEAR,
    shape: EstimateSeries | None = None,
    watch: Callable[[float], None] = lambda share: None,
) -> HandFill:
    """Fill ``gaps`` of the reader's hand, whose estimates are ``hand``.

    ``shape``: another tracking of the same session, whose course the filled values follow.
    ``watch`` receives the share that is done, and may raise to stop.
    """
    hand = hand.rows(np.flatnonzero(np.diff(hand.stamp_ns, prepend=hand.stamp_ns[0] - 1) > 0))
    work = _HandWork(reader, hand, method, shape)
    out = HandFill()
    at = [(gap, work.rows_of(gap)) for gap in gaps]
    spans = merged(rows for _, rows in at)
    for n, span in enumerate(spans):
        watch(n / len(spans))
        inside = [(g, r) for g, r in at if span[0] <= r[0] and r[1] <= span[1]]
        work.fill_span(span, inside, out)
    return out


class _Grid(NamedTuple):
    """Rows of a span and next to it: their stamps (n,) ns and the rows of their estimates, -1 for
    new ones."""

    stamp_ns: IntArray
    row: IntArray


class _HandWork:
    def __init__(
        self, reader: SessionReader, hand: EstimateSeries, method: str, shape: EstimateSeries | None
    ) -> None:
        self._reader, self._hand, self._method, self._shape = reader, hand, method, shape
        self._of = SessionSkeleton(reader.info)
        self._names = reader.info.keypoint_names
        self._t = (hand.stamp_ns - hand.stamp_ns[0]) / NS
        self._step_ns = int(np.median(np.diff(hand.stamp_ns))) if len(hand.stamp_ns) > 1 else NS
        motion = RecordedMotion(self._t, hand.keypoints, hand.q, hand.angles)
        course = None if shape is None else _sampled(shape, hand.stamp_ns)
        self._spread = Spread(motion, hand.state != Validity.LOST, self._of, method, course)

    def rows_of(self, gap: Gap) -> tuple[int, int]:
        """The rows before and after a gap; for an inferred gap, the measured rows."""
        stamps = self._hand.stamp_ns
        before, after = (int(np.searchsorted(stamps, s)) for s in (gap.start_ns, gap.stop_ns))
        if gap.kind != INFERRED:
            return before, after
        columns = self._columns(gap)
        good = (self._hand.state[:, columns] == Validity.MEASURED).all(axis=1)
        first, last = np.flatnonzero(good[: before + 1]), np.flatnonzero(good[after:])
        return int(first[-1]) if len(first) else before, after + int(last[0]) if len(
            last
        ) else after

    def _columns(self, gap: Gap) -> list[int]:
        return [self._names.index(name) for name in gap.keypoints]

    def fill_span(
        self,
        span: tuple[int, int],
        gaps: Sequence[tuple[Gap, tuple[int, int]]],
        out: HandFill,
    ) -> None:
        """Fills gaps within one span, given with their rows."""
        grid = self._grid(span)
        motion, states, angle_states = self._motion(grid)
        at = np.full(len(self._t), -1)
        at[grid.row[grid.row >= 0]] = np.flatnonzero(grid.row >= 0)
        missing: dict[int, list[tuple[int, int]]] = {}
        free = np.zeros(motion.angles.shape, bool)
        for gap, (a, b) in gaps:
            rows = int(at[a]), int(at[b])
            inside = slice(rows[0] + 1, rows[1])
            for k in self._columns(gap):
                missing.setdefault(k, []).append(rows)
            allowed = Validity.INFERRED if gap.kind == INFERRED else Validity.LOST
            free[inside] |= angle_states[inside] <= allowed
        shape = None if self._shape is None else _sampled(self._shape, grid.stamp_ns)
        points, angles = fill_motion(motion, self._of, missing, free, self._method, shape)
        found = _FilledSpan(grid, motion, states, angle_states, points, angles)
        records = [(gap, (int(at[a]), int(at[b]))) for gap, (a, b) in gaps]
        done = [self._record(gap, rows, found, out) for gap, rows in records]
        if not any(done):
            return
        sd = self._deviations(found, [r for r, d in zip(records, done, strict=True) if d])
        self._put(found, sd, (int(at[span[0]]), int(at[span[1]])), out)

    def _grid(self, span: tuple[int, int]) -> _Grid:
        """Returns the rows of a span, those next to it for its speed, and new ones in holes."""
        a, b = span
        low = int(np.searchsorted(self._t, self._t[a] - SPEED_OVER - _ROUNDING))
        high = int(np.searchsorted(self._t, self._t[b] + SPEED_OVER + _ROUNDING, side="right"))
        rows = np.arange(low, high)
        stamps = [self._hand.stamp_ns[rows]]
        marks = [rows]
        for i in range(a, b):
            first, last = int(self._hand.stamp_ns[i]), int(self._hand.stamp_ns[i + 1])
            if last - first > (LONGEST_FILLED + _ROUNDING) * NS:
                count = max(round((last - first) / self._step_ns), 2)
                new = first + np.round(np.arange(1, count) * (last - first) / count)
                stamps.append(new.astype(np.int64))
                marks.append(np.full(count - 1, -1))
        stamp, row = np.concatenate(stamps), np.concatenate(marks)
        order = np.argsort(stamp, kind="stable")
        return _Grid(stamp[order], row[order])

    def _motion(self, grid: _Grid) -> tuple[RecordedMotion, IntArray, IntArray]:
        """The hand on a grid, and the states of keypoints and angles; new rows are lost."""
        hand, new = self._hand, grid.row < 0
        parts = [v[grid.row].astype(float) for v in (hand.keypoints, hand.q, hand.angles)]
        for values in parts:
            values[new] = np.nan
        states = [v[grid.row].astype(np.int64) for v in (hand.state, hand.angle_state)]
        for values in states:
            values[new] = Validity.LOST
        t = (grid.stamp_ns - hand.stamp_ns[0]) / NS
        return RecordedMotion(t, *parts), states[0], states[1]

    def _record(self, gap: Gap, rows: tuple[int, int], found: _FilledSpan, out: HandFill) -> bool:
        """Stores the filled part of a gap; returns False if nothing was filled."""
        inside = slice(rows[0] + 1, rows[1])
        columns = self._columns(gap)
        full = [k for k in columns if found.points[inside, k].all() and rows[1] - rows[0] > 1]
        if not full:
            out.left.append(Left(gap, NOT_KNOWN))
            return False
        segments = {self._of.segment_of[k] for k in full if k in self._of.origin}
        own = {c for s in segments for c in self._of.angles_of(s)}
        joints = [j for j in sorted(own) if found.angles[inside, j].any()]
        hand = self._reader.info.hand
        out.filled.append(
            Filled(
                gap.side,
                tuple(self._names[k] for k in full),
                tuple(hand.joint_names[j] for j in joints),
                int(found.grid.stamp_ns[rows[0]]),
                int(found.grid.stamp_ns[rows[1]]),
                gap.kind,
                gap.cause,
            )
        )
        return True

    def _deviations(self, found: _FilledSpan, gaps: Sequence[tuple[Gap, tuple[int, int]]]) -> Array:
        """Returns (n, K) m of filled values; NaN elsewhere."""
        sd = np.full(found.points.shape, np.nan)
        own = self._estimates(found.grid)
        for gap, (a, b) in gaps:
            columns = self._columns(gap)
            missing = np.flatnonzero(found.angles[a + 1 : b].any(axis=0)).tolist()
            length = float(found.motion.t[b] - found.motion.t[a])
            middle = self._spread.middle(columns, missing, length)
            share = (found.motion.t[a + 1 : b] - found.motion.t[a]) / length
            ends = [_sd_at(own.get(int(found.grid.stamp_ns[i])), columns) for i in (a, b)]
            values = grown(share, ends[0], ends[1], middle)
            there = sd[a + 1 : b, columns]
            sd[a + 1 : b, columns] = np.fmax(there, values)
        sd[~found.points] = np.nan
        return sd

    def _estimates(self, grid: _Grid) -> dict[int, Estimate]:
        """The estimates of a grid's rows, by stamp (ns)."""
        anchor = self._reader.anchor
        start, stop = (anchor.monotonic(int(grid.stamp_ns[i])) for i in (0, -1))
        found = self._reader.messages((Estimate,), start - _ROUNDING, stop + _LATEST)
        return {anchor.wall(m.t): m for m in found if isinstance(m, Estimate)}

    def _put(self, found: _FilledSpan, sd: Array, span: tuple[int, int], out: HandFill) -> None:
        """Stores the estimates between the first and the last row of a span."""
        own = self._estimates(found.grid)
        anchor = self._reader.anchor
        for i in range(span[0] + 1, span[1]):
            stamp = int(found.grid.stamp_ns[i])
            before = own.get(stamp) or _lost_estimate(self._reader, anchor.monotonic(stamp))
            out.estimates.append(self._changed(before, found, i, sd[i]))
        last = int(found.grid.stamp_ns[span[1]])
        if last in own:
            out.afterwards.append(own[last])
        out.spans.append((int(found.grid.stamp_ns[span[0]]), last))

    def _changed(self, e: Estimate, found: _FilledSpan, i: int, sd: Array) -> Estimate:
        points, angles, motion = found.points[i], found.angles[i], found.motion
        R, p = e.segment_R.copy(), e.segment_p.copy()
        for segment, k in enumerate(self._of.origin):
            if points[k]:
                p[segment] = motion.keypoints[i, k]
                R[segment] = Rotation.from_quat(motion.q[i, k]).as_matrix()
        root = self._of.origin[self._of.hand.root]
        return replace(
            e,
            tracking=Tracking.COASTING if points[root] else e.tracking,
            keypoints=np.where(points[:, None], motion.keypoints[i], e.keypoints),
            keypoint_q=np.where(points[:, None], motion.q[i], e.keypoint_q),
            keypoint_state=np.where(points, int(Validity.INFERRED), e.keypoint_state),
            keypoint_sd=np.where(points, sd, e.keypoint_sd),
            angles=np.where(angles, motion.angles[i], e.angles),
            angle_state=np.where(angles, int(Validity.INFERRED), e.angle_state),
            segment_R=R,
            segment_p=p,
        )


class _FilledSpan(NamedTuple):
    """A span after filling: ``points`` (n, K) and ``angles`` (n, J) were filled."""

    grid: _Grid
    motion: RecordedMotion
    states: IntArray
    angle_states: IntArray
    points: Mask
    angles: Mask


def _sd_at(estimate: Estimate | None, columns: Sequence[int]) -> Array:
    if estimate is None:
        return np.full(len(columns), np.nan)
    return np.asarray(estimate.keypoint_sd[list(columns)])


def _lost_estimate(reader: SessionReader, t: float) -> Estimate:
    """An estimate with all values lost."""
    info = reader.info
    k, j, s = len(info.keypoint_names), len(info.hand.joint_names), len(info.hand.segments)
    return Estimate(
        t=t,
        tracking=Tracking.LOST,
        keypoints=np.full((k, 3), np.nan),
        keypoint_q=np.full((k, 4), np.nan),
        keypoint_state=np.full(k, int(Validity.LOST)),
        keypoint_sd=np.full(k, np.nan),
        angles=np.full(j, np.nan),
        angle_state=np.full(j, int(Validity.LOST)),
        segment_R=np.full((s, 3, 3), np.nan),
        segment_p=np.full((s, 3), np.nan),
    )


def _sampled(hand: EstimateSeries, stamp_ns: IntArray) -> RecordedMotion:
    """Another tracking at the stamps (n,): interpolated linearly, NaN where it is lost or has a
    hole."""
    own = hand.rows(np.flatnonzero(np.diff(hand.stamp_ns, prepend=hand.stamp_ns[0] - 1) > 0))
    after = np.clip(np.searchsorted(own.stamp_ns, stamp_ns), 0, len(own.stamp_ns) - 1)
    exact = own.stamp_ns[after] == stamp_ns
    before = np.where(exact, after, np.maximum(after - 1, 0))
    step = own.stamp_ns[after] - own.stamp_ns[before]
    share = np.where(step > 0, (stamp_ns - own.stamp_ns[before]) / np.maximum(step, 1), 0.0)
    known = exact | ((step > 0) & (step <= (LONGEST_FILLED + _ROUNDING) * NS) & (share <= 1))
    parts = []
    for values in (own.keypoints, own.q, own.angles):
        u = share.reshape(-1, *[1] * (values.ndim - 1))
        a, b = values[before], values[after]
        if values is own.q:
            b = np.where((a * b).sum(axis=-1, keepdims=True) < 0, -b, b)
        mixed = np.where(u == 0, a, (1 - u) * a + u * b)
        mixed[~known] = np.nan
        parts.append(mixed)
    q = parts[1] / np.linalg.norm(parts[1], axis=-1, keepdims=True)
    return RecordedMotion((stamp_ns - own.stamp_ns[0]) / NS, parts[0], q, parts[2])
