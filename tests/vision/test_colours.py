"""Colour profiles: membership of a hue, file round trips, error messages."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import resources
from tests.notices import raises
from tracker.base.errors import FileError
from tracker.vision.colours import (
    ColourProfile,
    HueRange,
    ShapeLimits,
    load_profile,
    parse_profile,
    profile_to_toml,
)

DEFAULT = Path(resources.__file__).parent / "colours" / "fabric-default.toml"
LEVEL = st.tuples(st.integers(0, 255), st.integers(0, 255)).map(lambda p: (min(p), max(p)))
RANGE = st.builds(
    HueRange,
    st.text('abcXYZ019_- é"', min_size=1, max_size=8),
    st.tuples(st.integers(0, 179), st.integers(0, 179)),
    LEVEL,
    LEVEL,
)
TEXT = """schema = 1
name = "x"
[hues.red]
hue = [169, 11]
saturation = [90, 255]
value = [45, 255]
"""


@pytest.mark.parametrize(
    ("name", "hue"), [("red", 0), ("yellow", 28), ("green", 65), ("blue", 110)]
)
def test_included_profile_contains_the_four_cloths(name: str, hue: int) -> None:
    profile = load_profile(DEFAULT)
    for offset in range(-11, 12):
        pixel = np.array([(hue + offset) % 180, 230, 200])
        assert [h.name for h in profile.hues if h.contains(pixel)] == [name]


@given(RANGE)
def test_membership_is_that_of_opencv(h: HueRange) -> None:
    rng = np.random.default_rng(0)
    hsv = np.stack([rng.integers(0, n, (40, 40)) for n in (180, 256, 256)], axis=-1).astype(
        np.uint8
    )
    low = (h.hue[0], h.saturation[0], h.value[0])
    high = (h.hue[1], h.saturation[1], h.value[1])
    if h.hue[0] <= h.hue[1]:
        mask = cv2.inRange(hsv, low, high)
    else:
        mask = cv2.inRange(hsv, low, (179, *high[1:])) | cv2.inRange(hsv, (0, *low[1:]), high)
    assert np.array_equal(h.contains(hsv), mask > 0)


@given(st.lists(RANGE, min_size=1, max_size=4, unique_by=lambda h: h.name))
def test_file_round_trip(hues: list[HueRange]) -> None:
    profile = ColourProfile('with "quotes"', tuple(hues), ShapeLimits((0.25, 2.0), 0.8, 0.1))
    assert parse_profile(profile_to_toml(profile)) == profile


@given(RANGE, RANGE)
def test_overlap_is_symmetric_and_agrees_with_membership(a: HueRange, b: HueRange) -> None:
    hues = np.arange(180)
    pixel = np.stack([hues, np.zeros_like(hues), np.zeros_like(hues)], axis=-1)
    full = [HueRange(h.name, h.hue, (0, 255), (0, 255)) for h in (a, b)]
    shared = bool(np.any(full[0].contains(pixel) & full[1].contains(pixel)))
    assert full[0].overlaps(full[1]) == full[1].overlaps(full[0]) == shared
    assert a.overlaps(b) == b.overlaps(a)


@pytest.mark.parametrize(
    ("old", "new", "code", "values"),
    [
        ("schema = 1", "schema = 2", "toml.schema", {"key": "schema"}),
        ("hue = [169, 11]", "hue = [169, 180]", "toml.between", {"line": 4, "key": "hues.red.hue"}),
        ("hue = [169, 11]", "hue = [169.5, 11]", "colours.file_integers", {}),
        ("saturation = [90, 255]", "saturation = [255, 90]", "toml.order", {"line": 5}),
        ("value = [45, 255]", "value = [45]", "toml.numbers", {"key": "hues.red.value"}),
        ("value = [45, 255]", "", "toml.missing", {"key": "hues.red.value"}),
        (
            "value = [45, 255]",
            "value = [45, 255]\nhue2 = 3",
            "toml.unknown_key",
            {"key": "hues.red.hue2"},
        ),
        (
            "[hues.red]",
            "[shape]\nsize = [2.0, 1.0]\n[hues.red]",
            "colours.file_pair",
            {"key": "shape.size"},
        ),
        ("[hues.red]", "[hues.red", "config.not_toml", {"file": "my.toml"}),
    ],
)
def test_errors_name_the_line(old: str, new: str, code: str, values: dict[str, object]) -> None:
    with raises(FileError, code, **values):
        parse_profile(TEXT.replace(old, new), "my.toml")


def test_profile_without_a_hue_is_rejected() -> None:
    with raises(FileError, "colours.file_no_hue"):
        parse_profile('schema = 1\nname = "x"\n')


def test_missing_file_is_named(tmp_path: Path) -> None:
    with raises(FileError, "file.not_readable"):
        load_profile(tmp_path / "none.toml")


def test_centre_and_width_wrap() -> None:
    red = HueRange("red", (170, 10))
    assert (red.centre, red.width) == (0.0, 20)
