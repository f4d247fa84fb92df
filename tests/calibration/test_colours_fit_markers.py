"""Fitting colours to tracked markers, on images with discs of known colours."""

import dataclasses

import cv2
import numpy as np
import pytest

from tracker.calibration.colours_fit import clashes
from tracker.calibration.colours_fit_markers import (
    MarkerFitParams,
    MarkerSamples,
    SeenSide,
    disc_pixels,
    seen_sides,
)
from tracker.glove.model import GloveModel
from tracker.messages import Blobs, FrameResult, Tracking
from tracker.vision.colours import ColourProfile, HueRange

CLOTH = {"red": 0, "yellow": 28, "green": 65, "blue": 110}
PROFILE = ColourProfile(
    "start", tuple(HueRange(n, ((h - 11) % 180, h + 11)) for n, h in CLOTH.items())
)
RADIUS = 8


def centres(glove: GloveModel) -> np.ndarray:
    """(M, 2) px, far from each other."""
    m = np.arange(len(glove.markers))
    return np.column_stack([40 + 60 * (m % 10), 40 + 60 * (m // 10)]).astype(float)


def image(glove: GloveModel, shift: int = 0, value: int = 170) -> np.ndarray:
    """Every marker as a disc of its cloth on the dark glove, all hues shifted by ``shift``."""
    hsv = np.zeros((300, 660, 3), np.uint8)
    hsv[..., 2] = 60
    for marker, (u, v) in zip(glove.markers, centres(glove), strict=True):
        hue = (CLOTH[marker.hue] + shift) % 180
        cv2.circle(hsv, (int(u), int(v)), RADIUS, (hue, 200, value), -1)
    noise = np.random.default_rng(1).normal(0, 3, hsv.shape)
    bgr = cv2.GaussianBlur(cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR), (0, 0), 0.7)
    return np.clip(bgr + noise, 0, 255).astype(np.uint8)


def side(glove: GloveModel, image: np.ndarray, matched: np.ndarray) -> SeenSide:
    """All markers predicted at their positions; those in ``matched`` (M,) are blobs."""
    uv, n = centres(glove), int(matched.sum())
    match = np.full(len(uv), -1, np.int64)
    match[matched] = np.arange(n)
    size = np.full((n, 2), 2.0 * RADIUS)
    blobs = Blobs(uv[matched], size, np.zeros(n, np.int64), np.ones(n))
    return SeenSide(image, blobs, match, uv, np.tile(np.eye(2), (len(uv), 1, 1)))


def fitted(glove: GloveModel, *sides: SeenSide, **params):
    samples = MarkerSamples(glove, PROFILE.hue_names, MarkerFitParams(**params))
    for one in sides:
        samples.take([one], np.ones(len(glove.markers)))
    return samples.fit(PROFILE)


def off(profile: ColourProfile, name: str, shift: int) -> float:
    hue = next(h for h in profile.hues if h.name == name)
    return abs((hue.centre - CLOTH[name] - shift + 90) % 180 - 90)


@pytest.mark.parametrize("shift", [0, 9, -12])
def test_ranges_adapt_to_the_light(glove, shift):
    everything = np.ones(len(glove.markers), bool)
    profile, found = fitted(glove, side(glove, image(glove, shift), everything))
    assert [f.range.name for f in found] == list(CLOTH)
    assert all(off(profile, name, shift) <= 2 for name in CLOTH)
    assert clashes(profile) == ()


def test_a_hue_missed_by_the_detector_is_found_at_its_predictions(glove):
    """No blue marker was matched, as after a change of light; its centres still show its colour."""
    others = np.array([m.hue != "blue" for m in glove.markers])
    profile, found = fitted(glove, side(glove, image(glove, 12), others))
    assert off(profile, "blue", 12) <= 2
    blue = sum(m.hue == "blue" for m in glove.markers)
    assert next(f.patches for f in found if f.range.name == "blue") == blue


def test_an_uncertain_prediction_is_not_used(glove):
    others = np.array([m.hue != "blue" for m in glove.markers])
    seen = side(glove, image(glove, 12), others)
    vague = dataclasses.replace(seen, cov=seen.cov * 400)
    profile, found = fitted(glove, vague)
    assert "blue" not in [f.range.name for f in found]
    assert profile.hues[3] == PROFILE.hues[3]


def test_a_marker_matched_with_the_wrong_patch_does_not_stretch_the_range(glove):
    everything = np.ones(len(glove.markers), bool)
    seen = side(glove, image(glove), everything)
    red, green = (
        next(i for i, m in enumerate(glove.markers) if m.hue == hue) for hue in ("red", "green")
    )
    match = seen.match.copy()
    match[[red, green]] = match[[green, red]]
    profile, _ = fitted(glove, dataclasses.replace(seen, match=match))
    assert off(profile, "red", 0) <= 2 and profile.hues[0].width <= 2 * 11


def test_dark_and_light_exposures_are_both_within_the_range(glove):
    everything = np.ones(len(glove.markers), bool)
    dark, light = (image(glove, value=v) for v in (90, 230))
    profile, found = fitted(glove, side(glove, dark, everything), side(glove, light, everything))
    centre = centres(glove)[[m.hue for m in glove.markers].index("green")]
    for exposure in (dark, light):
        pixels = disc_pixels(exposure, centre, 3.0)
        assert profile.hues[2].contains(pixels).all()
    assert found[0].patches == 2 * sum(m.hue == "red" for m in glove.markers)


def test_old_exposures_are_dropped(glove):
    everything = np.ones(len(glove.markers), bool)
    before, now = (side(glove, image(glove, s), everything) for s in (-10, 10))
    profile, _ = fitted(glove, before, now, now, most_exposures=2)
    assert off(profile, "green", 10) <= 2


def test_glove_without_cloth_under_the_markers_has_no_effect(glove):
    everything = np.ones(len(glove.markers), bool)
    grey = np.full((300, 660, 3), 60, np.uint8)
    profile, found = fitted(glove, side(glove, grey, everything))
    assert profile == PROFILE and found == ()


@pytest.mark.parametrize("uv", [(-30.0, 10.0), (10.0, 400.0), (700.0, 10.0)])
def test_a_disc_outside_the_image_is_empty(uv):
    assert disc_pixels(np.zeros((300, 660, 3), np.uint8), np.array(uv), 5.0).shape == (0, 3)


def test_a_disc_at_the_edge_is_clipped_and_a_whole_one_has_its_area():
    image = np.zeros((50, 50, 3), np.uint8)
    whole = disc_pixels(image, np.array([25.0, 25.0]), 6.0)
    assert len(whole) == pytest.approx(np.pi * 36, rel=0.05)
    assert (
        0.4 * len(whole) < len(disc_pixels(image, np.array([25.0, 0.0]), 6.0)) < 0.65 * len(whole)
    )


def test_a_camera_without_images_is_ignored(glove):
    result = FrameResult.nothing(1.0, Tracking.TRACKING, len(glove.markers))
    image = np.zeros((4, 4, 3), np.uint8)
    sides = seen_sides(image, None, (Blobs.empty(), None), result)
    assert len(sides) == 1 and sides[0].image is image
