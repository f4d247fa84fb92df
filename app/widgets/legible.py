"""Colours of words that are to be read on a ground: WCAG 2.1, success criterion 1.4.3."""

from __future__ import annotations

from functools import cache

LEAST = 4.5  # of the contrast of words
STEPS = 20


def luminance(colour: str) -> float:
    """Of ``#rrggbb`` in sRGB, 0 to 1."""
    shares = [share / 255 for share in _channels(colour)]
    linear = [s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast_of(one: str, other: str) -> float:
    """1 of a colour with itself to 21 of black on white."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


@cache
def legible(colour: str, ground: str) -> str:
    """``colour``, as much darker or lighter as words in it need on ``ground``."""
    end = max(("#000000", "#FFFFFF"), key=lambda c: contrast_of(c, ground))
    mixed = (_mixed(colour, end, k / STEPS) for k in range(STEPS + 1))
    return next((c for c in mixed if contrast_of(c, ground) >= LEAST), end)


def _mixed(one: str, other: str, share: float) -> str:
    pairs = zip(_channels(one), _channels(other), strict=True)
    return "#" + "".join(f"{round(a + share * (b - a)):02x}" for a, b in pairs)


def _channels(colour: str) -> list[int]:
    return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
