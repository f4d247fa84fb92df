"""Fitting a profile: ranges that contain their samples, images in other light, clashes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.notices import raises
from tracker.base.errors import GlovetrackError
from tracker.calibration.colours_fit import (
    FitParams,
    add_pixel,
    clashes,
    fit_samples,
    hue_interval,
    parted,
    remove_pixel,
)
from tracker.vision.colours import HUES, ColourProfile, HueRange

CLOTH = {"red": 0, "yellow": 28, "green": 65, "blue": 110}
PROFILE = ColourProfile(
    "start", tuple(HueRange(n, ((h - 11) % 180, h + 11)) for n, h in CLOTH.items())
)
PIXEL = st.tuples(st.integers(0, 179), st.integers(0, 255), st.integers(0, 255))
LEVEL = st.tuples(st.integers(0, 255), st.integers(0, 255)).map(lambda p: (min(p), max(p)))
RANGE = st.builds(
    HueRange, st.just("h"), st.tuples(st.integers(0, 179), st.integers(0, 179)), LEVEL, LEVEL
)


def brute_arc(hues: set[int]) -> int:
    """Width of the shortest arc that contains all, by trying every first hue."""
    return min(max((h - first) % HUES for h in hues) for first in hues)


@given(st.sets(st.integers(0, 179), min_size=1, max_size=12))
def test_shortest_arc(hues: set[int]) -> None:
    first, last = hue_interval(np.array(sorted(hues)))
    assert (last - first) % HUES == brute_arc(hues)
    assert all((h - first) % HUES <= (last - first) % HUES for h in hues)


def test_samples_of_red_wrap_through_zero() -> None:
    rng = np.random.default_rng(0)
    hsv = np.column_stack(
        [rng.integers(-6, 7, 500) % 180, rng.integers(150, 220, 500), rng.integers(80, 200, 500)]
    )
    fitted = fit_samples("red", hsv)
    assert fitted.contains(hsv).mean() > 0.97
    assert fitted.hue[0] > 165
    assert fitted.hue[1] < 15


def test_stray_samples_do_not_stretch_the_range() -> None:
    hsv = np.tile([65, 200, 150], (500, 1))
    hsv[:4, 0] = 120
    assert fit_samples("green", hsv).width <= 2 * FitParams().hue_margin


def test_fitting_without_samples_is_rejected() -> None:
    with raises(GlovetrackError, "colours.no_pixels"):
        fit_samples("red", np.zeros((0, 3)))


def test_samples_of_every_hue_are_rejected() -> None:
    hsv = np.column_stack([np.arange(180), np.full(180, 200), np.full(180, 200)])
    with raises(GlovetrackError, "colours.every_hue"):
        fit_samples("red", hsv)


@given(RANGE, PIXEL)
def test_added_pixel_is_included_and_nothing_is_lost(hue: HueRange, pixel) -> None:
    grown = add_pixel(hue, np.array(pixel))
    assert grown.contains(np.array(pixel))
    assert grown.width >= hue.width
    corners = [(h, s, v) for h in hue.hue for s in hue.saturation for v in hue.value]
    assert grown.contains(np.array(corners)).all()


@given(RANGE, PIXEL)
def test_removed_pixel_is_excluded_and_nothing_is_gained(hue: HueRange, pixel) -> None:
    cut = remove_pixel(hue, np.array(pixel))
    if (
        hue.hue[0] == hue.hue[1]
        and hue.saturation == (pixel[1],) * 2
        and hue.value == (pixel[2],) * 2
    ):
        assert cut == hue
        return
    assert not cut.contains(np.array(pixel))
    corners = [(h, s, v) for h in cut.hue for s in cut.saturation for v in cut.value]
    assert hue.contains(np.array(corners)).all()


def test_clashes_name_both_hues() -> None:
    close = ColourProfile("x", (HueRange("a", (170, 10)), HueRange("b", (6, 20))))
    (clash,) = clashes(close)
    assert (clash.hue, clash.other) == ("a", "b")
    assert clash.share == pytest.approx(5 / 15)
    assert clashes(PROFILE) == ()


def test_split_ranges_do_not_clash() -> None:
    close = ColourProfile("x", (HueRange("a", (170, 10)), HueRange("b", (6, 20))))
    a, b = parted(close.hues)
    assert not a.overlaps(b)
    assert (a.hue[0], b.hue[1]) == (170, 20)
    assert (b.hue[0] - a.hue[1]) % HUES == 1
