"""Colours, signs and words of the states: one place, colour-blind safe, never colour alone.

The hues are those of Okabe and Ito, "Color Universal Design" (2008).
"""

from __future__ import annotations

from dataclasses import dataclass

from tracker.messages import Tracking, Validity

BLUISH_GREEN = "#009E73"
ORANGE = "#E69F00"
VERMILLION = "#D55E00"
BLUE = "#0072B2"
SKY = "#56B4E9"
PURPLE = "#CC79A7"
YELLOW = "#F0E442"
GREY = "#8A9099"


@dataclass(frozen=True)
class Look:
    """How one state appears: a colour, a sign that survives grey print, and a word."""

    colour: str
    sign: str
    word: str


GOOD = Look(BLUISH_GREEN, "●", "good")
WARN = Look(ORANGE, "◐", "attention")
BAD = Look(VERMILLION, "▲", "problem")
IDLE = Look(GREY, "○", "idle")

VALIDITY: dict[int, Look] = {
    Validity.MEASURED: Look(BLUISH_GREEN, "●", "measured"),
    Validity.INFERRED: Look(ORANGE, "◐", "inferred"),
    Validity.LOST: Look(GREY, "○", "lost"),
}

TRACKING: dict[int, Look] = {
    Tracking.SEARCHING: Look(SKY, "◌", "Searching for the hand"),
    Tracking.TRACKING: Look(BLUISH_GREEN, "●", "Tracking"),
    Tracking.COASTING: Look(ORANGE, "◐", "Coasting on the glove alone"),
    Tracking.LOST: Look(VERMILLION, "▲", "Position lost"),
}
