"""A kernel's signature is derived from its annotations; numba is the reference."""

import importlib
from typing import Annotated, NamedTuple

import numpy as np
import pytest
from numba import typeof
from numpy.typing import NDArray

from tracker.kernels.arrays import BoolVector, IntMatrix, Matrix, Vector, Written
from tracker.kernels.exported import exported
from tracker.kernels.numba_types import arguments, numba_type
from tracker.kernels.signature import SignatureError, check_result, parameters, signature, word

HERE = __name__
Images = Annotated[NDArray[np.uint8], "u1[3A]"]
Columns = Annotated[NDArray[np.float32], "f4[2F]"]
Numbers = Annotated[NDArray[np.complex128], "c16[1C]"]


class Levers(NamedTuple):
    near: complex
    far: complex


class State(NamedTuple):
    x: Vector
    P: Written[Matrix]
    levers: Levers


STATE = State(np.zeros(2), np.zeros((2, 2)), Levers(1j, 2j))
CASES = [
    (int, "i8", 1), (float, "f8", 1.0), (bool, "b1", True), (complex, "c16", 1j),
    (np.float32, "f4", np.float32(1)), (np.uint8, "u1", np.uint8(1)), (np.bool_, "b1", np.True_),
    (Vector, "f8[1C]", np.zeros(2)), (IntMatrix, "i8[2C]", np.zeros((2, 3), int)),
    (BoolVector, "b1[1C]", np.zeros(2, bool)), (Numbers, "c16[1C]", np.zeros(2, complex)),
    (Columns, "f4[2F]", np.zeros((2, 3), np.float32).T),
    (Images, "u1[3A]", np.zeros((4, 4, 3), np.uint8)[::2]),
    (Written[Matrix], "f8[2Cw]", np.zeros((2, 3))),
    (tuple[float, float], "(f8,f8)", (1.0, 2.0)),
    (tuple[Vector, tuple[int]], "(f8[1C],(i8))", (np.zeros(2), (1,))),
    (Levers, f"{HERE}.Levers(near:c16,far:c16)", STATE.levers),
    (State, f"{HERE}.State(x:f8[1C],P:f8[2Cw],levers:{HERE}.Levers(near:c16,far:c16))", STATE),
    (
        Written[State],
        f"{HERE}.State(x:f8[1Cw],P:f8[2Cw],levers:{HERE}.Levers(near:c16,far:c16))",
        STATE,
    ),
]  # fmt: skip


@pytest.mark.parametrize(("annotation", "expected", "value"), CASES, ids=[c[1] for c in CASES])
def test_an_annotation_has_a_word_and_numbas_type_of_its_values(annotation, expected, value):
    assert word(annotation) == expected
    assert numba_type(annotation) == typeof(value)


def test_a_signature_has_the_parameters_in_order():
    def function(b: Vector, a: float, /, *, _unused: str = "") -> None: ...

    assert signature(function) == "f8[1C] f8"
    assert list(parameters(function)) == ["b", "a"]
    assert arguments(function) == (typeof(np.zeros(2)), typeof(1.0))
    assert signature(lambda: None) == ""


class Untyped(NamedTuple):
    x: NDArray[np.float64]


VAGUE = [
    NDArray[np.float64], np.ndarray, list[int], tuple[float, ...], str, None, float | None, Untyped,
]  # fmt: skip


@pytest.mark.parametrize("annotation", VAGUE, ids=str)
def test_an_annotation_without_a_type_is_an_error_that_names_it(annotation):
    def function(x: float, y) -> None: ...

    with pytest.raises(SignatureError, match=r"function: 'y' has no annotation"):
        signature(function)
    function.__annotations__["y"] = annotation
    with pytest.raises(SignatureError, match=r"function: y: .*does not say"):
        signature(function)


def test_a_name_missing_at_run_time_is_an_error():
    def function(x: "Nowhere") -> None: ...  # noqa: F821

    with pytest.raises(SignatureError, match="Nowhere"):
        signature(function)


def test_a_kernel_called_by_python_returns_no_named_tuple():
    """In a wheel the compiled function would crash: its class has another name there."""

    def function() -> Untyped: ...

    with pytest.raises(SignatureError, match="function returns the named tuple Untyped"):
        check_result(function)


def test_results_of_kernels_that_python_calls_can_be_made_in_a_wheel():
    for name in exported():
        module, _, function = name.rpartition(".")
        check_result(getattr(importlib.import_module(module), function).py_func)
