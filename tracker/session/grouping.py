"""Putting together what belongs to one instant: the IMUs of a packet, the two images."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic, TypeVar

T = TypeVar("T")


@dataclass
class Group(Generic[T]):
    """Parts by name. ``stamp`` is that of the first part, ``log_time`` the latest of all (ns)."""

    stamp: int
    log_time: int
    sequence: int
    parts: dict[str, T] = field(default_factory=dict)


class Grouper(Generic[T]):
    """Collects parts whose stamps agree within ``tolerance`` ns.

    A group leaves when it is whole, when `close` says so, or when log time has moved on by more
    than ``patience`` ns; groups leave in the order of their stamps, at log times that never fall.
    """

    def __init__(self, names: frozenset[str], tolerance: int, patience: int) -> None:
        self._names, self._tolerance, self._patience = names, tolerance, patience
        self._open: list[Group[T]] = []
        self._left_until = -1

    def add(self, name: str, stamp: int, log_time: int, sequence: int, part: T) -> None:
        """Take a part. One that is older than what left already is dropped."""
        if stamp <= self._left_until:
            return
        group = self._find(name, stamp)
        if group is None:
            group = Group(stamp, log_time, sequence)
            self._open.append(group)
            self._open.sort(key=lambda g: g.stamp)
        group.parts[name] = part
        group.log_time = max(group.log_time, log_time)

    def _find(self, name: str, stamp: int) -> Group[T] | None:
        near = [
            g for g in self._open if abs(g.stamp - stamp) <= self._tolerance and name not in g.parts
        ]
        return min(near, key=lambda g: abs(g.stamp - stamp), default=None)

    def close(self, stamp: int, log_time: int, sequence: int) -> Group[T]:
        """Take out the group at exactly ``stamp``; an empty one if no part of it came."""
        for group in self._open:
            if group.stamp == stamp:
                self._open.remove(group)
                return group
        return Group(stamp, log_time, sequence)

    def ready(self, now: int | None) -> list[Group[T]]:
        """Groups that leave at log time ``now``; all of them if it is None."""
        out: list[Group[T]] = []
        while self._open and (now is None or self._done(self._open[0], now)):
            group = self._open.pop(0)
            self._left_until = max(self._left_until, group.stamp)
            out.append(group)
        return out

    def _done(self, group: Group[T], now: int) -> bool:
        return group.parts.keys() >= self._names or now - group.log_time > self._patience
