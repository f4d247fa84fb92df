"""Colours learned from one image of the glove alone, in changed light."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import GlovetrackError
from tracker.calibration.colours_fit import clashes
from tracker.calibration.colours_image import (
    Pick,
    _refuse_worse_picked,
    learn_image,
    learn_picked,
)
from tracker.vision.colours import ColourProfile, HueRange
from tracker.vision.detector import Detector

CLOTH = {"red": 0, "yellow": 28, "green": 65, "blue": 110}
PROFILE = ColourProfile(
    "start", tuple(HueRange(n, ((h - 11) % 180, h + 11)) for n, h in CLOTH.items())
)
SIZE, FX = 0.012, 640.0


def glove_image(
    shift: int = 0, gain: float = 1.0, seed: int = 0, noise: float = 3.0, cloth: int = 110
) -> np.ndarray:
    """24 discs of four cloths on a glove of grey ``cloth`` in front of a grey wall, all hues
    shifted by ``shift`` as in other light."""
    rng = np.random.default_rng(seed)
    hsv = np.zeros((360, 480, 3), np.uint8)
    hsv[..., 2] = 110
    hsv[70:280, 80:390, 2] = cloth
    for k in range(24):
        centre = (110 + 50 * (k % 6), 100 + 50 * (k // 6))
        hue = (list(CLOTH.values())[k % 4] + shift) % 180
        value = int(min(210 * gain * rng.uniform(0.7, 1.0), 255))
        cv2.circle(hsv, centre, 11, (hue, 210, value), -1)
    bgr = cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)
    noisy = cv2.GaussianBlur(bgr, (0, 0), 0.7) + rng.normal(0, noise, bgr.shape)
    return np.clip(noisy, 0, 255).astype(np.uint8)


@pytest.mark.long
@pytest.mark.parametrize(("shift", "gain"), [(0, 1.0), (6, 1.0), (-7, 0.6), (12, 1.0)])
def test_an_image_gives_colours_that_find_the_patches(shift: int, gain: float) -> None:
    """With a shift of 12 units of hue, the previous colours miss cloth."""
    image = glove_image(shift, gain)
    fitted, found = learn_image(image, PROFILE, SIZE, FX)
    assert [f.patches for f in found] == [6, 6, 6, 6]
    for name, hue in CLOTH.items():
        h = next(x for x in fitted.hues if x.name == name)
        assert abs((h.centre - hue - shift + 90) % 180 - 90) <= 3
    blobs, _ = Detector(fitted).detect(glove_image(shift, gain, seed=1))
    assert np.bincount(blobs.hue, minlength=4).tolist() == [6, 6, 6, 6]
    assert clashes(fitted) == ()
    before, _ = Detector(PROFILE).detect(image)
    assert (len(before) < 24) == (shift == 12)


@pytest.mark.long
def test_an_unchanged_hue_is_not_reported_as_found() -> None:
    """One patch of a hue is too few to learn it from."""
    image = glove_image()
    for k in range(1, 24, 4):  # the yellow ones but the last
        if k < 20:
            cv2.circle(image, (110 + 50 * (k % 6), 100 + 50 * (k // 6)), 14, (110, 110, 110), -1)
    fitted, found = learn_image(image, PROFILE, SIZE, FX)
    assert [f.range.name for f in found] == ["red", "green", "blue"]
    assert fitted.hues[1] == PROFILE.hues[1]


def test_an_image_without_a_glove_is_rejected() -> None:
    with raises(GlovetrackError, "colours.no_glove_seen"):
        learn_image(np.full((60, 80, 3), 128, np.uint8), PROFILE, SIZE, FX)


def pointed_at(image: np.ndarray) -> list[Pick]:
    """The first disc of each cloth."""
    places = ((110.0 + 50 * k, 100.0) for k in range(4))
    return [Pick(image, np.array(uv), name) for uv, name in zip(places, CLOTH, strict=True)]


@pytest.mark.parametrize(("shift", "gain"), [(0, 1.0), (25, 0.7)])
def test_one_click_per_hue_is_as_good_as_a_fit(shift: int, gain: float) -> None:
    """With a shift of 25 units of hue, no click can be guessed from the previous colours."""
    image = glove_image(shift, gain)
    fitted, found = learn_picked(pointed_at(image), PROFILE, SIZE, FX)
    assert [f.patches for f in found] == [6, 6, 6, 6]
    blobs, _ = Detector(fitted).detect(glove_image(shift, gain, seed=1))
    assert np.bincount(blobs.hue, minlength=4).tolist() == [6, 6, 6, 6]


def test_one_click_per_hue_is_enough_in_noise() -> None:
    """A tenth of a dim patch's level."""
    dim = [glove_image(0, 0.6, seed, noise=8.0, cloth=30) for seed in (0, 1)]
    fitted, _ = learn_picked(pointed_at(dim[0]), PROFILE, SIZE, FX)
    blobs, _ = Detector(fitted).detect(dim[1])
    assert np.bincount(blobs.hue, minlength=4).tolist() == [6, 6, 6, 6]


def test_colours_that_miss_selected_markers_are_rejected() -> None:
    poor = replace(PROFILE, hues=tuple(replace(h, value=(250, 255)) for h in PROFILE.hues))
    picks, camera = pointed_at(glove_image()), (SIZE, FX)
    with raises(GlovetrackError, "colours.learned_worse"):
        _refuse_worse_picked(picks, (PROFILE, poor), camera)
    _refuse_worse_picked(picks, (poor, PROFILE), camera)


def test_a_hue_that_was_not_selected_is_named() -> None:
    with raises(GlovetrackError, "colours.points_missing"):
        learn_picked(pointed_at(glove_image())[:3], PROFILE, SIZE, FX)
