"""Angles and distances as numbers: current values, and statistics of the last seconds or of a
recording."""

from __future__ import annotations

from bisect import bisect_left
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.engines.engine import EngineSetup
from app.viewmodels.names import display_name
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity
from tracker.session.motion import (
    APERTURE,
    Measure,
    Pair,
    Take,
    Units,
    curve,
    distance,
    measures,
    pair_name,
    table,
    take_of,
)

RECENT = 10.0  # s of live data
STEP = 0.04  # minimum s between two values; well below the shortest hole


@dataclass(frozen=True)
class MotionRow:
    """One row: value and limits in the unit; ``share``, the position within the range, NaN without
    limits; the state's `Validity`."""

    name: str
    unit: str
    value: float
    share: float
    state: int


def shown_name(name: str) -> str:
    """The name of an angle or a distance, in the user's language."""
    return " - ".join(display_name(part) for part in name.split(" - "))


class MotionModel:
    """Measurements of one hand of the open engine. ``pairs`` are points whose distance is
    measured."""

    def __init__(self, setup: EngineSetup) -> None:
        hand = setup.hand
        self.angle_names, self.limits = hand.joint_names, hand.angle_limits
        self.point_names = setup.glove.keypoint_names(hand)
        there = all(name in self.point_names for name in APERTURE)
        self.pairs: list[Pair] = [APERTURE] if there else []
        self.units = Units()
        self.take: Take | None = None
        self._latest: deque[Estimate] = deque()

    def choose_units(self, angle_unit: str) -> None:
        """``deg`` or ``rad``."""
        self.units = Units(degrees=angle_unit == "deg")

    def use_recording(self, take: object) -> bool:
        """Measure a whole recording; False without one, or if it is of another hand."""
        if isinstance(take, Take) and take.angle_names == self.angle_names:
            self.take = take
        return self.take is not None

    def add_pair(self, pair: Pair) -> bool:
        """Measure another distance; False if it is invalid or is measured already."""
        known = {frozenset(p) for p in self.pairs}
        if pair[0] == pair[1] or frozenset(pair) in known:
            return False
        self.pairs.append(pair)
        return True

    def remove_pair(self, row: int) -> Pair:
        """Remove the distance of a table row and return it."""
        return self.pairs.pop(row - len(self.angle_names))

    @property
    def names(self) -> list[str]:
        """Names of all rows: angles, then distances."""
        return [*self.angle_names, *(pair_name(p) for p in self.pairs)]

    def is_angle(self, row: int) -> bool:
        return row < len(self.angle_names)

    def feed(self, estimates: Sequence[Estimate]) -> None:
        """Add new estimates, oldest first, at intervals of at least `STEP`."""
        if not estimates:
            return
        now = estimates[-1].t
        if self._latest and now < self._latest[-1].t:
            self._latest.clear()  # the replay moved back
        due = self._latest[-1].t + STEP if self._latest else -np.inf
        for estimate in estimates[bisect_left(estimates, due - 1e-9, key=lambda e: e.t) :]:
            if estimate.t >= due - 1e-9:
                self._latest.append(estimate)
                due = estimate.t + STEP
        while now - self._latest[0].t > RECENT:
            self._latest.popleft()

    def rows(self, estimate: Estimate) -> list[MotionRow]:
        """The current values."""
        out = []
        for j, name in enumerate(self.angle_names):
            low, high = self.limits[j]
            value, state = float(estimate.angles[j]), int(estimate.angle_state[j])
            share = (value - low) / (high - low) if high > low else np.nan
            unit = "°" if self.units.degrees else "rad"
            out.append(MotionRow(name, unit, self.units.angle(value), float(share), state))
        located = estimate.tracking != Tracking.LOST
        for pair in self.pairs:
            a, b = (self.point_names.index(n) for n in pair)
            away = float(np.linalg.norm(estimate.keypoints[a] - estimate.keypoints[b]))
            state = int(min(estimate.keypoint_state[a], estimate.keypoint_state[b]))
            state = state if located or np.isfinite(away) else int(Validity.LOST)
            out.append(MotionRow(pair_name(pair), "mm", 1000 * away, np.nan, state))
        return out

    def _of(self, take: Take, row: int) -> tuple[Array, IntArray]:
        """Values (N,) and their states (N,)."""
        if self.is_angle(row):
            return take.angles[:, row], take.angle_state[:, row]
        away, _, state = distance(take, self.pairs[row - len(self.angle_names)])
        return away, state

    def curve(self, row: int) -> tuple[Array, Array]:
        """t (n,) s and values (n,) in the unit: of the whole recording once it is read, else of the
        last seconds, up to 0; NaN where lost and in holes."""
        take = self.take or self._recent()
        if take is None:
            return np.empty(0), np.empty(0)
        t, values = curve(take, *self._of(take, row))
        if self.is_angle(row):
            return t, np.rad2deg(values) if self.units.degrees else values
        return t, 1000 * values

    def _recent(self) -> Take | None:
        if not self._latest:
            return None
        now = self._latest[-1].t
        return take_of(list(self._latest), self.angle_names, self.limits, self.point_names, now)

    def measures(self) -> list[Measure]:
        """Statistics of the whole recording once it is read, else of the last seconds."""
        take = self.take or self._recent()
        return [] if take is None else measures(take, self.pairs)

    def figures(self) -> tuple[list[list[float]], list[int]]:
        """Minimum, maximum, range and peak speed of each row as written, and their digits."""
        out, digits = [], []
        for m in self.measures():
            values = (m.least, m.greatest, m.range, m.fastest)
            out.append([self.units.of(v, m.is_angle) for v in values])
            digits.append(2 if self.units.name(m.is_angle) == "rad" else 1)
        return out, digits

    def table(self, separator: str) -> str:
        """The table as text."""
        return table(self.measures(), self.units, separator)
