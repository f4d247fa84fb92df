"""Results of the light meter for simulated rooms, photographs, and single faults."""

import sys
from collections import Counter
from dataclasses import replace
from itertools import islice
from pathlib import Path

import cv2
import numpy as np
import pytest

import resources
from tracker.calibration.light_meter import LightMeter, any_colours, near_hues, noise_of
from tracker.vision.colours import (
    HUES,
    LEARNED_CELLS,
    ROOM,
    ColourProfile,
    LearnedColours,
    load_profile,
)

sys.path.append(str(Path(__file__).parents[1] / "simulation"))
import desk_scores

PROFILE = load_profile(Path(resources.__file__).parent / "colours" / "fabric-default.toml")
EXPECTED = {"window": set(), "led": set(), "lamp": {"warm"}, "dim": {"dark", "noisy"}}
ABOUT_LIGHT = {"clipped", "dark", "noisy", "warm", "cold"}


def usual_advice(images) -> set[str]:
    """The advice given for most of the images."""
    meter, counts, count = LightMeter(PROFILE), Counter(), 0
    for seen in images:
        counts.update({a.kind for a in meter.read(seen.image).advice})
        count += 1
    return {kind for kind, n in counts.items() if kind in ABOUT_LIGHT and n > count / 2}


@pytest.mark.long
@pytest.mark.parametrize("light", EXPECTED)
def test_photographs_get_the_advice_for_their_light(light: str, data_folder: Path) -> None:
    folder = data_folder / "desk_pictures" / light
    if not folder.is_dir():
        pytest.skip(f"no photographs at {folder}")
    counts = usual_advice(islice(desk_scores.photographs(folder), 0, None, 12))
    assert counts == EXPECTED[light]


@pytest.mark.long
@pytest.mark.parametrize("light", EXPECTED)
def test_simulated_rooms_get_the_advice_for_their_light(light: str) -> None:
    """Lamp light varies between images with the lit part of the glove; so this is tested for
    most."""
    surface, times = desk_scores.SURFACES[light], np.array([1.0, 1.3])
    images = [i for s in (2, 3, 4) for i in desk_scores.simulated(light, s, times, surface)]
    assert usual_advice(images) - {"clipped"} == EXPECTED[light]


@pytest.fixture(scope="module")
def led():
    return next(desk_scores.simulated("led", 2, np.array([1.0]), "laminate"))


def kinds(image) -> set[str]:
    return {a.kind for a in LightMeter(PROFILE).read(image).advice}


@pytest.mark.long
def test_detected_patches_are_markers_of_the_hand(led) -> None:
    reading = LightMeter(PROFILE).read(led.image)
    gap = np.linalg.norm(reading.uv[:, None] - led.uv[None], axis=2).min(axis=1)
    assert len(reading.uv) >= 10
    assert np.mean(gap < 5) > 0.8


def test_a_longer_exposure_clips_and_a_shorter_one_is_dark(led) -> None:
    assert not kinds(led.image) & ABOUT_LIGHT
    assert "clipped" in kinds(np.clip(led.image * 1.7, 0, 255).astype(np.uint8))
    assert "dark" in kinds((led.image * 0.45).astype(np.uint8))


def test_another_white_balance_is_warm_or_cold(led) -> None:
    def balanced(red: float, blue: float) -> np.ndarray:
        return np.clip(led.image * np.array([blue, 1.0, red]), 0, 255).astype(np.uint8)

    assert "warm" in kinds(balanced(1.15, 0.8))
    assert "cold" in kinds(balanced(0.7, 1.15))


def test_markers_in_colours_missing_in_the_profile_are_reported_as_missed(led) -> None:
    """Shifted by 14 of 180 hues, three of four cloths leave their intervals of 11 to each side."""
    hsv = cv2.cvtColor(led.image, cv2.COLOR_BGR2HSV)
    hsv[..., 0] = (hsv[..., 0].astype(int) + 14) % HUES
    turned = cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)
    before, after = (LightMeter(PROFILE).read(i) for i in (led.image, turned))
    assert len(before.missed) <= 2
    assert len(after.missed) >= 0.4 * len(after.uv)
    assert "missed" in {a.kind for a in after.advice}
    assert any(a.notice.code == "light.markers_missed" for a in after.advice)


