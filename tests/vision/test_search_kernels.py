"""The detector's kernels against plain numpy and OpenCV on images of random coloured noise."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from tests.vision.hue_classes import all_classes
from tracker.vision import search
from tracker.vision.colours import ColourProfile, HueRange
from tracker.vision.components import Scan, axes, fill, moments, run_buffer, waist
from tracker.vision.detector import Detector, DetectorParams
from tracker.vision.hue_table import VIVID_SATURATION, hue_table

BGR = np.array([(120, 120, 120), (40, 40, 215), (50, 175, 40)], np.uint8)
TWO = ColourProfile("two", (HueRange("red", (169, 11)), HueRange("green", (54, 76))))
MIN_AREA, MAX_EXTENT = 6.0, 60


def patchy(seed: int, size: tuple[int, int] = (120, 161)) -> np.ndarray:
    """(h, w) classes 0, 1, 2 in patches of all sizes."""
    rng = np.random.default_rng(seed)
    smooth = [cv2.GaussianBlur(rng.normal(size=size), (0, 0), 2.0) for _ in range(2)]
    return np.where(smooth[0] > 0.18, 1, np.where(smooth[1] > 0.18, 2, 0))


def found(classes: np.ndarray, windows: np.ndarray) -> np.ndarray:
    """(n, COLUMNS) of the kernel under test."""
    table, image = hue_table(TWO), np.ascontiguousarray(BGR[classes])
    visited, runs = np.zeros(classes.shape, np.uint8), run_buffer(MAX_EXTENT)
    scan = Scan(image, table, visited, 1, runs, MAX_EXTENT)
    return search.find_regions(scan, windows, MIN_AREA)


def broad(mask: np.ndarray) -> np.ndarray:
    """The pixels of a mask that lie in a square of 2 x 2 of it."""
    corners = np.lib.stride_tricks.sliding_window_view(mask, (2, 2)).min(axis=(2, 3))
    out = np.zeros_like(mask)
    for y in (0, 1):
        for x in (0, 1):
            out[y : y + corners.shape[0], x : x + corners.shape[1]] |= corners
    return out


def regions(classes: np.ndarray, seeds: np.ndarray) -> set[tuple[int, int, int]]:
    """Hue, area and sum of columns of the regions that contain a seed, as labelled by OpenCV.

    A seed that is not in a square of 2 x 2 px of its hue is ignored, except at the image's edge.
    """
    inner = np.pad(np.ones(np.subtract(classes.shape, 2), bool), 1)
    out = set()
    for hue in (1, 2):
        mask = (classes == hue).astype(np.uint8)
        good = seeds & ((broad(mask) > 0) | ~inner)
        count, labels = cv2.connectedComponents(mask, connectivity=8)
        for k in range(1, count):
            y, x = np.nonzero(labels == k)
            extent = max(np.ptp(x), np.ptp(y))
            if good[y, x].any() and len(x) >= MIN_AREA and extent <= MAX_EXTENT:
                out.add((hue - 1, len(x), int(x.sum())))
    return out


@pytest.mark.parametrize("stride", [1, 3, 4])
def test_regions_are_those_labelled_by_opencv(stride: int) -> None:
    for seed in range(3):
        classes = patchy(seed)
        rows = found(classes, np.array([[0, 160, 0, 119, stride]]))
        seeds = np.zeros(classes.shape, bool)
        for k, y in enumerate(range(0, 120, stride)):
            seeds[y, k % 2 * (stride // 2) :: stride] = True
        expected = regions(classes, seeds)
        got = {
            (int(r[search.HUE]), int(r[search.AREA]), round(r[search.U] * r[search.AREA]))
            for r in rows
        }
        parted = len(rows) - len(expected)  # a region with a waist gives two rows
        assert len(expected) > 20
        assert len(expected - got) == parted
        assert len(got - expected) == 2 * parted


def test_threads_and_specks_are_ignored() -> None:
    classes = np.zeros((60, 90), int)
    classes[20, 10:40], classes[10:50, 60] = 1, 1
    for k in range(20):
        classes[30 + k, 20 + k] = 2
    assert len(found(classes, np.array([[0, 89, 0, 59, 1]]))) == 0
    classes[21, 25:27] = 1
    assert len(found(classes, np.array([[0, 89, 0, 59, 1]]))) == 1


@pytest.mark.long
def test_all_colours_of_a_vivid_hue_are_vivid() -> None:
    """So that testing only vivid pixels misses none."""
    pale = HueRange("pale", (0, 179), (VIVID_SATURATION, 255), (1, 255))
    table = hue_table(ColourProfile("vivid", (pale,)))
    assert table.vivid == 1
    bgr = np.stack(np.nonzero(all_classes(table)))
    least = bgr.min(axis=0)
    assert (bgr.max(axis=0) - least >= least // 2).all()
    paler = replace(pale, saturation=(VIVID_SATURATION - 1, 255))
    assert hue_table(ColourProfile("pale", (paler,))).vivid == 0


def test_scan_of_a_pale_hue_finds_the_same() -> None:
    pale = replace(TWO, hues=tuple(replace(h, saturation=(20, 255)) for h in TWO.hues))
    image = np.ascontiguousarray(BGR[patchy(7)])
    every = DetectorParams(stride=1)
    a, b = (Detector(p, params=every).detect(image)[0] for p in (TWO, pale))
    assert len(a) > 10
    assert np.array_equal(a.uv, b.uv)


def test_only_windows_are_searched() -> None:
    classes = np.zeros((60, 90), int)
    classes[10:20, 10:20], classes[10:20, 50:60], classes[40:50, 50:60] = 1, 2, 1
    rows = found(classes, np.array([[48, 62, 8, 22, 3], [5, 6, 30, 40, 3]]))
    assert rows[:, [search.HUE, search.U, search.V]].tolist() == [[1.0, 54.5, 14.5]]


def waist_in_numpy(mask: np.ndarray, u: float, v: float, angle: float) -> tuple[float, float]:
    """The twin of `waist`: a histogram along the axis, smoothed, compared with its
    neighbourhood."""
    y, x = np.nonzero(mask)
    along = (x - u) * np.cos(angle) + (y - v) * np.sin(angle)
    half = int(np.abs(along).max()) + 2
    low = np.floor(along + half).astype(int)
    share = along + half - low
    width = np.bincount(low, 1 - share, 2 * half + 1) + np.bincount(low + 1, share, 2 * half + 1)
    smooth = np.zeros_like(width)
    smooth[1:-1] = np.convolve(width, [0.25, 0.5, 0.25], "valid")
    place, ratio = 0.0, 1.0
    for i in range(len(width) // 5, len(width) - len(width) // 5):
        widest = min(smooth[:i].max(), smooth[i + 1 :].max())
        if smooth[i] < ratio * widest:
            place, ratio = float(i - half), smooth[i] / widest
    return place, ratio


@pytest.mark.parametrize("seed", range(6))
def test_waist_is_that_of_the_histogram(seed: int) -> None:
    _, labels, stats, _ = cv2.connectedComponentsWithStats((patchy(seed) == 1).astype(np.uint8))
    mask = labels == 1 + np.argmax(stats[1:, cv2.CC_STAT_AREA])
    y, x = np.argwhere(mask)[0]
    image, runs = np.ascontiguousarray(BGR[mask.astype(int)]), run_buffer(161)
    table, visited = hue_table(TWO), np.zeros(mask.shape, np.uint8)
    n, whole = fill(Scan(image, table, visited, 1, runs, 161), y, x, 1)
    assert whole
    _, u, v, uu, uv, vv = moments(runs[:n])
    angle = axes(uu, uv, vv)[2]
    got = waist(runs[:n], u, v, angle)
    assert got == pytest.approx(waist_in_numpy(mask, u, v, angle))
    assert got[1] < 1


def test_a_flickering_wall_is_background() -> None:
    """Abandoned early; a patch with as many holes as a marker may have is still measured."""
    rng = np.random.default_rng(4)
    classes = np.zeros((200, 300), int)
    classes[20:160, 20:160] = rng.random((140, 140)) < 0.6
    y, x = np.mgrid[0:200, 0:300]
    patch = np.hypot(x - 220, y - 100) < 14
    classes[patch & (rng.random(patch.shape) < 0.88)] = 1
    detector = Detector(TWO, params=DetectorParams(stride=1))
    blobs, rejected = detector.detect(np.ascontiguousarray(BGR[classes]))
    assert blobs.uv == pytest.approx(np.array([[220.0, 100.0]]), abs=0.5)
    assert len(rejected.reason) <= 6
