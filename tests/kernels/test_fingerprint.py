"""A kernel's fingerprint depends on everything that affects its compiled code, and on nothing
else."""

import sys
import types

import pytest

import tracker
from tracker.kernels.fingerprint import fingerprint

SOURCE = """
from typing import NamedTuple

import numpy as np

SCALE = 2.0
TABLE = np.arange(3.0)

@kernel
def inner(x):
    return x + 1

class State(NamedTuple):
    x: float
    y: float

def outer(x: State) -> float:
    '''What it does.'''
    return SCALE * inner(x.y) * TABLE[0]
"""


def kernel(function=None, **options):
    """The decorator, without a compiler."""

    def make(function):
        function.py_func, function.options = function, options
        return function

    return make(function) if function else make


def made(source, options=None):
    module = types.ModuleType("made")
    module.kernel = kernel
    exec(compile(source, "made.py", "exec"), module.__dict__)
    return fingerprint(module.outer, options or {})


@pytest.mark.parametrize(
    "old, new",
    [
        ("SCALE = 2.0", "SCALE = 3.0"),
        ("np.arange(3.0)", "np.arange(4.0)"),
        ("x + 1", "x + 2"),
        ("x + 1", "x - 1"),
        ("@kernel", "@kernel(fastmath=True)"),
        ("return SCALE", "return -SCALE"),
        ("y: float", "y: int"),
        ("x: float\n    y: float", "y: float\n    x: float"),
    ],
)
def test_changes_with_code_constants_and_the_kernels_it_calls(old, new):
    assert old in SOURCE
    assert made(SOURCE.replace(old, new)) != made(SOURCE)


def test_changes_with_options():
    assert made(SOURCE, {"fastmath": True}) != made(SOURCE)


@pytest.mark.parametrize(
    "old, new",
    [("What it does.", "Said otherwise."), ("@kernel", "# a remark\n\n@kernel")],
)
def test_does_not_change_with_docstrings(old, new):
    assert made(SOURCE.replace(old, new)) == made(SOURCE)


def test_changes_with_a_kernel_in_another_module_of_ours(monkeypatch):
    other = types.ModuleType("tracker.other")
    monkeypatch.setitem(sys.modules, "tracker.other", other)
    source = SOURCE.replace("SCALE * inner", "SCALE * other.inner").replace(
        "SCALE =", "import tracker.other as other\nSCALE ="
    )
    monkeypatch.setattr(tracker, "other", other, raising=False)
    other.inner = kernel(lambda x: x)
    before = made(source)
    other.inner = kernel(lambda x: x + 1)
    assert made(source) != before


def test_a_kernel_that_calls_itself_has_one():
    recursive = SOURCE.replace("return x + 1", "return x + 1 if x > 3 else inner(x + 1)")
    assert made(recursive) == made(recursive) != made(SOURCE)


def test_a_mutable_global_is_rejected():
    with pytest.raises(TypeError, match="list"):
        made(SOURCE.replace("SCALE = 2.0", "SCALE = [2.0]"))