def test_a_background_full_of_the_markers_colours_is_reported(led) -> None:
    image = led.image.copy()
    for k in range(20):
        cv2.circle(image, (40 + 60 * k, 690), 9, (40, 4, 190), -1)
    room = LightMeter(PROFILE).read(image)
    assert room.room["red"] >= 15
    assert any(
        a.notice.code == "light.room_has_hues" and "red" in a.notice.values["hues"]
        for a in room.advice
    )


def test_noise_is_not_taken_for_patches(data_folder: Path) -> None:
    """Two of three detected patches are markers, complete or in part; without smoothing every other
    one was a speck of dark noise."""
    folder = data_folder / "desk_pictures" / "dim"
    if not folder.is_dir():
        pytest.skip(f"no photographs at {folder}")
    meter, read, true = LightMeter(PROFILE), 0, 0
    for seen in islice(desk_scores.photographs(folder), 0, None, 12):
        uv = meter.read(seen.image).uv
        apart = np.linalg.norm(uv[:, None] - seen.uv[None], axis=2)
        read, true = read + len(uv), true + int(np.sum(apart.min(axis=1) < 8))
    assert read > 20 and true > 0.66 * read


def test_without_a_hand_one_is_requested_and_warmth_is_unknown() -> None:
    reading = LightMeter(PROFILE).read(np.full((720, 1280, 3), 120, np.uint8))
    assert [a.kind for a in reading.advice] == ["hand"]
    assert np.isnan(reading.warmth)


def test_noise_is_that_of_smooth_areas() -> None:
    rng = np.random.default_rng(1)
    image = rng.normal(110, 3.0, (720, 1280, 3))
    image[:300] += rng.normal(0, 20, (300, 1280, 3))
    assert noise_of(np.clip(image, 0, 255).astype(np.uint8)) == pytest.approx(3.0, rel=0.08)


def test_similar_hues_are_named() -> None:
    red, orange = (40.0, 10.0, 200.0), (20.0, 55.0, 200.0)
    pixel, hue = np.array([red, red, orange, orange]), np.array([0, 0, 1, 1])
    gap = 30 * (55 - 20) / 180 + 30 * (40 - 10) / 190  # OpenCV's hue of both, 0 between them
    assert near_hues(pixel, hue, gap + 1.5) == [(0, 1)]
    assert near_hues(pixel, hue, gap - 1.5) == []


def test_any_colours_include_all_hues_for_any_division() -> None:
    for first in (0, 22):
        hues = any_colours(first).hues
        assert sum(h.width + 1 for h in hues) == HUES
        for hue in range(HUES):
            assert sum(bool(h.contains(np.array([hue, 200, 200]))) for h in hues) == 1


def fitted_otherwise() -> list[ColourProfile]:
    """Colours after other light, a slider or a wrong click."""
    turned = [
        replace(
            PROFILE,
            hues=tuple(replace(h, hue=tuple((x + by) % HUES for x in h.hue)) for h in PROFILE.hues),
        )
        for by in (-12, 9)
    ]
    wide = replace(PROFILE.hues[2], hue=(45, 118), saturation=(20, 255))
    swollen = replace(PROFILE, hues=(*PROFILE.hues[:2], wide, PROFILE.hues[3]))
    none = LearnedColours.of(np.full(LEARNED_CELLS, ROOM, np.uint8), cloth=0.9, smoothing_px=5)
    return [*turned, swollen, replace(PROFILE, learned=none)]


@pytest.mark.long
@pytest.mark.parametrize("light", EXPECTED)
def test_the_result_does_not_depend_on_the_fitted_colours(light: str) -> None:
    images = desk_scores.simulated(light, 3, np.array([1.0]), desk_scores.SURFACES[light])
    image = next(images).image
    reading = LightMeter(PROFILE).read(image)
    assert len(reading.uv) >= 8
    for profile in fitted_otherwise():
        other = LightMeter(profile).read(image)
        assert [a for a in other.advice if a.kind in ABOUT_LIGHT - {"clipped"}] == [
            a for a in reading.advice if a.kind in ABOUT_LIGHT - {"clipped"}
        ]
        assert other.good == reading.good
        assert (other.level, other.noise) == (reading.level, reading.noise)
        assert other.warmth == pytest.approx(reading.warmth)
