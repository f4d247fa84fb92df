"""Curves of selected signals: a live buffer of the last seconds, or a whole recording."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import TypeVar

import numpy as np

from app.engines.snapshot import Snapshot
from app.viewmodels.signal_rows import (
    LEAD,
    LONGEST_STEP,
    GestureRows,
    Rows,
    hand_rows,
    image_rows,
    imu_rows,
    is_smoothed,
    status_rows,
    values_of,
)
from app.viewmodels.signals import Signal, SignalSource
from tracker.live.history import Timed
from tracker.messages import Array, IntArray
from tracker.session.holes import with_breaks

Curve = tuple[Array, Array]
"""t (n,) s and values (n,) in the signal's unit; NaN interrupts the line."""
FIRST_GESTURES = 2.0  # s for which strengths are computed when the first gesture is selected
T = TypeVar("T", bound=Timed)


FIRST_CAPACITY = 256


class TimedRows:
    """Rows (k,) at increasing instants, not older than ``span`` s before the last one."""

    def __init__(self, span: float) -> None:
        self._span = span
        self.clear()

    def clear(self) -> None:
        """Remove all rows."""
        self._t = np.empty(0)
        self._rows = np.empty((0, 0))
        self._begin = self._end = 0

    def __len__(self) -> int:
        return self._end - self._begin

    @property
    def t(self) -> Array:
        """(n,) s; valid until the next row is added."""
        return self._t[self._begin : self._end]

    @property
    def rows(self) -> Array:
        """(n, k); valid until the next row is added."""
        return self._rows[self._begin : self._end]

    def add(self, t: float, row: Array) -> None:
        """Add a row later than the last one."""
        self.extend(np.array([t]), row[None])

    def extend(self, t: Array, rows: Array) -> None:
        """Add several rows: t (m,) increasing and later than the last, rows (m, k)."""
        count = len(t)
        if count == 0:
            return
        if self._end + count > len(self._t):
            self._make_room(count, rows.shape[1])
        end = self._end + count
        self._t[self._end : end], self._rows[self._end : end] = t, rows
        self._end = end
        self._begin += int(np.searchsorted(self.t, t[-1] - self._span))

    def _make_room(self, count: int, width: int) -> None:
        """Move the remaining rows to the front; double the buffer if they fill half of it."""
        kept = len(self)
        t = np.empty(max(2 * (kept + count), FIRST_CAPACITY))
        rows = np.empty((len(t), width))
        if kept:
            t[:kept], rows[:kept] = self.t, self.rows
        self._t, self._rows = t, rows
        self._begin, self._end = 0, kept


def no_curve() -> Curve:
    """An empty curve."""
    return np.zeros(0), np.zeros(0)


