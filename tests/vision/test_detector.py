"""Blob detection against OpenCV and drawn shapes with known centres."""

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tests.vision.hue_classes import all_classes
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.messages import CameraPose, StereoFrame
from tracker.vision.colours import ColourProfile, HueRange, ShapeLimits
from tracker.vision.components import Scan, axes, fill, hull, moments, run_buffer
from tracker.vision.detector import (
    Detector,
    DetectorParams,
    detect_frame,
)
from tracker.vision.hints import DetectionHints
from tracker.vision.hue_table import hue_table

BGR = {
    "red": (40, 40, 215),
    "yellow": (35, 210, 225),
    "green": (50, 175, 40),
    "blue": (205, 90, 35),
}
FOUR = ColourProfile(
    "four",
    (
        HueRange("red", (169, 11)),
        HueRange("yellow", (17, 39)),
        HueRange("green", (54, 76)),
        HueRange("blue", (99, 121)),
    ),
)
NAMES = FOUR.hue_names


@pytest.fixture(scope="module")
def detector() -> Detector:
    return Detector(FOUR)


def draw(shapes, size=(480, 640), grey=110, noise=2.5, blur=0.6, seed=0) -> np.ndarray:
    """Shapes (hue, centre, axes px, angle deg), anti-aliased by 8-fold supersampling."""
    rng = np.random.default_rng(seed)
    big = 8
    image = np.full((*size, 3), float(grey))
    for hue, (u, v), (a, b), angle in shapes:
        reach = int(max(a, b)) + 3
        u0, v0 = int(u) - reach, int(v) - reach
        side = 2 * reach + 1
        y, x = np.mgrid[0 : side * big, 0 : side * big]
        du, dv = (x + 0.5) / big - 0.5 + u0 - u, (y + 0.5) / big - 0.5 + v0 - v
        c, s = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
        inside = ((du * c + dv * s) / a) ** 2 + ((-du * s + dv * c) / b) ** 2 <= 1
        share = inside.reshape(side, big, side, big).mean(axis=(1, 3))[..., None]
        shade = 1 + 0.1 * (np.arange(side) - reach)[None, :, None] / reach
        region = image[v0 : v0 + side, u0 : u0 + side]
        region[:] = region * (1 - share) + share * np.array(BGR[hue]) * shade
    image = cv2.GaussianBlur(image, (0, 0), blur) + rng.normal(0, noise, image.shape)
    return np.clip(np.rint(image), 0, 255).astype(np.uint8)


