"""The library of compiled kernels: dispatch by types, and the fallback."""

import sys
import threading
import time
import types
from concurrent.futures import ThreadPoolExecutor
from importlib.machinery import EXTENSION_SUFFIXES
from typing import NamedTuple

import numpy as np
import pytest

from tracker.kernels import parts
from tracker.kernels.arrays import Vector
from tracker.kernels.decorator import kernel
from tracker.kernels.fingerprint import fingerprint
from tracker.kernels.library import Library, load
from tracker.kernels.signature import word

dispatch = pytest.importorskip(
    "tracker.kernels._dispatch", reason="the library was not built: no C++ compiler here"
)


class State(NamedTuple):
    x: Vector
    y: float


class Other(NamedTuple):
    x: Vector
    y: float


def total(x: Vector, k: int = 1) -> float:
    return float(np.sum(x) * k)


def library_with(function):
    """A library in which ``function`` is the compiled code of `total`."""
    symbols = types.SimpleNamespace(k0=function)
    name, made_of = f"{total.__module__}.{total.__qualname__}", fingerprint(total, {})
    return Library(dispatch.Kernel, [(symbols, f"# by hand\nk0 {made_of} {name} f8[1C] i8\n")])


def taking(words):
    made = dispatch.Kernel(None)
    made.add(words, lambda *args: "compiled")
    return made


IMAGE = np.zeros((4, 4, 3), np.uint8)
VALUES = {
    "b1": [True, np.bool_(1)],
    "i1": [np.int8(1)],
    "f4": [np.float32(1)],
    "c16": [1j, np.complex128(1)],
    "f8[1C]": [np.zeros(3), np.zeros(4)[:2]],
    "f8[2C]": [np.zeros((2, 3)), np.zeros((0, 3))],
    "i8[2F]": [np.zeros((2, 3), int).T],
    "u1[3A]": [IMAGE, IMAGE[::2], IMAGE.swapaxes(0, 1)],
    "(f8,(b1))": [(1.0, (True,))],
    word(State): [State(np.zeros(2), 1.0)],
}
STRANGERS = [
    "word", None, [1.0], 2**70, np.zeros(2, ">f8"), np.zeros((2, 2), "i2"), np.zeros(4)[::2],
    np.zeros(1, np.complex64), Other(np.zeros(2), 1.0), (1.0, 2.0), (),
]  # fmt: skip


@pytest.mark.parametrize("words", VALUES)
def test_a_function_runs_for_its_own_types_only(words):
    made = taking(words)
    for value in VALUES[words]:
        assert made(value) == "compiled"
        assert not made.finds(value, value) and not made.finds()
    others = [v for other, values in VALUES.items() if other != words for v in values]
    if words in ("f4", "c16"):
        others = [v for v in others if type(v) in (np.ndarray, tuple, State)]
    if words == "i1":
        others.append(1)  # may be too large
    for value in [*others, *STRANGERS]:
        assert not made.finds(value)


@pytest.mark.parametrize(
    ("words", "fitting", "others"),
    [
        ("f8", [1.0, 2, True, np.float64(1), np.float32(1), np.int32(1), np.uint64(1)], [1j, "1"]),
        ("i8", [1, True, np.int64(1), np.int16(1), np.uint32(1)], [1.0, np.uint64(1), 2**63]),
    ],
)
def test_integers_and_bools_are_converted_as_in_python(words, fitting, others):
    assert all(taking(words).finds(value) for value in fitting)
    assert not any(taking(words).finds(value) for value in others)


def test_a_read_only_array_is_accepted_only_where_nothing_is_written():
    frozen = np.zeros(3)
    frozen.setflags(write=False)
    assert taking("f8[1C]").finds(frozen)
    assert not taking("f8[1Cw]").finds(frozen)
    assert taking("f8[1Cw]").finds(np.zeros(3))
    assert taking("a.S(x:f8[1C],P:f8[1C])").finds(types_of_s(frozen, frozen))
    assert not taking("a.S(x:f8[1C],P:f8[1Cw])").finds(types_of_s(frozen, frozen))


def types_of_s(x, P):
    class S(NamedTuple):
        x: object
        P: object

    return S(x, P)


def test_a_kernel_has_one_function():
    with pytest.raises(ValueError, match="has its function"):
        taking("f8").add("i8", total)


WORDS = [
    "f9",
    "f3",
    "c32",
    "a.B(f8",
    "i8)",
    "f8[",
    "f8[2X]",
    "(f8",
    "f8 what",
    "f8[2C",
    "x:",
]


