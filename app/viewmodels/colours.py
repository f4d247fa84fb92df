"""The colour profile on screen: what hues look like, how many blobs, which intervals clash."""

from __future__ import annotations

import colorsys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tracker.vision.colours import ColourProfile

HUES = 180
"""OpenCV's hue runs from 0 to 179."""


def hue_centre(first: int, last: int) -> float:
    """Middle of an interval that may wrap through 0."""
    return (first + ((last - first) % HUES) / 2) % HUES


def hue_hex(hue: float) -> str:
    """A clear colour of this OpenCV hue, readable on a dark picture."""
    rgb = colorsys.hsv_to_rgb(hue / HUES, 0.85, 1.0)
    return "#" + "".join(f"{round(255 * x):02X}" for x in rgb)


def hue_colours(profile: ColourProfile) -> dict[str, str]:
    """Hue name to the colour it is drawn in."""
    return {h.name: hue_hex(hue_centre(*h.hue)) for h in profile.hues}
