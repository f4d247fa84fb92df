"""The comparison of kernels with their twins finds what differs."""

from types import SimpleNamespace

import numpy as np
import pytest
from kernel_twins import DONE, Compared, Twins, assert_same

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


class Kernel(SimpleNamespace):
    """A function as some compiler made it."""

    def __call__(self, *args):
        return self.compiled(*args)


@pytest.fixture
def compare(monkeypatch, tmp_path):
    monkeypatch.setenv(DONE, str(tmp_path / "done.txt"))

    def compare(compiled, most=100):
        twins = Twins()
        twins.most = most
        made = Kernel(compiled=compiled, py_func=scaled, options={})
        result = Compared(made, twins)(np.array([1.0, 2.0]), np.zeros(2))
        done = tmp_path / "done.txt"
        return result, done.read_text("utf-8") if done.exists() else ""

    return compare


def test_what_agrees_is_noted(compare):
    assert compare(scaled) == (6.0, f"{__name__}.scaled\n")


def test_another_result_is_an_error(compare):
    with pytest.raises(AssertionError, match="scaled.*result"):
        compare(lambda x, out: scaled(x, out) + 1e-6)


def test_something_else_written_is_an_error(compare):
    def wrong(x, out):
        result = scaled(x, out)
        out[:] = 0.0
        return result

    with pytest.raises(AssertionError, match="scaled.*argument 1"):
        compare(wrong)


def test_large_arrays_are_not_compared(compare):
    assert compare(lambda x, out: 7.0, most=3) == (7.0, "")


INNER = SimpleNamespace(py_func=lambda x: 3.0 * x, options={})  # cannot be called itself


def outer(x):
    return INNER(x)


def test_a_twin_calls_no_compiled_kernel():
    assert Twins()._twin(SimpleNamespace(py_func=outer, options={}))(3.0) == 9.0


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
