"""Which parts of an image are the glove's cloth."""

from dataclasses import replace

import numpy as np

from tracker.messages import Array, Blobs
from tracker.vision.cloth import (
    AROUND,
    INSIDE,
    REACH,
    SIDE,
    STEP,
    TILE,
    brightness_at,
    cloth_around,
    cloth_at,
    cloth_map,
)
from tracker.vision.colours import (
    LEARNED_CELLS,
    ROOM,
    WORN,
    ColourProfile,
    HueRange,
    LearnedColours,
)
from tracker.vision.detector import Detector
from tracker.vision.hue_table import hue_table

SIZE = 8, 10  # tiles
MARKER = np.array([66.0, 92.0])
DARK, BRIGHT = (60, 60, 60), (180, 190, 200)


def finger() -> Array:
    """Mask (h, w) of a slanted bar through the marker."""
    y, x = np.mgrid[: SIZE[0] * TILE, : SIZE[1] * TILE]
    return np.asarray(np.abs(26 * (x - MARKER[0]) + 18 * (y - MARKER[1])) <= 12 * np.hypot(26, 18))


def worn() -> ColourProfile:
    """Contains the glove's cloth and the background, and a hue that neither has."""
    classes = np.full(LEARNED_CELLS, ROOM, np.uint8)
    b, g, r = (np.array(DARK) >> 2).tolist()
    classes[b << 12 | g << 6 | r] = WORN
    hues = (HueRange("red", (0, 9), (90, 255), (60, 255)),)
    return ColourProfile("w", hues, learned=LearnedColours.of(classes))


def test_cloth_is_classified_around_blobs_only() -> None:
    """Pixel by pixel as in the colours, within reach of a blob; unknown elsewhere."""
    image = np.full((SIZE[0] * TILE, SIZE[1] * TILE, 3), BRIGHT, np.uint8)
    image[finger()] = DARK
    blob = Blobs(MARKER[None], np.array([[9.0, 7.0]]), np.zeros(1, np.int64), np.ones(1))
    cloth = cloth_map(cloth_around(image, hue_table(worn()), blob))
    known = np.kron(cloth.known, np.ones((SIDE, SIDE), np.uint8)).astype(bool)
    y, x = np.mgrid[: known.shape[0], : known.shape[1]] * STEP
    middle = TILE * (np.stack([x, y]) // TILE) + TILE / 2
    apart = np.hypot(middle[0] - MARKER[0], middle[1] - MARKER[1])
    assert np.array_equal(known, apart <= REACH * 9.0)
    bits = cloth.bits[y // TILE, x // TILE] >> (y % TILE // STEP * SIDE + x % TILE // STEP) & 1
    seen = finger()[::STEP, ::STEP][known]
    assert np.array_equal(bits[known] == 1, seen) and 0 < seen.mean() < 1


def test_a_detector_adds_the_cloth_if_its_colours_include_it() -> None:
    image = np.full((SIZE[0] * TILE, SIZE[1] * TILE, 3), BRIGHT, np.uint8)
    knows, other = Detector(worn()), Detector(ColourProfile("p", worn().hues))
    assert knows.detect(image)[0].cloth is None
    assert knows.detect_with_cloth(image)[0].cloth is not None
    assert other.detect_with_cloth(image)[0].cloth is None


def test_the_texture_is_what_is_brighter_than_the_cloth_around() -> None:
    rng, shape = np.random.default_rng(4), (SIZE[0] * TILE, SIZE[1] * TILE)
    image = np.full((*shape, 3), BRIGHT, np.uint8)
    image[finger()] = rng.integers(56, 64, (np.count_nonzero(finger()), 3))
    blob = Blobs(MARKER[None], np.array([[9.0, 7.0]]), np.zeros(1, np.int64), np.ones(1))
    found = cloth_map(cloth_around(image, hue_table(worn()), blob))
    four = sum(image[j::STEP, i::STEP].astype(int) @ (1, 2, 1) for j in (0, 1) for i in (0, 1))
    cloth = np.zeros(four.shape, bool)
    for y, x in np.ndindex(four.shape):
        cloth[y, x] = cloth_at(found, STEP * x, STEP * y) == INSIDE
    around = np.lib.stride_tricks.sliding_window_view
    size = (2 * AROUND + 1, 2 * AROUND + 1)
    total, count = (
        around(np.pad(a, AROUND), size).sum(axis=(2, 3)) for a in (four * cloth, cloth.astype(int))
    )
    expected = np.where(cloth, np.where(four * count >= total, 1, -1), 0)
    seen = [brightness_at(found, STEP * x, STEP * y) for y, x in np.ndindex(four.shape)]
    assert np.array_equal(np.reshape(seen, four.shape), expected)
    assert 0.3 < (expected[cloth] == 1).mean() < 0.7
    unknown = replace(cloth_around(image, hue_table(worn()), blob), bright=None)
    assert brightness_at(cloth_map(unknown), *MARKER) == 0
