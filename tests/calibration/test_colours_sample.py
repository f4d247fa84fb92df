"""Self-labelled pixels, on drawn patches with known colours."""

from dataclasses import replace

import cv2
import numpy as np

from tracker.calibration.colours_learn import SMOOTHING_PX, learn
from tracker.calibration.colours_sample import KnownMarkers, samples_of
from tracker.glove import library
from tracker.vision.colours import parse_profile, profile_to_toml
from tracker.vision.detector import Detector

BLUE, CLOTH, WALL = (200, 60, 30), (40, 40, 44), (235, 235, 235)


def drawn(size: tuple[int, int]) -> np.ndarray:
    """A blue ellipse ``size`` px along and across on dark cloth in front of a white wall."""
    image = np.full((240, 320, 3), WALL, np.uint8)
    cv2.circle(image, (160, 120), 40, CLOTH, -1)
    cv2.ellipse(image, (160, 120), (size[0] // 2, size[1] // 2), 0, 0, 360, BLUE, -1)
    return image


def known(size: tuple[int, int]) -> KnownMarkers:
    at = np.array([[160.0, 120.0]])
    return KnownMarkers(at, np.array([size], float), ("blue",), at)


def test_a_slanted_patch_gives_only_its_own_colour() -> None:
    for size in ((20, 20), (20, 8), (20, 5)):
        samples = samples_of(drawn(size), known(size), ("blue",))
        assert len(samples.pixels("blue")) > 0
        assert (samples.pixels("blue") == BLUE).all()


def test_a_partly_occluded_patch_gives_only_its_own_colour() -> None:
    image = drawn((20, 20))
    image[:118] = np.where((image[:118] == BLUE).all(axis=-1, keepdims=True), CLOTH, image[:118])
    samples = samples_of(image, known((20, 20)), ("blue",))
    assert (samples.pixels("blue") == BLUE).all()


def test_pixels_next_to_a_patch_are_cloth_and_distant_ones_background() -> None:
    samples = samples_of(drawn((20, 20)), known((20, 20)), ("blue",))
    assert (np.concatenate(samples.cloth) == CLOTH).all()
    assert (np.concatenate(samples.room) == WALL).all()


def test_colours_learned_from_noisy_images_find_a_patch_that_noise_would_split() -> None:
    """The file records that images must be smoothed."""
    factory = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
    dim = (drawn((20, 20)) * 0.3).astype(np.uint8)
    rng = np.random.default_rng(1)
    noisy = [np.clip(dim + rng.normal(0, 14, dim.shape), 0, 255).astype(np.uint8) for _ in range(3)]
    samples = samples_of(noisy[0], known((20, 20)), factory.hue_names)
    samples.add(samples_of(noisy[1], known((20, 20)), factory.hue_names))
    learned = learn(factory, samples)
    assert learned.learned is not None and learned.learned.smoothing_px == SMOOTHING_PX
    assert parse_profile(profile_to_toml(learned)) == learned
    blue = learned.hue_names.index("blue")
    blobs, _ = Detector(learned).detect(noisy[2])
    there = np.linalg.norm(blobs.uv[blobs.hue == blue] - (160, 120), axis=1)
    assert np.sum(there < 1.0) == 1
    torn = replace(learned, learned=replace(learned.learned, smoothing_px=0))
    blobs, _ = Detector(torn).detect(noisy[2])
    there = np.linalg.norm(blobs.uv[blobs.hue == blue] - (160, 120), axis=1)
    assert not np.any(there < 1.0)


def test_images_without_noise_are_not_smoothed() -> None:
    assert samples_of(drawn((20, 20)), known((20, 20)), ("blue",)).noisy == [False]
