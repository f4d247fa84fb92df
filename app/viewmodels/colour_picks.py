"""What a pixel that the user points at says about a hue: whether it has one, and which."""

from __future__ import annotations

from enum import Enum

import cv2
import numpy as np

from app.viewmodels.colour_images import Image
from app.viewmodels.colours import nearest_hue
from tracker.calibration.colours_fit import fit_samples
from tracker.calibration.colours_image import PICKED_PX
from tracker.calibration.colours_sample import calmed, core_pixels
from tracker.messages import Array
from tracker.vision.colours import ColourProfile, HueRange

LEAST_SATURATION, LEAST_VALUE = 50, 30  # of 255: below, noise decides which hue a pixel has
LEAST_CHROMA = 15.0  # levels between the largest and the smallest channel


class Eyedropper(Enum):
    """What a click does with the pixel under it."""

    SET = "set"
    ADD = "add"
    REMOVE = "remove"


def has_hue(hsv: Array) -> bool:
    """Whether an HSV pixel (3,) is coloured enough to be a marker's."""
    saturation, value = float(hsv[1]), float(hsv[2])
    chroma = saturation * value / 255
    return saturation >= LEAST_SATURATION and value >= LEAST_VALUE and chroma >= LEAST_CHROMA


def range_at(image: Image, u: float, v: float, name: str) -> HueRange:
    """The range of the cloth at a pixel of a BGR image (h, w, 3), as a fit makes it."""
    pixels = core_pixels(calmed(image), np.array([u, v]), PICKED_PX)
    return fit_samples(name, cv2.cvtColor(pixels[None], cv2.COLOR_BGR2HSV)[0])


def mistaken_for(
    hsv: Array, chosen: HueRange, profile: ColourProfile, factory: ColourProfile
) -> str:
    """The hue that an HSV pixel (3,) is more likely of than of the ``chosen`` one, else "".

    Ranges that were moved say little about their cloth, so the ``factory`` ones count too, where
    they are of the same hues.
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