def random_shapes(rng: np.random.Generator, n: int) -> list:
    """Discs seen at up to 60°, 5 to 20 px of radius, on a grid with random sub-pixel shifts."""
    shapes = []
    for k in range(n):
        place = np.array([60 + 75 * (k % 8), 60 + 80 * (k // 8)]) + rng.uniform(-8, 8, 2)
        a = rng.uniform(5, 20)
        tilt = np.cos(np.deg2rad(rng.uniform(0, 60)))
        shapes.append((NAMES[k % 4], place, (a, a * tilt), rng.uniform(0, 180)))
    return shapes


def test_every_colour_has_the_class_given_by_opencv() -> None:
    classes = all_classes(hue_table(FOUR))
    r = np.arange(256, dtype=np.uint8)
    for b in range(0, 256, 3):
        image = np.empty((256, 256, 3), np.uint8)
        image[..., 0], image[..., 1], image[..., 2] = b, r[:, None], r[None]
        hsv = cv2.cvtColor(image, cv2.COLOR_BGR2HSV)
        expected = np.zeros((256, 256), np.int8)
        for k in reversed(range(4)):
            expected[FOUR.hues[k].contains(hsv)] = k + 1
        assert np.array_equal(classes[b], expected)


def test_cells_of_one_class_share_a_pattern() -> None:
    table = hue_table(FOUR)
    patterns = table.patterns.reshape(-1, 512)
    low, high = patterns.min(axis=1), patterns.max(axis=1)
    assert low[:5].tolist() == high[:5].tolist() == [0, 1, 2, 3, 4]
    assert (low[5:] < high[5:]).all()
    own = table.cells[table.cells >= 5]
    assert np.array_equal(own, np.arange(5, len(patterns)))
    assert 0.1 < len(own) / len(table.cells) < 0.25


def test_hue_with_only_a_lower_value_limit_is_exact() -> None:
    table = hue_table(ColourProfile("bright", (HueRange("any", (0, 179), (0, 255), (130, 255)),)))
    b, g, r = np.indices((256, 256, 256), np.uint8, sparse=True)
    assert np.array_equal(all_classes(table), np.maximum(np.maximum(b, g), r) >= 130)


@pytest.mark.parametrize("stride", [1, 4])
def test_all_patches_are_found_within_a_tenth_of_a_pixel(stride: int) -> None:
    detector = Detector(FOUR, params=DetectorParams(stride=stride))
    errors = []
    for seed in range(4):
        shapes = random_shapes(np.random.default_rng(seed), 40)
        blobs, rejected = detector.detect(draw(shapes, seed=seed))
        assert len(blobs) == 40
        assert rejected.reason == ()
        for hue, centre, _, _ in shapes:
            d = np.hypot(*(blobs.uv - centre).T)
            assert NAMES[blobs.hue[d.argmin()]] == hue
            errors.append(d.min())
    assert np.sqrt(np.mean(np.square(errors))) < 0.12
    assert max(errors) < 0.4


def test_reused_memory_has_no_effect() -> None:
    """Past the overflow of the byte marks, with an image of another hand in between."""
    rng, detector = np.random.default_rng(11), Detector(FOUR)
    images = [draw(random_shapes(rng, 40)) for _ in range(2)]
    fresh = [Detector(FOUR).detect(image)[0] for image in images]
    for k in range(120):
        found = detector.detect(images[k % 2])[0]
        assert np.array_equal(found.uv, fresh[k % 2].uv)
        assert np.array_equal(found.hue, fresh[k % 2].hue)


def test_coarse_search_measures_the_same_regions_as_a_full_scan() -> None:
    image = draw(random_shapes(np.random.default_rng(9), 40))
    found = [Detector(FOUR, params=DetectorParams(stride=s)).detect(image)[0] for s in (1, 2, 4)]
    for blobs in found:
        order = np.lexsort(blobs.uv.T)
        expected = found[0].uv[np.lexsort(found[0].uv.T)]
        assert np.array_equal(blobs.uv[order], expected)


def mask_runs(mask: np.ndarray) -> np.ndarray:
    """Runs of a region by the kernel under test, from its first pixel."""
    image = np.zeros((*mask.shape, 3), np.uint8)
    image[mask] = (40, 40, 215)
    y, x = np.argwhere(mask)[0]
    extent = max(mask.shape)
    runs, visited = run_buffer(extent), np.zeros(mask.shape, np.uint8)
    table = hue_table(FOUR)
    n, whole = fill(Scan(image, table, visited, 1, runs, extent), y, x, 1)
    assert whole
    return runs[:n]


def blobby_mask(seed: int) -> np.ndarray:
    """One component of smoothed noise, of any shape and with holes."""
    noise = np.random.default_rng(seed).normal(size=(48, 64))
    smooth = cv2.GaussianBlur(noise, (0, 0), 2.0)
    _, labels = cv2.connectedComponents((smooth > 0.02).astype(np.uint8), connectivity=8)
    largest = np.argmax(np.bincount(labels[labels > 0]))
    return labels == largest


@pytest.mark.parametrize("seed", range(6))
def test_region_and_moments_are_those_of_opencv(seed: int) -> None:
    mask = blobby_mask(seed)
    runs = mask_runs(mask)
    covered = np.zeros_like(mask)
    for y, a, b in runs[:, :3]:
        assert not covered[y, a : b + 1].any()
        covered[y, a : b + 1] = True
    assert np.array_equal(covered, mask)
    m = cv2.moments(mask.astype(np.uint8), binaryImage=True)
    area, u, v, uu, uv, vv = moments(runs)
    assert area == m["m00"]
    assert (u, v) == pytest.approx((m["m10"] / area, m["m01"] / area))
    second = np.array([m["mu20"], m["mu11"], m["mu02"]]) / area + [1 / 12, 0, 1 / 12]
    assert (uu, uv, vv) == pytest.approx(tuple(second))


@pytest.mark.parametrize("seed", range(6))
def test_hull_counts_its_pixels_and_measures_its_perimeter(seed: int) -> None:
    mask = blobby_mask(seed)
    points = np.argwhere(mask)[:, ::-1].astype(np.int32)
    pixels, girth = hull(mask_runs(mask), int(points[0, 1]), int(points[-1, 1]))
    polygon = cv2.convexHull(points)
    inside = np.zeros(mask.shape, np.uint8)
    v, u = np.nonzero(np.ones_like(mask))
    for x, y in zip(u, v, strict=True):
        inside[y, x] = cv2.pointPolygonTest(polygon, (float(x), float(y)), False) >= 0
    assert pixels == inside.sum()
    assert girth == pytest.approx(cv2.arcLength(polygon, True) + np.pi, rel=1e-5)


def test_axes_of_an_ellipse() -> None:
    mask = np.zeros((80, 80), np.uint8)
    y, x = np.mgrid[0:80, 0:80] - 40
    c, s = np.cos(0.5), np.sin(0.5)
    mask = ((x * c + y * s) / 25) ** 2 + ((-x * s + y * c) / 10) ** 2 <= 1
    _, _, _, uu, uv, vv = moments(mask_runs(mask))
    assert axes(uu, uv, vv) == pytest.approx((50, 20, 0.5), rel=0.02)


def test_touching_patches_are_split(detector: Detector) -> None:
    a, b = np.array([200.0, 200.0]), np.array([218.0, 207.0])
    shapes = [("green", a, (10, 10), 0), ("green", b, (10, 10), 0)]
    blobs, _ = detector.detect(draw(shapes))
    assert len(blobs) == 2
    for centre in (a, b):
        assert np.hypot(*(blobs.uv - centre).T).min() < 0.8


def test_one_long_patch_is_not_split(detector: Detector) -> None:
    blobs, _ = detector.detect(draw([("green", (200.0, 200.0), (18, 8), 35)]))
    assert len(blobs) == 1


def crescent() -> np.ndarray:
    image = np.full((200, 200, 3), 110, np.uint8)
    cv2.circle(image, (100, 100), 25, BGR["red"], -1)
    cv2.circle(image, (114, 100), 20, (110, 110, 110), -1)
    return image


def bar() -> np.ndarray:
    image = np.full((200, 200, 3), 110, np.uint8)
    cv2.rectangle(image, (80, 100), (140, 102), BGR["red"], -1)
    return image


def disc(radius: int, centre: tuple[int, int] = (100, 100)) -> np.ndarray:
    image = np.full((200, 200, 3), 110, np.uint8)
    cv2.circle(image, centre, radius, BGR["red"], -1)
    return image


@pytest.mark.parametrize(
    ("image", "reason"),
    [
        (crescent(), "convexity"),
        (bar(), "circularity"),
        (disc(60), "size"),
        (disc(12, (5, 100)), "edge"),
    ],
)
def test_wrong_shapes_are_rejected_by_name(detector: Detector, image, reason: str) -> None:
    blobs, rejected = detector.detect(image)
    assert len(blobs) == 0
    assert rejected.reason == (reason,)


def test_a_wall_of_a_hue_is_not_a_blob_and_hides_no_marker(detector: Detector) -> None:
    """A background region is abandoned early; the patch next to it must still be found
    completely."""
    blobs, _ = detector.detect(draw([("red", (420.0, 240.0), (9, 9), 0)]))
    alone = blobs.uv
    both = draw([("red", (420.0, 240.0), (9, 9), 0)])
    both[:, :390] = BGR["red"]
    blobs, _ = detector.detect(both)
    assert np.array_equal(blobs.uv, alone)


def test_hints_limit_the_size(detector: Detector) -> None:
    """A blob twice as large as predicted is rejected; without a prediction the general limits
    apply."""
    image = draw([("blue", (200.0, 200.0), (16, 16), 0), ("blue", (400.0, 200.0), (16, 16), 0)])
    positions = np.array([[202.0, 199.0], [400.0, 200.0]])
    hints = DetectionHints(positions, np.full(2, 20.0), np.array([3, 0]), np.full(2, 16.0))
    blobs, rejected = detector.detect(image, hints)
    assert blobs.uv == pytest.approx(np.array([[400.0, 200.0]]), abs=0.3)
    assert rejected.reason == ("size",)


def test_only_the_hinted_regions_are_searched(detector: Detector) -> None:
    shapes = [("blue", (200.0, 200.0), (6, 6), 0), ("blue", (400.0, 200.0), (6, 6), 0)]
    hints = DetectionHints(
        np.array([[195.0, 200.0], [np.nan, 0], [900.0, -40.0]]),
        np.full(3, 15.0),
        np.full(3, 3),
    )
    blobs, _ = detector.detect(draw(shapes), hints)
    assert blobs.uv == pytest.approx(np.array([[200.0, 200.0]]), abs=0.2)


def test_frame_keeps_its_timestamps_and_a_missing_side(detector: Detector) -> None:
    image = draw([("red", (200.0, 200.0), (8, 8), 0)])
    pose = CameraPose(np.eye(3), np.zeros(3))
    frame = StereoFrame(1.5, 1.54, image, None, pose, 7)
    got = detect_frame(detector, frame)
    assert (got.t, got.t_arrival, got.index, got.pose) == (1.5, 1.54, 7, pose)
    assert got.hue_names == NAMES
    assert got.left is not None
    assert len(got.left) == 1
    assert got.right is None


def test_detection_is_reproducible_and_does_not_modify_the_image(detector: Detector) -> None:
    image = draw(random_shapes(np.random.default_rng(1), 40))
    before = image.copy()
    first, second = detector.detect(image)[0], detector.detect(image)[0]
    assert np.array_equal(first.uv, second.uv)
    assert np.array_equal(image, before)


@pytest.mark.parametrize("bad", [np.zeros((4, 4), np.uint8), np.zeros((4, 4, 3), np.float32)])
def test_image_of_a_wrong_type_is_rejected(detector: Detector, bad) -> None:
    with raises(GlovetrackError, "image.format"):
        detector.detect(bad)


def test_image_of_one_pixel(detector: Detector) -> None:
    assert len(detector.detect(np.full((1, 1, 3), 200, np.uint8))[0]) == 0


def test_too_many_hues_are_rejected() -> None:
    hues = tuple(HueRange(f"h{k}", (k, k)) for k in range(31))
    with raises(ConfigError, "colours.too_many_hues"):
        Detector(ColourProfile("many", hues, ShapeLimits()))


@pytest.mark.data
def test_photographic_backgrounds_hide_no_marker(detector: Detector, data_folder) -> None:
    """Patches pasted on real images: as many found as on a plain background, except merged ones."""
    shapes = random_shapes(np.random.default_rng(5), 40)
    found = total = 0
    for path in sorted((data_folder / "photos" / "skimage").glob("*.png"))[:3]:
        photo = cv2.resize(cv2.imread(str(path)), (640, 480))
        ours = draw(shapes, noise=0, blur=0.01)
        mask = np.any(np.abs(ours.astype(int) - 110) > 2, axis=2)
        around = cv2.dilate(mask.astype(np.uint8), np.ones((5, 5))) > 0  # the glove's dark cloth
        photo[around] = 60
        photo[mask] = ours[mask]
        blobs, _ = detector.detect(photo)
        for hue, centre, _, _ in shapes:
            d = np.hypot(*(blobs.uv - centre).T)
            near = (d < 1) & (blobs.hue == NAMES.index(hue))
            found, total = found + bool(near.any()), total + 1
    assert found / total >= 0.97
