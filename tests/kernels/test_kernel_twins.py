"""The comparison of kernels with their twins detects differences."""

from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import pytest

from tests.kernel_twins import DONE, Compared, Twins, _copy, _guard, _guard_of, assert_same
from tracker.kernels import kernel
from tracker.kernels.arrays import Vector, Written


@kernel
def doubled(x: float) -> float:
    return 2.0 * x


def scaled(x: Vector, out: Written[Vector]) -> float:
    """Writes into ``out`` and calls a kernel."""
    for i in range(len(x)):
        out[i] = doubled(x[i])
    return out.sum()


def secretly(x: Vector, out: Vector) -> float:
    """Writes to an argument not declared as written."""
    out[:] = x
    return 0.0


class Kernel(SimpleNamespace):
    """A function as compiled by some compiler."""

    def __call__(self, *args):
        return self.compiled(*args)


@pytest.fixture
def compare(monkeypatch, tmp_path):
    monkeypatch.setenv(DONE, str(tmp_path / "done.txt"))

    def compare(compiled, most=100, source=scaled):
        twins = Twins()
        twins.most = most
        made = Kernel(compiled=compiled, py_func=source, options={})
        result = Compared(made, twins)(np.array([1.0, 2.0]), np.zeros(2))
        done = tmp_path / "done.txt"
        return result, done.read_text("utf-8") if done.exists() else ""

    return compare


def test_agreement_is_recorded(compare):
    assert compare(scaled) == (6.0, f"{__name__}.scaled\n")


def test_a_different_result_is_an_error(compare):
    with pytest.raises(AssertionError, match="scaled.*result"):
        compare(lambda x, out: scaled(x, out) + 1e-6)


def test_a_different_output_argument_is_an_error(compare):
    def wrong(x, out):
        result = scaled(x, out)
        out[:] = 0.0
        return result

    with pytest.raises(AssertionError, match="scaled.*argument 1"):
        compare(wrong)


def test_writing_to_an_undeclared_argument_is_an_error(compare):
    with pytest.raises(ValueError, match="read-only"):
        compare(secretly, source=secretly)


def test_members_of_tuples_are_written_only_where_declared():
    class State(NamedTuple):
        x: Vector
        P: Written[Vector]

    def parts(state, whole, two):
        return [a.flags.writeable for a in (*state, *whole, *two)]

    hints = {"state": State, "whole": Written[State], "two": tuple[Vector, Vector]}
    state, two = State(np.zeros(2), np.zeros(2)), (np.zeros(2), np.zeros(2))
    copies = [
        _guard(value, _guard_of(hint), _copy)
        for value, hint in zip((state, state, two), hints.values(), strict=True)
    ]
    assert parts(*copies) == [False, True, True, True, False, False]


def test_large_arrays_are_not_compared(compare):
    assert compare(lambda x, out: 7.0, most=3) == (7.0, "")


def tripled(x: float) -> float:
    return 3.0 * x


INNER = SimpleNamespace(py_func=tripled, options={})  # cannot be called itself


def outer(x: float) -> float:
    return INNER(x)


def test_a_twin_calls_no_compiled_kernel():
    assert Twins()._twin(SimpleNamespace(py_func=outer, options={}))(3.0) == 9.0


INNER_SECRET = SimpleNamespace(py_func=secretly, options={})


def trusting(x: Vector, out: Written[Vector]) -> float:
    return INNER_SECRET(x, out)


def test_so_do_kernels_called_by_a_kernel(compare):
    with pytest.raises(ValueError, match="read-only"):
        compare(lambda x, out: 0.0, source=trusting)


@pytest.mark.parametrize(
    ("ours", "theirs"),
    [
        (1.0, np.nan),
        ((1, 2), (1, 3)),
        (np.zeros(2), np.zeros(3)),
        (None, 0.0),
        (np.array([1.0, 1e9]), np.array([5.0, 1e9])),
    ],
)
def test_different_values_differ(ours, theirs):
    with pytest.raises(AssertionError):
        assert_same(ours, theirs, 1e-10, "here")
