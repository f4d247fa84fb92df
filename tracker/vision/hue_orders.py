"""Other orders of the names of hues."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

MOST_HUES = 5
"""More have too many orders to try."""


def orders(names: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Yields each other order of the names, those that move the fewest first; none of more than
    `MOST_HUES` names."""
    if len(names) <= MOST_HUES:
        every = sorted(permutations(names), key=lambda order: len(moved(names, order)))
        yield from every[1:]


def moved(names: tuple[str, ...], order: tuple[str, ...]) -> tuple[str, ...]:
    """The names that are at another position."""
    return tuple(a for a, b in zip(names, order, strict=True) if a != b)
