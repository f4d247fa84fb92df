"""Merges overlapping intervals."""

from __future__ import annotations

from collections.abc import Iterable


def merged(intervals: Iterable[tuple[int, int]]) -> list[tuple[int, int]]:
    """Intervals in order; those that overlap or touch become one."""
    out: list[tuple[int, int]] = []
    for start, stop in sorted(intervals):
        if out and start < out[-1][1]:
            out[-1] = out[-1][0], max(stop, out[-1][1])
        else:
            out.append((start, stop))
    return out
