"""The glove's clock on the host's: a line under the cloud of (arrival - device time).

A packet can only come late, never early, so the lowest offsets are the truest. The line is the edge
of their lower convex hull over the middle of the window, which is the line below all points with
the least sum of distances: deterministic, and deaf to bunching and stalls.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

Point = tuple[float, float]


@dataclass(frozen=True)
class ClockMapParams:
    """Times in s."""

    bucket: float = 0.25  # one lowest offset is kept per bucket
    window: float = 40.0
    settle: float = 5.0  # span below which no skew is believed
    max_skew: float = 300e-6  # crystals are within ±200 ppm


class ClockMap:
    """Causal: `host` uses what has arrived until now."""

    def __init__(self, params: ClockMapParams | None = None) -> None:
        self._params = params or ClockMapParams()
        self._lowest: deque[Point] = deque()
        self._bucket: int | None = None  # of the last packet; a wrapped count may be below zero
        self._line: tuple[float, float, float] | None = None  # (t_device, offset, skew)
        self._last_host = float("-inf")

    @property
    def skew(self) -> float:
        """Host seconds gained per device second."""
        return self._line[2] if self._line else 0.0

    @property
    def settled(self) -> bool:
        """Whether the packets span enough time for a skew to be believed."""
        return self._span() >= self._params.settle

    def _span(self) -> float:
        return self._lowest[-1][0] - self._lowest[0][0] if self._lowest else 0.0

    def add(self, t_device: float, t_arrival: float) -> None:
        """A packet stamped ``t_device`` came at ``t_arrival`` (s)."""
        offset = t_arrival - t_device
        bucket = int(t_device // self._params.bucket)
        if bucket != self._bucket:
            self._bucket = bucket
            self._lowest.append((t_device, offset))
            while self._lowest[-1][0] - self._lowest[0][0] > self._params.window:
                self._lowest.popleft()
            self._line = self._fit()
        elif offset < self._lowest[-1][1]:
            self._lowest[-1] = (t_device, offset)
            self._line = self._fit()

    def host(self, t_device: float) -> float:
        """The host's time of a device time; never goes back from one call to the next."""
        assert self._line is not None, "add comes before host"
        t_0, offset, skew = self._line
        t = t_device + offset + skew * (t_device - t_0)
        self._last_host = max(t, self._last_host + 1e-6)
        return self._last_host

    def _fit(self) -> tuple[float, float, float]:
        points = list(self._lowest)
        if points[-1][0] - points[0][0] < self._params.settle:
            t, lowest = min(points, key=lambda p: p[1])
            return t, lowest, 0.0
        hull = _lower_hull(points)
        middle = sum(t for t, _ in points) / len(points)
        k = next(i for i in range(1, len(hull)) if hull[i][0] >= middle)
        (t_a, a), (t_b, b) = hull[k - 1], hull[k]
        skew = (b - a) / (t_b - t_a)
        limit = self._params.max_skew
        if abs(skew) > limit:
            skew = max(-limit, min(limit, skew))
            a = min(offset - skew * (t - t_a) for t, offset in points)
        return t_a, a, skew


def _lower_hull(points: list[Point]) -> list[Point]:
    """Of points in order of their first coordinate."""
    hull: list[Point] = []
    for p in points:
        while len(hull) >= 2 and _turn(hull[-2], hull[-1], p) <= 0:
            hull.pop()
        hull.append(p)
    return hull


def _turn(a: Point, b: Point, c: Point) -> float:
    """Positive where a, b, c turn left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
