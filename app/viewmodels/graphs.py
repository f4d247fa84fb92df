"""User-defined graphs: their signals, units, read-outs and tables."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from app.viewmodels.signal_curves import Curve
from app.viewmodels.signals import Signal
from app.words import local, tr
from tracker.messages import Array

SPANS = (5.0, 10.0, 30.0, 60.0)
"""Time spans of a live graph, s."""
WHOLE = 0.0
"""Time span of a graph that shows a whole recording."""
USUAL = 10.0
MOST_CURVES, MOST_GRAPHS, MOST_UNITS = 12, 12, 2


@dataclass(frozen=True)
class Graph:
    """Keys of its signals, and its time spans for live data and replays, s."""

    keys: tuple[str, ...] = ()
    span: float = USUAL
    replay_span: float = WHOLE

    def without(self, key: str) -> Graph:
        return replace(self, keys=tuple(k for k in self.keys if k != key))


def to_setting(graphs: Sequence[Graph]) -> list[dict[str, Any]]:
    """As stored in the settings."""
    return [{"signals": list(g.keys), "span": g.span, "replay_span": g.replay_span} for g in graphs]


def from_setting(value: object) -> list[Graph]:
    """The graphs from the settings; invalid entries are ignored."""
    graphs = []
    for item in value if isinstance(value, list) else ():
        if isinstance(item, dict):
            keys = item.get("signals", [])
            known = tuple(k for k in keys if isinstance(k, str)) if isinstance(keys, list) else ()
            spans = (item.get("span", USUAL), item.get("replay_span", WHOLE))
            live, replay = spans
            graphs.append(
                Graph(
                    known[:MOST_CURVES],
                    live if live in SPANS else USUAL,
                    replay if replay in SPANS else WHOLE,
                )
            )
    return graphs[:MOST_GRAPHS]


def first_graphs(known: Iterable[Signal]) -> list[Graph]:
    """Graphs for new users: flexion of the index finger, and the angular rates of an IMU."""
    signals = list(known)
    angles = [
        s.key for s in signals if s.name in ("angle/index_mcp_flexion", "angle/index_pip_flexion")
    ]
    first = next((s for s in signals if s.column == "gyro"), None)
    turning = [
        s.key
        for s in signals
        if first is not None and s.column == "gyro" and s.path[:3] == first.path[:3]
    ]
    return [Graph(tuple(angles)), Graph(tuple(turning[:3]))]


def units_of(signals: Iterable[Signal]) -> list[str]:
    """Units in the order of their first signals: that of the left axis, then of the right one."""
    return list(dict.fromkeys(signal.unit for signal in signals))


def refusal(shown: Sequence[Signal], more: Signal) -> str:
    """Why ``more`` cannot be added to a graph of ``shown``; empty if it can."""
    if len(shown) >= MOST_CURVES:
        return tr("A graph has at most {} curves. Add another graph.").format(MOST_CURVES)
    units = units_of(shown)
    if more.unit not in units and len(units) >= MOST_UNITS:
        text = tr("This graph shows {} and {} already. Add another graph for {}.")
        return text.format(*(unit_name(unit) for unit in (*units, more.unit)))
    return ""


def unit_name(unit: str) -> str:
    """Unit of an axis; counts have none."""
    return unit or tr("counts")


def axis_title(signals: Sequence[Signal]) -> str:
    """The unit, preceded by the signal's name if there is only one signal."""
    if not signals:
        return ""
    unit = unit_name(signals[0].unit)
    return f"{signals[0].label} / {unit}" if len(signals) == 1 else unit


def value_at(curve: Curve, t: float) -> float:
    """The value at the instant nearest to ``t`` (s); NaN without data."""
    times, values = curve
    if len(times) == 0:
        return float("nan")
    i = int(np.searchsorted(times, t))
    i = min(max(i, 0), len(times) - 1)
    if i > 0 and t - times[i - 1] < times[i] - t:
        i -= 1
    return float(values[i])


def number(value: float) -> str:
    """A value as shown in a read-out."""
    return f"{local(value):.4g}" if np.isfinite(value) else "–"


def table(curves: Mapping[Signal, Curve], begin: float, end: float, zero: float) -> str:
    """CSV of the data between ``begin`` and ``end`` (s): a column for each signal, a row for each
    instant of any of them, s from ``zero``; empty cells where a signal has no value at that
    instant."""
    columns, times = [], []
    for t, values in curves.values():
        there = (t >= begin) & (t <= end) & np.isfinite(values)
        columns.append((t[there], values[there]))
        times.append(t[there])
    instants = np.unique(np.concatenate(times)) if times else np.zeros(0)
    names = [f"{s.label} ({s.unit})" if s.unit else s.label for s in curves]
    head = ",".join(['"time (s)"', *(f'"{name}"' for name in names)])
    grid = np.full((len(instants), len(columns)), np.nan)
    for k, (t, values) in enumerate(columns):
        grid[np.searchsorted(instants, t), k] = values
    return "\n".join([head, *_lines(instants - zero, grid)]) + "\n"


def _lines(times: Array, grid: Array) -> Iterable[str]:
    for t, row in zip(times, grid, strict=True):
        cells = (f"{x:.7g}" if np.isfinite(x) else "" for x in row)
        yield ",".join((f"{t:.6f}", *cells))
