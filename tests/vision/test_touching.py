"""Markers in front of things of their own colour, against drawn discs with known centres."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from tests.vision.test_detector import BGR, FOUR, NAMES
from tracker.messages import Blobs
from tracker.vision.colours import LEARNED_CELLS, UNKNOWN, LearnedColours
from tracker.vision.detector import Detector
from tracker.vision.hints import DetectionHints

CENTRE = np.array([320.0, 240.0])
RADIUS = 9.0  # px
YELLOW = NAMES.index("yellow")


@pytest.fixture(scope="module")
def detector() -> Detector:
    """With a profile of noisy images, which has learned no colours beyond the intervals."""
    unknown = np.full(LEARNED_CELLS, UNKNOWN, np.uint8)
    return Detector(replace(FOUR, learned=LearnedColours.of(unknown, 0.0, 5)))


def disc(radius: float) -> np.ndarray:
    """(h, w) whether pixels belong to the marker's disc of a radius, px."""
    v, u = np.mgrid[0:480, 0:640]
    return np.hypot(u - CENTRE[0], v - CENTRE[1]) <= radius


def scene(object_of: float = 0.6) -> np.ndarray:
    """A yellow disc half in front of a larger yellow area of ``object_of`` times its brightness."""
    rng = np.random.default_rng(3)
    image = np.full((480, 640, 3), 110.0)
    colour = np.array(BGR["yellow"], float)
    image[100:400, 320:520] = object_of * colour
    image[disc(RADIUS)] = colour
    image = cv2.GaussianBlur(image, (0, 0), 0.6) + rng.normal(0, 2.0, image.shape)
    return np.clip(image, 0, 255).astype(np.uint8)


def hints(uv: np.ndarray, hue: int = YELLOW) -> DetectionHints:
    return DetectionHints(uv[None], np.array([30.0]), np.array([hue]))


def there(blobs: Blobs) -> np.ndarray:
    """(n,) px from the disc's centre, of the yellow blobs."""
    return np.linalg.norm(blobs.uv[blobs.hue == YELLOW] - CENTRE, axis=1)


def test_a_predicted_marker_before_its_own_colour_is_found(detector: Detector) -> None:
    image = scene()
    assert len(there(detector.detect(image)[0])) == 0
    found = there(detector.detect(image, hints(CENTRE + [3.0, -4.0]))[0])
    # centres of hundreds of pixels are known to 0.1 px; the half's border may be one pixel off
    assert len(found) == 1 and found[0] < 0.7


def test_it_is_not_sought_elsewhere_nor_in_another_hue(detector: Detector) -> None:
    image = scene()
    assert len(there(detector.detect(image, hints(CENTRE + [0.0, 25.0]))[0])) == 0
    assert len(there(detector.detect(image, hints(CENTRE, NAMES.index("red")))[0])) == 0


def test_without_a_border_there_is_no_marker(detector: Detector) -> None:
    """Nothing is cut out at the place of a prediction."""
    assert len(there(detector.detect(scene(object_of=1.0), hints(CENTRE))[0])) == 0


def test_a_marker_that_was_found_is_found_once(detector: Detector) -> None:
    image = scene()
    image[~disc(RADIUS + 1)] = 110
    assert len(there(detector.detect(image)[0])) == 1
    assert len(there(detector.detect(image, hints(CENTRE))[0])) == 1


def test_in_images_without_noise_it_is_not_sought(detector: Detector) -> None:
    """There it finds 0.3 % more markers for twice the time."""
    learned = detector.profile.learned
    assert learned is not None
    clear = Detector(replace(FOUR, learned=replace(learned, smoothing_px=0)))
    assert len(there(clear.detect(scene(), hints(CENTRE))[0])) == 0