class LiveCurves:
    """Curves of the selected signals over the last ``span`` s; times are the engine's.

    A newly selected signal starts with the last seconds that the engine still stores. Other signals
    are not computed.
    """

    def __init__(self, span: float) -> None:
        self._span = span
        self._chosen: dict[str, Signal] = {}
        self._taken: dict[str, TimedRows] = {}
        self._gestures: dict[str, GestureRows] = {}

    def clear(self) -> None:
        """Remove all values; the selection stays."""
        self._taken = {key: TimedRows(self._span) for key in self._chosen}
        self._gestures.clear()

    def choose(self, chosen: Iterable[Signal]) -> None:
        """Collect these signals."""
        self._chosen = {signal.key: signal for signal in chosen}
        before = self._taken
        self._taken = {key: before.get(key) or TimedRows(self._span) for key in self._chosen}
        sides = {s.side for s in self._chosen.values() if s.source is SignalSource.GESTURES}
        self._gestures = {side: rows for side, rows in self._gestures.items() if side in sides}

    def take(self, view: Snapshot) -> None:
        """Add the messages since the last call."""
        for hand in view.hands:
            by_source: dict[SignalSource, list[Signal]] = {}
            for signal in self._chosen.values():
                if signal.side == hand.setup.side:
                    by_source.setdefault(signal.source, []).append(signal)
            for source, chosen in by_source.items():
                self._take(hand, source, chosen)

    def _take(self, view: Snapshot, source: SignalSource, chosen: Sequence[Signal]) -> None:
        match source:
            case SignalSource.IMU:
                self._add(chosen, view.imu, imu_rows)
            case SignalSource.HAND:
                self._add(chosen, view.estimates, hand_rows)
            case SignalSource.IMAGES:
                self._add(chosen, view.images, image_rows)
            case SignalSource.STATUS:
                self._add(chosen, (view.status,) if view.status is not None else (), status_rows)
            case SignalSource.GESTURES:
                self._add_gestures(chosen, view)

    def _add(
        self,
        chosen: Sequence[Signal],
        messages: Sequence[T],
        rows_of: Callable[[Sequence[T]], Rows],
    ) -> None:
        """Add those of ``messages``, oldest first, that are new to each signal."""
        if not messages:
            return
        by_last: dict[float, list[Signal]] = {}
        for signal in chosen:
            by_last.setdefault(self._last(signal, messages[-1].t), []).append(signal)
        for last, signals in by_last.items():
            if messages[-1].t > last:
                first = bisect_right(messages, last - LEAD - 1e-9, key=lambda m: m.t) - 1
                self._append(signals, rows_of(messages[max(0, first) :]), last)

    def _add_gestures(self, chosen: Sequence[Signal], view: Snapshot) -> None:
        if not view.estimates:
            return
        side, now = view.setup.side, view.estimates[-1].t
        known = side in self._gestures
        source = self._gestures.setdefault(side, GestureRows(view.setup))
        last = min(self._last(signal, now) for signal in chosen)
        since = last if known and np.isfinite(last) else now - FIRST_GESTURES
        first = bisect_right(view.estimates, since, key=lambda e: e.t)
        rows = source.rows(view.estimates[first:])
        for signal in chosen:
            self._append([signal], rows, self._last(signal, now))

    def _last(self, signal: Signal, now: float) -> float:
        """The last instant of a curve (s), -inf if it is empty. A curve later than ``now`` (s) is
        cleared: the replay moved back."""
        taken = self._taken[signal.key]
        if len(taken) and taken.t[-1] > now:
            taken.clear()
        return float(taken.t[-1]) if len(taken) else -np.inf

    def _append(self, signals: Sequence[Signal], rows: Rows, last: float) -> None:
        """Append the rows after ``last`` (s); earlier ones provide neighbours for smoothing."""
        if len(rows.t) == 0:
            return
        for smoothed in (False, True):
            group = [signal for signal in signals if is_smoothed(signal) is smoothed]
            until = _known_until(rows) if smoothed else rows.t[-1]
            new = np.flatnonzero((rows.t > last) & (rows.t <= until))
            if group and len(new):
                self._extend(group, rows, new, last)

    def _extend(self, signals: Sequence[Signal], rows: Rows, new: IntArray, last: float) -> None:
        """Append the rows ``new`` (n,) to curves of one source that end at ``last`` (s)."""
        t = rows.t[new]
        values = np.stack([values_of(signal, rows)[new] for signal in signals], axis=1)
        begin = int(np.isfinite(last))
        if begin:  # for an interruption between the last instant and these
            t = np.concatenate([[last], t])
            values = np.concatenate([np.full((1, len(signals)), np.nan), values])
        t, values = with_breaks(t, values, LONGEST_STEP[signals[0].source])
        for k, signal in enumerate(signals):
            self._taken[signal.key].extend(t[begin:], values[begin:, k : k + 1])

    def curve(self, key: str) -> Curve:
        """Valid until the next `take`."""
        taken = self._taken.get(key)
        return (taken.t, taken.rows[:, 0]) if taken is not None and len(taken) else no_curve()


def _known_until(rows: Rows) -> float:
    """The last instant (s) whose smoothed value does not depend on later rows."""
    return float(min(rows.t[-1] - LEAD / 2, rows.t[-2])) if len(rows.t) > 1 else -np.inf


class RecordingCurves:
    """Curves of a whole recording; times are s from its start. ``rows`` are by side and source."""

    def __init__(self, rows: Mapping[tuple[str, SignalSource], Rows]) -> None:
        self._rows = rows
        self._curves: dict[str, Curve] = {}

    @property
    def figures(self) -> Collection[str]:
        """Names of the status values in the recording."""
        found = (rows for (_, source), rows in self._rows.items() if source is SignalSource.STATUS)
        return dict.fromkeys(name for rows in found for name in rows.columns)

    def curve(self, signal: Signal) -> Curve:
        """The curve of a signal; computed once."""
        if signal.key not in self._curves:
            rows = self._rows.get((signal.side, signal.source))
            self._curves[signal.key] = (
                with_breaks(rows.t, values_of(signal, rows), LONGEST_STEP[signal.source])
                if rows is not None and len(rows.t)
                else no_curve()
            )
        return self._curves[signal.key]
