"""Detects that a camera was knocked: all markers suddenly appear displaced.

One image is not enough: its stamp may be wrong, and then the hand's own
motion explains the change. A jump is reported when

- the images before agreed with the filter's prediction, which knows the hand's motion by the IMUs;
- the time stamps of packets and images were correct before, during and after it;
- neither positions nor velocities of the markers at a nearby instant explain it; and
- the next images show the markers displaced by the same vector from their previous
  course, whatever the filter estimates meanwhile.

The time stamps of an overloaded computer are unreliable: it takes images from a camera late and
unevenly, and stamps them late. At the speed of a hand, 50 ms displace all markers by dozens of
pixels.
"""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median
from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector
from tracker.messages import Array, FrameResult, Tracking


@dataclass(frozen=True)
class TrustParams:
    """Times in s."""

    packet_gap: float = 0.035  # without a packet
    late: float = 0.05  # arrival after the instant, more than the least of late
    uneven: tuple[float, float] = (0.5, 1.8)  # of the usual interval between images
    images: int = 15  # over which that is taken
    regain: float = 1.0  # without any of these, before stamps are used again


class StampTrust:
    """Receives all packets and images; ``since`` is the time (s) at which stamps were last
    doubtful."""

    def __init__(self, params: TrustParams | None = None) -> None:
        self._params = params or TrustParams()
        self._packet = self._image = float("nan")
        self._intervals: deque[float] = deque(maxlen=self._params.images)
        self._packet_lags, self._image_lags = _Lags(), _Lags()
        self.since = float("-inf")

    def packet(self, t: float, t_arrival: float) -> None:
        """Adds a packet sampled at ``t`` (s)."""
        p = self._params
        if t - self._packet > p.packet_gap or self._packet_lags.excess(t, t_arrival) > p.late:
            self._doubt(t)
        self._packet = t

    def image(self, t: float, t_arrival: float) -> None:
        """Adds an image exposed at ``t`` (s)."""
        interval, self._image = t - self._image, t
        late = self._image_lags.excess(t, t_arrival) > self._params.late
        if late or self._is_uneven(interval):
            self._doubt(t)
        if interval > 0:
            self._intervals.append(interval)

    def is_given(self, t: float) -> bool:
        """Whether stamps have been correct for a while at ``t`` (s)."""
        return t - self.since >= self._params.regain

    def _is_uneven(self, interval: float) -> bool:
        if len(self._intervals) < 3:
            return False
        low, high = self._params.uneven
        usual = median(self._intervals)
        return not low * usual <= interval <= high * usual

    def _doubt(self, t: float) -> None:
        self.since = max(self.since, t)


class _Lags:
    """The lag of arrivals beyond the least lag of the last seconds."""

    KEPT = 3.0  # s

    def __init__(self) -> None:
        self._lags: deque[tuple[float, float]] = deque()  # rising lags

    def excess(self, t: float, t_arrival: float) -> float:
        lag = t_arrival - t
        while self._lags and self._lags[-1][1] >= lag:
            self._lags.pop()
        self._lags.append((t, lag))
        while self._lags[0][0] < t - self.KEPT:
            self._lags.popleft()
        return lag - self._lags[0][1]


EXPECTED = 6  # images over which the markers' velocity is measured


@dataclass(frozen=True)
class JumpParams:
    """Limits. Pixels are for a focal length of 640 and grow with it."""

    jump_px: float = 5.0
    jump_markers: int = 5
    jump_gap: float = 0.15  # s since the last image that agreed
    usual_gap: float = 0.07  # s without an image that agreed, up to which ``jump_px`` applies
    ahead: float = 0.015  # s between the last packet and an image, at most
    settle: float = 0.3  # s after that, and after markers that did not agree
    late: float = 0.4  # s by which an image may be older or newer than its stamp
    confirm: int = 3  # images after it that must show it
    within: float = 0.35  # s in which they arrive
    persists: float = 0.5  # least share of the jump that they must show


class Jump(NamedTuple):
    """Displacement (px) of both images ``together``, and ``apart`` from each other."""

    apart: float
    together: float


class _Pending(NamedTuple):
    """A jump (4,) px at ``t`` (s) from the course ``at`` (4,) px, (4,) px/s; images that agreed."""

    t: float
    jump: Array
    at: Array
    velocity: Array
    confirmed: int


