"""Declared shapes, compared with arrays of known shapes."""

import re

import numpy as np
import pytest

from tracker.base.array_shapes import ArrayShape


@pytest.mark.parametrize(
    ("text", "array", "found"),
    [
        ("n 3", np.zeros((5, 3)), {"n": 5}),
        ("n 3", np.zeros((0, 3)), {"n": 0}),
        ("n 3", np.zeros((5, 2)), None),
        ("n 3", np.zeros((5, 3, 1)), None),
        ("n 3", np.zeros((5, 3), int), None),
        ("int n", np.zeros(4, int), {"n": 4}),
        ("bool M", np.zeros(2, bool), {"M": 2}),
        ("bool M", np.zeros(2), None),
        ("complex 2", np.zeros(2, complex), {}),
        ("n n", np.zeros((4, 4)), {"n": 4}),
        ("n n", np.zeros((4, 5)), None),
        ("n 21n", np.zeros((2, 42)), {"n": 2}),
        ("21n 21n", np.zeros((42, 42)), {"n": 2}),
        ("21n 21n", np.zeros((43, 43)), None),
        ("0 | M", np.zeros(0), {}),
        ("0 | M", np.zeros(6), {"M": 6}),
        ("0 | M M", np.zeros((6, 6)), {"M": 6}),
    ],
)
def test_a_shape_matches_its_declaration(text: str, array: np.ndarray, found: object) -> None:
    assert ArrayShape.of(text).match(array, {}) == found


def test_a_known_size_is_checked() -> None:
    shape = ArrayShape.of("0 2 | d 2")
    assert shape.match(np.zeros((3, 2)), {"d": 3}) == {}
    assert shape.match(np.zeros((4, 2)), {"d": 3}) is None
    assert shape.match(np.zeros((0, 2)), {"d": 3}) == {}


@pytest.mark.parametrize("text", ["n, 3", "float32 n", "nm", "-1"])
def test_an_invalid_shape_is_rejected(text: str) -> None:
    with pytest.raises(TypeError, match=re.escape(text)):
        ArrayShape.of(text)