@pytest.mark.parametrize("words", WORDS)
def test_unknown_arguments(words):
    with pytest.raises(ValueError, match="no types"):
        dispatch.Kernel(None).add(words, total)


def test_arguments_by_name():
    made = library_with(lambda x, k: ("compiled", k)).kernel(total, {})
    assert made(np.zeros(2), k=3) == ("compiled", 3)
    with pytest.raises(TypeError, match="wants x, k"):
        made(other=1)


def test_other_types_are_compiled_by_numba_and_logged(caplog):
    caplog.set_level("DEBUG", logger="tracker.kernels")
    made = library_with(lambda x, k: "compiled").kernel(total, {})
    assert made(np.ones((2, 2)).T[::2], 2) == 4.0
    assert "not in the library: total(float64[2A], int)" in caplog.text
    assert made(np.ones(2), 2) == "compiled"


def test_a_library_of_another_source_is_ignored():
    made = library_with(lambda x, k: "old").kernel(total, {"fastmath": True})
    assert made(np.ones(2), 2) == 4.0


def test_without_numba_python_runs_and_the_log_reports_it(monkeypatch, caplog):
    monkeypatch.setitem(sys.modules, "tracker.kernels.jit", None)
    made = Library(dispatch.Kernel, []).kernel(total, {})
    assert made(np.ones(3), 2) == 6.0
    assert "runs uncompiled" in caplog.text


def test_threads_may_call_a_kernel_for_the_first_time_concurrently(monkeypatch):
    made = library_with(lambda x, k: "compiled").kernel(total, {})
    fill, together = Library._fill, threading.Barrier(2)

    def slowly(self, kernel):
        together.wait(60.0)  # the other one is about to ask
        time.sleep(0.05)
        fill(self, kernel)

    monkeypatch.setattr(Library, "_fill", slowly)
    with ThreadPoolExecutor(1) as pool:
        other = pool.submit(made, np.ones(2), 2)
        together.wait(60.0)
        assert made(np.ones(2), 2) == other.result() == "compiled"


def test_an_exception_inside_is_raised():
    def fails(x, k):
        raise ZeroDivisionError("from the kernel")

    made = library_with(fails).kernel(total, {})
    with pytest.raises(ZeroDivisionError, match="from the kernel"):
        made(np.ones(2), 2)


def test_numba_can_call_a_kernel_of_the_library():
    from numba import njit

    made = Library(dispatch.Kernel, []).kernel(total, {})
    assert njit(lambda x: made(x, 3))(np.ones(2)) == 6.0


def test_a_missing_library_is_not_an_error(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    assert load() is None


def test_an_outdated_library_is_not_an_error(monkeypatch):
    """An updated checkout without `make`: the program crashed at start."""
    assert load() is not None
    monkeypatch.delattr(dispatch, "runs_wide")
    assert load() is None


def test_a_table_without_its_module_is_not_an_error(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    parts.table_of("tracker_lost").write_text("# by hand\n", "utf-8")
    assert parts.built() == ["tracker_lost"]
    assert load() is None


def test_a_part_is_rebuilt_if_its_table_changes_or_its_module_is_missing(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    module = tmp_path / f"_compiled_tracker_vision{EXTENSION_SUFFIXES[0]}"
    assert not parts.is_built("tracker_vision", "as made")
    parts.table_of("tracker_vision").write_text("as made", "utf-8")
    assert not parts.is_built("tracker_vision", "as made")
    module.touch()
    assert parts.is_built("tracker_vision", "as made")
    assert not parts.is_built("tracker_vision", "as it would be")


def test_obsolete_parts_are_removed(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    names = ["_compiled_app_widgets.so", "_compiled_tracker_old.so", "_compiled_tracker_old.txt"]
    for name in [*names, "_compiled.so", "_dispatch.so", "library.py"]:
        (tmp_path / name).touch()
    parts.remove_others([parts.part_of("app.widgets.view3d.raster.image.draw")])
    left = sorted(path.name for path in tmp_path.iterdir())
    assert left == ["_compiled_app_widgets.so", "_dispatch.so", "library.py"]


def test_the_decorator_keeps_name_and_docstring():
    @kernel(error_model="numpy")
    def half(x: float) -> float:
        """Half of x."""
        return x / 2

    assert (half.__name__, half.__doc__) == ("half", "Half of x.")
    assert half(3.0) == 1.5


def test_a_library_detects_whether_it_is_up_to_date():
    library = library_with(lambda x, k: 0.0)
    assert library.is_current()  # none of its kernels was created yet
    library.kernel(total, {})
    assert library.is_current()
    library.kernel(total, {"fastmath": True})
    assert not library.is_current()
