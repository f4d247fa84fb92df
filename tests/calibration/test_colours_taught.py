"""The eyedropper overrides learned colours."""

import numpy as np

from tracker.calibration.colours_learn import with_colour
from tracker.glove import library
from tracker.vision.colours import (
    LEARNED_CELLS,
    ROOM,
    ColourProfile,
    LearnedColours,
    parse_profile,
)
from tracker.vision.detector import Detector

FACTORY = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
BLUE = np.array([200, 100, 20], np.uint8)


def patch() -> np.ndarray:
    image = np.full((120, 160, 3), 40, np.uint8)
    image[50:66, 70:86] = BLUE
    return image


def found(profile: ColourProfile) -> list[str]:
    blobs, _ = Detector(profile).detect(patch())
    return [profile.hue_names[k] for k in blobs.hue]


def test_a_picked_colour_overrides_the_background_and_can_be_removed() -> None:
    room = LearnedColours.of(np.full(LEARNED_CELLS, ROOM, np.uint8))
    learned = ColourProfile("x", FACTORY.hues, learned=room)
    assert found(FACTORY) == ["blue"]
    assert found(learned) == []
    picked = with_colour(learned, BLUE, learned.hue_names.index("blue"))
    assert found(picked) == ["blue"]
    assert found(with_colour(picked, BLUE, -1)) == []


def test_colours_without_learned_classes_are_unchanged() -> None:
    assert with_colour(FACTORY, BLUE, 0) is FACTORY
