"""Pixels that the user clicks on: whether a pixel has a hue, and whether it is the selected one."""

from __future__ import annotations

from collections.abc import Collection
from enum import Enum
from functools import lru_cache

import cv2
import numpy as np

from app.viewmodels.colour_images import Image
from app.viewmodels.colours import nearest_hue
from app.viewmodels.names import display_name
from app.words import tr
from tracker.calibration.colours_fit import fit_samples
from tracker.calibration.colours_image import PICKED_PX
from tracker.calibration.colours_sample import core_pixels, denoised
from tracker.glove import library
from tracker.messages import Array
from tracker.vision.colours import ColourProfile, HueRange, parse_profile

LEAST_SATURATION, LEAST_VALUE = 50, 30  # of 255: below, noise determines the hue of a pixel
SAME_PX = 8.0  # px of the mask, between two clicks on one marker
LEAST_CHROMA = 15.0  # levels between the largest and the smallest channel


class Eyedropper(Enum):
    """The effect of a click on a pixel."""

    SET = "set"
    ADD = "add"
    REMOVE = "remove"


def has_hue(hsv: Array) -> bool:
    """Whether an HSV pixel (3,) is coloured enough for a marker."""
    saturation, value = float(hsv[1]), float(hsv[2])
    chroma = saturation * value / 255
    return saturation >= LEAST_SATURATION and value >= LEAST_VALUE and chroma >= LEAST_CHROMA


def range_at(image: Image, u: float, v: float, name: str) -> HueRange:
    """The range of the cloth at a pixel of a BGR image (h, w, 3), as a fit would set it."""
    pixels = core_pixels(denoised(image), np.array([u, v]), PICKED_PX)
    return fit_samples(name, cv2.cvtColor(pixels[None], cv2.COLOR_BGR2HSV)[0])


def mistaken_for(
    hsv: Array, chosen: HueRange, profile: ColourProfile, factory: ColourProfile
) -> str:
    """The hue that an HSV pixel (3,) more likely belongs to than the ``chosen`` one, else "".

    Modified ranges may not represent their cloth, so the ``factory`` ranges are used as well if
    they have the same hues.
    """
    if chosen.contains(hsv):
        return ""
    current, _ = nearest_hue(profile, hsv)
    if factory.hue_names != profile.hue_names:
        return current if current != chosen.name else ""
    shipped, inside = nearest_hue(factory, hsv)
    if shipped == chosen.name:
        return ""
    if inside:
        return shipped
    return current if current != chosen.name else ""


@lru_cache
def factory_colours() -> ColourProfile:
    """The colours shipped with the program."""
    return parse_profile(library.text("colours", library.DEFAULT_COLOURS))


class PickCheck:
    """Rejects clicks that are probably mistakes; a second click on the same marker is accepted."""

    def __init__(self) -> None:
        self._questioned: tuple[str, float, float] | None = None  # hue, u, v of the last such click

    def problem(self, hsv: Array, u: float, v: float, chosen: HueRange, now: ColourProfile) -> str:
        """Why an HSV pixel (3,) at (u, v) of the mask is not taken into the ``chosen`` range of the
        profile ``now``; empty if it is."""
        before, self._questioned = self._questioned, None
        if not has_hue(hsv):
            words = tr(
                "This pixel is too grey or too dark to have a hue (saturation {}, value {}). "
                "Click the middle of a {} marker."
            )
            return words.format(int(hsv[1]), int(hsv[2]), display_name(chosen.name))
        other = mistaken_for(hsv, chosen, now, factory_colours())
        if not other or (
            before is not None
            and before[0] == chosen.name
            and np.hypot(u - before[1], v - before[2]) < SAME_PX
        ):
            return ""
        self._questioned = chosen.name, u, v
        words = tr("This looks like {0}, not {1}. Select {0} first, or click again to accept it.")
        return words.format(display_name(other), display_name(chosen.name))


def missing_picks(hues: Collection[str], picked: Collection[str]) -> str:
    """Which hues still need a click before the colours are learned; empty if none does."""
    missing = [display_name(h) for h in hues if h not in picked]
    words = tr("Clicked: {}. To learn the colours, also click: {}.")
    there = ", ".join(display_name(h) for h in hues if h in picked)
    return words.format(there, ", ".join(missing)) if missing else ""
