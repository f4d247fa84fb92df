"""Counters behind the read-outs: rates, latencies and losses over the last seconds."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Collection, Mapping

import numpy as np

from tracker.messages import Array

WINDOW = 3.0  # s over which rates are counted
KEPT = 400  # latencies that a median is taken over
COUNTERS = ("imu_lost", "imu_overflow", "frames_dropped", "stereo_refused", "camera_jumps")
"""Figures that only grow while the engine runs."""


def counted_since(before: Mapping[str, float], values: Mapping[str, float]) -> dict[str, float]:
    """``values`` with each of `COUNTERS` reduced by its value in ``before``."""
    return {n: v - before.get(n, 0.0) if n in COUNTERS else v for n, v in values.items()}


class Telemetry:
    """Thread-safe. Names are those of docs/architecture.md."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._events: dict[str, deque[float]] = {}
        self._times: dict[str, deque[float]] = {}
        self._counts: dict[str, float] = {}
        self._sources: list[Callable[[], dict[str, float]]] = []

    def ask(self, figures: Callable[[], dict[str, float]]) -> None:
        """Call ``figures`` whenever `values` is read; a name that it leaves out stays as it was."""
        self._sources.append(figures)

    def tick(self, name: str, t: float) -> None:
        """One more of ``name`` at ``t`` (s)."""
        with self._lock:
            ticks = self._events.setdefault(name, deque())
            ticks.append(t)
            while ticks and ticks[0] < t - WINDOW:
                ticks.popleft()

    def took(self, name: str, duration: float) -> None:
        """A stage took ``duration`` s."""
        with self._lock:
            self._times.setdefault(name, deque(maxlen=KEPT)).append(duration)

    def set(self, name: str, value: float) -> None:
        """Sets a count or level."""
        with self._lock:
            self._counts[name] = value

    def values(self, now: float) -> dict[str, float]:
        """``<name>_rate_hz`` per tick, ``latency_<name>_ms`` and ``_p99_ms`` per stage, counts."""
        asked = [figures() for figures in self._sources]  # may acquire other locks
        with self._lock:
            for figures in asked:
                self._counts.update(figures)
            out = dict(self._counts)
            for name, ticks in self._events.items():
                while ticks and ticks[0] < now - WINDOW:
                    ticks.popleft()
                span = min(max(now - ticks[0], 0.1), WINDOW) if ticks else WINDOW
                out[f"{name}_rate_hz"] = len(ticks) / span
            took = {name: list(times) for name, times in self._times.items()}
        for name, times in took.items():  # without the lock, for which devices and filter wait
            out |= latency_figures(name, times)
        return out


def latency_figures(name: str, times: Collection[float]) -> dict[str, float]:
    """Median and 99th percentile of ``times`` (s), by the names of the status."""
    ms = 1e3 * np.sort(np.fromiter(times, float))
    return {
        f"latency_{name}_ms": _quantile(ms, 0.5),
        f"latency_{name}_p99_ms": _quantile(ms, 0.99),
    }


def _quantile(ordered: Array, share: float) -> float:
    """Linear interpolation between sorted figures; NumPy's own function would sort each time."""
    at = share * (len(ordered) - 1)
    i = int(at)
    low, high = float(ordered[i]), float(ordered[min(i + 1, len(ordered) - 1)])
    return low + (at - i) * (high - low)