class JumpWatch:
    """Receives every packet and image before the filter and every result after it."""

    def __init__(self, focal_px: float, params: JumpParams | None = None) -> None:
        self._scale, self._params = focal_px / 640.0, params or JumpParams()
        self._trust = StampTrust()
        self._agreed = -np.inf  # time when markers last were where they were expected
        self._agreed_since = np.inf
        self._packet = self._ahead = -np.inf
        self._expected: deque[tuple[float, Array]] = deque()
        self._pending: _Pending | None = None

    def packet(self, t: float, t_arrival: float) -> None:
        """Adds a packet of the glove, sampled at ``t`` (s)."""
        self._trust.packet(t, t_arrival)
        self._packet = max(t, self._packet)

    def image(self, t: float, t_arrival: float) -> None:
        """An image, exposed at ``t`` (s)."""
        self._trust.image(t, t_arrival)

    def check(self, result: FrameResult) -> Jump | None:
        """Compares an image with the filter's prediction; returns a jump that is now certain."""
        p = self._params
        if result.t > self._packet + p.ahead:
            self._ahead = result.t
        if not self._trust.is_given(result.t) or result.t < self._ahead + p.settle:
            self._agreed, self._pending = -np.inf, None
            return None
        if result.tracking != Tracking.TRACKING:
            self._expected.clear()
            self._pending = None
            return None
        both, residual = median_residual(result.residual)
        places = np.hstack((result.predicted_left, result.predicted_right))
        before = list(self._expected)
        self._remember(result.t, places)
        if both < p.jump_markers:
            return None
        if self._pending is not None:
            return self._confirm(self._pending, result, places)
        self._look(result.t, residual, before, places)
        return None

    def _remember(self, t: float, places: Array) -> None:
        self._expected.append((t, places))
        while self._expected[0][0] < t - self._params.late - 0.1:
            self._expected.popleft()

    def _look(
        self, t: float, residual: Array, before: Sequence[tuple[float, Array]], places: Array
    ) -> None:
        """Stores a jump that begins with this image; the next images must confirm it."""
        p = self._params
        apart, together = sizes(residual, self._scale)
        # Carried on for longer, the hand itself is farther from where it was expected, in both
        # images alike: a double integral, so that limit grows with the square of the gap.
        gap = max((t - self._agreed) / p.usual_gap, 1.0)
        if max(apart, together) < p.jump_px:
            if t - self._agreed > p.jump_gap:
                self._agreed_since = t
            self._agreed = t
        elif apart < p.jump_px and together < p.jump_px * gap**2:
            return
        elif t - self._agreed <= p.jump_gap:
            settled = self._agreed - self._agreed_since >= p.settle
            self._agreed = -np.inf  # one jump is reported once
            # settled: before, the hand's velocity is hardly known
            is_new = apart > together or not self._is_of_another_instant(residual, before, places)
            if settled and is_new:
                velocity = _velocity([*before, (t, places)])
                self._pending = _Pending(t, residual, places, velocity, 0)

    def _confirm(self, pending: _Pending, result: FrameResult, places: Array) -> Jump | None:
        """Whether another image shows the jump, and enough of them do."""
        p = self._params
        later = result.t - pending.t
        offset = places + result.residual - (pending.at + later * pending.velocity)
        _, seen = median_residual(offset)
        share = float(seen @ pending.jump) / float(pending.jump @ pending.jump)
        if later > p.within or not share >= p.persists:
            self._pending = None
            return None
        self._pending = pending._replace(confirmed=pending.confirmed + 1)
        if self._pending.confirmed < p.confirm:
            return None
        self._pending = None
        return Jump(*sizes(pending.jump, self._scale))

    def _is_of_another_instant(
        self, jump: Array, before: Sequence[tuple[float, Array]], now: Array
    ) -> bool:
        """Whether the markers were near this position a moment ago, or soon will be."""
        limit = self._params.jump_px * self._scale
        for _, places in before:
            _, way = median_residual(places - now)
            if np.hypot(*_in_common(jump - way)) < limit:
                return True
        velocity = _in_common(_velocity([*before, (self._expected[-1][0], now)]))
        speed_2, moved = float(velocity @ velocity), _in_common(jump)
        if not speed_2 > 0:
            return False
        late = float(moved @ velocity) / speed_2
        across = float(np.linalg.norm(moved - late * velocity))
        return abs(late) <= self._params.late and across < limit


def sizes(residual: Array, scale: float) -> tuple[float, float]:
    """The displacement of the images apart and together, of (4,) px."""
    left_u, left_v, right_u, right_v = residual
    apart = float(np.hypot(right_u - left_u, right_v - left_v)) / scale
    return apart, float(np.hypot(right_u + left_u, right_v + left_v)) / 2 / scale


def _in_common(columns: Array) -> Array:
    """(2,) of both images from (4,)."""
    return (columns[:2] + columns[2:]) / 2


def _velocity(expected: Sequence[tuple[float, Array]]) -> Array:
    """(4,) px/s: expected velocity of the markers in both images; 0 if unknown."""
    steps = []
    for (t, before), (t_next, after) in itertools.pairwise(expected[-EXPECTED:]):
        n, moved = median_residual(after - before)
        if n and t_next > t:
            steps.append(moved / (t_next - t))
    return np.median(steps, axis=0) if steps else np.zeros(4)


@kernel(nogil=False)
def median_residual(residual: Matrix) -> tuple[int, Vector]:
    """The number of finite rows of residual (M, 4) px, and their median by column."""
    finite = np.empty(residual.shape)
    n = 0
    for row in residual:
        if np.isfinite(row.sum()):
            finite[n] = row
            n += 1
    out = np.full(4, np.nan)
    for k in range(4 if n else 0):
        out[k] = np.median(finite[:n, k])
    return n, out
