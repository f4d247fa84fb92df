"""Colours, signs and words of the states; distinguishable without colour vision.

The hues are those of Okabe and Ito, "Color Universal Design" (2008).
"""

from __future__ import annotations

from dataclasses import dataclass

from app.words import mark
from tracker.messages import Tracking, Validity

BLUISH_GREEN = "#009E73"
ORANGE = "#E69F00"
VERMILION = "#D55E00"
BLUE = "#0072B2"
SKY = "#56B4E9"
PURPLE = "#CC79A7"
YELLOW = "#F0E442"
GREY = "#8A9099"
NEUTRAL = "#D5D9DE"
"""Colour of the hand before it is tinted by a state."""


@dataclass(frozen=True)
class StateLook:
    """The look of a state: a colour, a sign that is visible in grey print, and a word."""

    colour: str
    sign: str
    word: str


GOOD = StateLook(BLUISH_GREEN, "●", mark("good"))
WARN = StateLook(ORANGE, "◐", mark("attention"))
BAD = StateLook(VERMILION, "▲", mark("problem"))
IDLE = StateLook(GREY, "○", mark("idle"))

VALIDITY: dict[int, StateLook] = {
    Validity.MEASURED: StateLook(BLUISH_GREEN, "●", mark("measured")),
    Validity.INFERRED: StateLook(ORANGE, "◐", mark("inferred")),
    Validity.LOST: StateLook(GREY, "○", mark("lost")),
}

TRACKING: dict[int, StateLook] = {
    Tracking.SEARCHING: StateLook(SKY, "◌", mark("Searching for the hand")),
    Tracking.TRACKING: StateLook(BLUISH_GREEN, "●", mark("Tracking")),
    Tracking.COASTING: StateLook(ORANGE, "◐", mark("Coasting on the IMUs only")),
    Tracking.LOST: StateLook(VERMILION, "▲", mark("Position lost")),
}
