"""The library of compiled kernels: what runs for which types, and what runs in place of it."""

import importlib
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
from tracker.kernels.decorator import kernel
from tracker.kernels.fingerprint import fingerprint
from tracker.kernels.kinds import kinds_of
from tracker.kernels.library import Library, load
from tracker.kernels.record import SIGNATURES, Recorded, merge

dispatch = pytest.importorskip(
    "tracker.kernels._dispatch", reason="the library was not built: no C++ compiler here"
)


class State(NamedTuple):
    x: object
    y: object


class Other(NamedTuple):
    x: object
    y: object


def total(x, k=1):
    return float(np.sum(x) * k)


def library_with(**functions):
    """A library in which ``functions`` stand for compiled ones, by kinds with _ for blanks."""
    symbols = types.SimpleNamespace(**{f"k{i}": f for i, f in enumerate(functions.values())})
    made_of = fingerprint(total, {})
    name = f"{total.__module__}.{total.__qualname__}"
    kinds = [k.replace("_", " ") for k in functions]
    lines = ["# by hand", *(f"k{i} {made_of} {name} {k}" for i, k in enumerate(kinds))]
    return Library(dispatch.Kernel, [(symbols, "\n".join(lines))])


@pytest.mark.parametrize(
    "args",
    [
        (np.zeros(3), 1), (np.zeros((2, 3)), 1.0), (np.zeros((2, 3)).T, True), ((1, 2.0), None),
        (np.zeros(4)[::2], np.int32(1)), (np.zeros(4, np.float32), np.float32(1)), ((), ()),
        (np.zeros((2, 2, 2), np.uint8), ((1, np.zeros(2)), 3)),
        (State(np.zeros(2), 1.0), 1j), (np.zeros(3, complex), (State(1, 2), np.complex64(2))),
    ],
    ids=kinds_of,
)  # fmt: skip
def test_a_function_runs_for_its_own_types_and_no_others(args):
    made = dispatch.Kernel(None)
    made.add(kinds_of(args), lambda *a: "compiled")
    assert made(*args) == "compiled"
    others = [
        Other(*args[0]) if type(args[0]) is State else 0j,
        np.zeros((2, 2), "i2"),
        "word",
        np.zeros(2, ">f8"),
        (1, 2),
        2**70,
        np.int8(1),
    ]
    for other in others:
        assert not made.finds(other, args[1])
        assert not made.finds(args[0], other)
    assert not made.finds(*args, 1)
    assert not made.finds(args[0])


def test_a_read_only_array_goes_only_where_nothing_is_written():
    frozen, made = np.zeros(3), dispatch.Kernel(None)
    frozen.setflags(write=False)
    made.add("f8[1C]", lambda x: "may write")
    assert not made.finds(frozen)
    made.add("f8[1Cr]", lambda x: "only reads")
    assert made(frozen) == "only reads"
    assert made(np.zeros(3)) == "may write"


WORDS = ["f9", "f3", "c32", "a.B(f8", "i8)", "f8[", "f8[2X]", "(f8", "f8 what", "f8[2C"]


@pytest.mark.parametrize("words", WORDS)
def test_words_that_are_none(words):
    with pytest.raises(ValueError, match="no kinds"):
        dispatch.Kernel(None).add(words, total)


def test_the_narrowest_function_is_taken():
    functions = {"f8[1A]_i8": lambda x, k: "any", "f8[1C]_i8": lambda x, k: "in a row"}
    made = library_with(**functions).kernel(total, {})
    assert made(np.zeros(3), 1) == "in a row"
    assert made(np.zeros(6)[::2], 1) == "any"


def test_arguments_by_name():
    made = library_with(**{"f8[1C]_i8": lambda x, k: ("compiled", k)}).kernel(total, {})
    assert made(np.zeros(2), k=3) == ("compiled", 3)
    with pytest.raises(TypeError, match="wants x, k"):
        made(other=1)


def test_other_types_are_compiled_by_numba():
    made = library_with(**{"f8[1C]_i8": lambda x, k: "compiled"}).kernel(total, {})
    assert made(np.ones((2, 2)), 2) == 8.0
    assert made(np.ones(2), 2) == "compiled"


def test_a_library_of_another_source_is_left_alone():
    made = library_with(**{"f8[1C]_i8": lambda x, k: "old"}).kernel(total, {"fastmath": True})
    assert made(np.ones(2), 2) == 4.0


