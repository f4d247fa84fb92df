"""The position of a fingertip by the glove's cloth, on outlines with a known end."""

import numpy as np
import pytest

from tracker.messages import Array, Blobs, Cloth
from tracker.vision.cloth import REACH, SIDE, STEP, TILE, ClothMap, cloth_around, cloth_map
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
from tracker.vision.tip_scan import ExpectedTip, scan_tip

SIZE = 8, 10  # tiles
RADIUS = 12.0
END, JOINT = np.array([84.0, 66.0]), np.array([66.0, 92.0])
DARK, BRIGHT = (60, 60, 60), (180, 190, 200)


def laid_out(mask: Array) -> ClothMap:
    """For all pixels (h, w) of an image."""
    rows, columns = SIZE
    tiles = mask[::STEP, ::STEP].reshape(rows, SIDE, columns, SIDE).transpose(0, 2, 1, 3)
    weight = np.left_shift(np.int64(1), np.arange(SIDE**2))
    bits = (tiles.reshape(-1, SIDE**2) * weight).sum(axis=1)
    return cloth_map(Cloth(columns, rows, np.arange(rows * columns), bits))


def finger(end: Array = END) -> Array:
    """A finger's outline, from far behind its joint to a round end."""
    y, x = np.mgrid[: SIZE[0] * TILE, : SIZE[1] * TILE]
    start = JOINT + 3.0 * (JOINT - END)
    along = (end - start) / np.linalg.norm(end - start)
    t = np.clip(
        (x - start[0]) * along[0] + (y - start[1]) * along[1], 0, np.linalg.norm(end - start)
    )
    return np.hypot(x - start[0] - t * along[0], y - start[1] - t * along[1]) <= RADIUS


def expected(by: Array, sd: float = 6.0) -> ExpectedTip:
    return ExpectedTip(END + by, JOINT + 0.5 * by, RADIUS, sd**2 * np.eye(2))


@pytest.mark.parametrize("by", [(0.0, 0.0), (5.0, 0.0), (-4.0, 6.0), (3.0, 7.0)])
def test_a_fingertip_is_at_the_end_of_its_outline(by: tuple[float, float]) -> None:
    off = np.array(by)
    is_found, u, v, *cov = scan_tip(laid_out(finger()), expected(off))
    assert is_found == 1.0
    # Positions are 3 px apart and the outline is sampled every 2 px; the result is within its own
    # sd.
    assert np.hypot(u + by[0], v + by[1]) < 2.0
    assert max(cov[0], cov[2]) < 3.0**2


@pytest.mark.parametrize("what", ["goes on", "before a palm", "bare", "never looked at"])
def test_an_outline_without_an_end_gives_no_result(what: str) -> None:
    beyond = END + 2.5 * (END - JOINT)
    cloth = laid_out(finger(beyond) if what == "goes on" else finger())
    if what == "before a palm":
        cloth = laid_out(np.ones_like(finger()))
    elif what == "bare":
        cloth = laid_out(np.zeros_like(finger()))
    elif what == "never looked at":
        cloth.known[:] = 0
    assert not scan_tip(cloth, expected(np.zeros(2))).any()


def worn() -> ColourProfile:
    """Contains the glove's cloth and the background, and a hue that neither has."""
    classes = np.full(LEARNED_CELLS, ROOM, np.uint8)
    b, g, r = (np.array(DARK) >> 2).tolist()
    classes[b << 12 | g << 6 | r] = WORN
    return ColourProfile("w", (HueRange("red", (0, 9), (90, 255), (60, 255)),),
                         learned=LearnedColours.of(classes))  # fmt: skip


def test_cloth_is_classified_around_blobs_only() -> None:
    """Pixel by pixel as in the colours, within reach of a blob; unknown elsewhere."""
    image = np.full((SIZE[0] * TILE, SIZE[1] * TILE, 3), BRIGHT, np.uint8)
    image[finger()] = DARK
    blob = Blobs(JOINT[None], np.array([[9.0, 7.0]]), np.zeros(1, np.int64), np.ones(1))
    cloth = cloth_map(cloth_around(image, hue_table(worn()), blob))
    known = np.kron(cloth.known, np.ones((SIDE, SIDE), np.uint8)).astype(bool)
    y, x = np.mgrid[: known.shape[0], : known.shape[1]] * STEP
    middle = TILE * (np.stack([x, y]) // TILE) + TILE / 2
    apart = np.hypot(middle[0] - JOINT[0], middle[1] - JOINT[1])
    assert np.array_equal(known, apart <= REACH * 9.0)
    bits = cloth.bits[y // TILE, x // TILE] >> (y % TILE // STEP * SIDE + x % TILE // STEP) & 1
    assert np.array_equal(bits[known] == 1, finger()[::STEP, ::STEP][known])


def test_a_detector_adds_the_cloth_if_its_colours_include_it() -> None:
    image = np.full((SIZE[0] * TILE, SIZE[1] * TILE, 3), BRIGHT, np.uint8)
    knows, other = Detector(worn()), Detector(ColourProfile("p", worn().hues))
    assert knows.detect(image)[0].cloth is None
    assert knows.detect_with_cloth(image)[0].cloth is not None
    assert other.detect_with_cloth(image)[0].cloth is None
