"""The words for types are numba's distinctions: numba is the oracle."""

from typing import NamedTuple

import numpy as np
import pytest
from numba import typeof

from tracker.kernels.kinds import UnknownKindError, kind_of, kinds_of
from tracker.kernels.numba_types import arguments, numba_type

READ_ONLY = np.zeros(3)
READ_ONLY.setflags(write=False)


class Pair(NamedTuple):
    first: object
    second: object


def _local() -> type:
    class Local(NamedTuple):
        only: int

    return Local


Local = _local()
VALUES = [
    1, -(2**62), 1.5, True, None, np.float64(2), np.float32(2), np.int64(3), np.uint8(3),
    np.bool_(1), np.zeros(3),
    np.zeros((2, 3)), np.zeros((2, 3)).T, np.zeros((4, 4))[::2, ::2], np.zeros(8)[::2],
    np.zeros((0, 3)), np.zeros((1, 3)).T, READ_ONLY, np.zeros((2, 2, 3), np.uint8),
    np.zeros(3, np.int16), np.zeros(2, bool), (1, 2.0), (np.zeros(2), (1, True)), (),
    (1.0, 2.0), 1j, np.complex64(1), np.zeros(2, complex), Pair(np.zeros(2), 1j), Pair(1.0, 2.0),
]  # fmt: skip


@pytest.mark.parametrize("value", VALUES, ids=lambda v: f"{type(v).__name__}")
def test_a_word_says_what_numba_takes_a_value_for(value):
    assert numba_type(kind_of(value)) == typeof(value)


def test_all_arguments_of_a_call():
    assert arguments(kinds_of((1, np.zeros(2)))) == (typeof(1), typeof(np.zeros(2)))
    assert arguments(kinds_of(())) == ()


@pytest.mark.parametrize("value", ["a", [1.0], 2**64, np.zeros(2, ">f8"), {}, Local(1)])
def test_what_no_word_is_for(value):
    with pytest.raises(UnknownKindError):
        kind_of(value)
