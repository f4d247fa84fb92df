"""Pixels that label themselves, on drawn patches whose colours are known."""

import cv2
import numpy as np

from tracker.calibration.colours_sample import KnownMarkers, samples_of

BLUE, CLOTH, WALL = (200, 60, 30), (40, 40, 44), (235, 235, 235)


def drawn(size: tuple[int, int]) -> np.ndarray:
    """A blue ellipse ``size`` px along and across on dark cloth before a white wall."""
    image = np.full((240, 320, 3), WALL, np.uint8)
    cv2.circle(image, (160, 120), 40, CLOTH, -1)
    cv2.ellipse(image, (160, 120), (size[0] // 2, size[1] // 2), 0, 0, 360, BLUE, -1)
    return image


def known(size: tuple[int, int]) -> KnownMarkers:
    at = np.array([[160.0, 120.0]])
    return KnownMarkers(at, np.array([size], float), ("blue",), at)


def test_a_slanted_patch_gives_its_own_colour_only() -> None:
    for size in ((20, 20), (20, 8), (20, 5)):
        samples = samples_of(drawn(size), known(size), ("blue",))
        assert len(samples.pixels("blue")) > 0
        assert (samples.pixels("blue") == BLUE).all()


def test_a_patch_that_is_covered_in_part_gives_its_own_colour_only() -> None:
    image = drawn((20, 20))
    image[:118] = np.where((image[:118] == BLUE).all(axis=-1, keepdims=True), CLOTH, image[:118])
    samples = samples_of(image, known((20, 20)), ("blue",))
    assert (samples.pixels("blue") == BLUE).all()


def test_what_is_beside_a_patch_is_cloth_and_what_is_far_is_room() -> None:
    samples = samples_of(drawn((20, 20)), known((20, 20)), ("blue",))
    assert (np.concatenate(samples.cloth) == CLOTH).all()
    assert (np.concatenate(samples.room) == WALL).all()
