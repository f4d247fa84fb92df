"""Hues whose names are exchanged in a colour profile, for instance red called blue."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import permutations

from tracker.vision.colours import HUES, ColourProfile

MOST_HUES = 5
"""More have too many orders to try."""


def renamed(profile: ColourProfile) -> Iterator[ColourProfile]:
    """Yields the profile with each other order of its names, those that move the fewest first."""
    names = profile.hue_names
    if len(names) > MOST_HUES:
        return
    orders = sorted(permutations(names), key=lambda order: len(moved(names, order)))
    for order in orders[1:]:
        pairs = zip(profile.hues, order, strict=True)
        yield replace(profile, hues=tuple(replace(hue, name=name) for hue, name in pairs))


def moved(names: tuple[str, ...], order: tuple[str, ...]) -> tuple[str, ...]:
    """The names that are at another position."""
    return tuple(a for a, b in zip(names, order, strict=True) if a != b)


def exchanged(before: ColourProfile, after: ColourProfile) -> tuple[str, ...]:
    """The hues of ``before`` whose colours have another name in ``after``: each is nearest to
    another hue, and these are a permutation of them."""
    nearest = {hue.name: _nearest(hue.centre, after) for hue in before.hues}
    if sorted(nearest.values()) != sorted(nearest):
        return ()
    return tuple(name for name, other in nearest.items() if name != other)


def _nearest(centre: float, profile: ColourProfile) -> str:
    """The hue of a profile whose centre is nearest on the circle."""
    return min(
        profile.hues, key=lambda hue: abs((hue.centre - centre + HUES / 2) % HUES - HUES / 2)
    ).name