def test_without_numba_python_itself_runs_and_the_log_says_so(monkeypatch, caplog):
    monkeypatch.setitem(sys.modules, "tracker.kernels.jit", None)
    made = library_with().kernel(total, {})
    assert made(np.ones(3), 2) == 6.0
    assert "runs uncompiled" in caplog.text


def test_threads_may_call_a_kernel_for_the_first_time_together(monkeypatch):
    made = library_with(**{"f8[1C]_i8": lambda x, k: "compiled"}).kernel(total, {})
    fill, together = Library._fill, threading.Barrier(2)

    def slowly(self, kernel):
        together.wait(5.0)  # the other one is about to ask
        time.sleep(0.05)
        fill(self, kernel)

    monkeypatch.setattr(Library, "_fill", slowly)
    with ThreadPoolExecutor(1) as pool:
        other = pool.submit(made, np.ones(2), 2)
        together.wait(5.0)
        assert made(np.ones(2), 2) == other.result() == "compiled"


def test_a_failure_inside_comes_out():
    def fails(x, k):
        raise ZeroDivisionError("as the kernel said")

    made = library_with(**{"f8[1C]_i8": fails}).kernel(total, {})
    with pytest.raises(ZeroDivisionError, match="as the kernel said"):
        made(np.ones(2), 2)


def test_numba_can_call_a_kernel_of_the_library():
    from numba import njit

    made = library_with().kernel(total, {})
    assert njit(lambda x: made(x, 3))(np.ones(2)) == 6.0


def test_no_library_is_no_failure(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    assert load() is None


def test_a_table_without_its_module_is_no_failure(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    parts.table_of("tracker_lost").write_text("# by hand\n", "utf-8")
    assert parts.built() == ["tracker_lost"]
    assert load() is None


def test_a_part_is_made_anew_when_its_table_would_be_another_or_its_module_is_gone(
    monkeypatch, tmp_path
):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    module = tmp_path / f"_compiled_tracker_vision{EXTENSION_SUFFIXES[0]}"
    assert not parts.is_built("tracker_vision", "as made")
    parts.table_of("tracker_vision").write_text("as made", "utf-8")
    assert not parts.is_built("tracker_vision", "as made")
    module.touch()
    assert parts.is_built("tracker_vision", "as made")
    assert not parts.is_built("tracker_vision", "as it would be")


def test_parts_that_are_no_more_are_removed(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "HERE", tmp_path)
    names = ["_compiled_app_widgets.so", "_compiled_tracker_old.so", "_compiled_tracker_old.txt"]
    for name in [*names, "_compiled.so", "_dispatch.so", "library.py"]:
        (tmp_path / name).touch()
    parts.remove_others([parts.part_of("app.widgets.view3d.raster.image.draw")])
    left = sorted(path.name for path in tmp_path.iterdir())
    assert left == ["_compiled_app_widgets.so", "_dispatch.so", "library.py"]


@pytest.mark.parametrize("line", SIGNATURES.read_text("utf-8").splitlines())
def test_the_shipped_list_names_kernels_with_as_many_arguments(line):
    name, *kinds = line.split(" ")
    module, _, function = name.rpartition(".")
    made = getattr(importlib.import_module(module), function)
    assert made.py_func.__code__.co_argcount == len(kinds)


def test_recording_notes_each_kind_of_call_once(monkeypatch, tmp_path):
    calls = tmp_path / "calls.txt"
    monkeypatch.setenv("GLOVETRACK_KERNEL_CALLS", str(calls))
    from tracker.kernels.jit import compiled

    made = Recorded(compiled(total, {}, cache=False))
    for x in (np.ones(2), np.ones(3), np.ones((2, 2))):
        made(x, 1)
    name = f"{total.__module__}.total"
    noted = calls.read_text("utf-8").splitlines()
    assert noted == [f"{name} f8[1C] i8", f"{name} f8[2C] i8"]
    assert made.__name__ == "total"


def test_the_list_has_each_call_once_and_none_of_a_test(tmp_path):
    files = [tmp_path / "a.txt", tmp_path / "b.txt"]
    files[0].write_text("tracker.b.one f8\ntracker.a.two i8\n", "utf-8")
    files[1].write_text("tracker.b.one f8\ntest_something.three f8\napp.c.four f8\n", "utf-8")
    wanted = ["app.c.four f8", "tracker.a.two i8", "tracker.b.one f8"]
    assert merge(*map(str, files)) == wanted


def test_the_decorator_keeps_name_and_words():
    @kernel(error_model="numpy")
    def half(x):
        """Half of x."""
        return x / 2

    assert (half.__name__, half.__doc__) == ("half", "Half of x.")
    assert half(3.0) == 1.5
