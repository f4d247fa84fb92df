"""Hues whose names are exchanged in a colour profile, for instance red called blue."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tracker.vision.colours import HUES, ColourProfile
from tracker.vision.hue_orders import orders


def renamed(profile: ColourProfile) -> Iterator[ColourProfile]:
    """Yields the profile with each other order of its names, those that move the fewest first."""
    for order in orders(profile.hue_names):
        pairs = zip(profile.hues, order, strict=True)
        yield replace(profile, hues=tuple(replace(hue, name=name) for hue, name in pairs))


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
