"""numba's ahead-of-time compiler still meets the requirements of `tracker.kernels.aot`.

If only this fails after an upgrade of numba, numba.pycc has changed or was removed: see
tracker/kernels/README.md, and pin numba below that version in pyproject.toml until `aot` is
updated.
"""

import builtins
import importlib.util
import shutil
import threading
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest
from numba import types

from tracker.kernels import aot, target, toolchain

pytestmark = pytest.mark.long

TINY = 1e-17
VECTOR = types.Array(types.float64, 1, "C")


def doubled(x):
    return 2.0 * x


doubled = target.declare(doubled, {})


def rounded(x):
    """Nothing, and a double with fast-math, which may reassociate 1 and -1."""
    return (x + 1.0) - 1.0


def divided(x, y):
    return x / y


def lengths(x):
    if len(x) == 0:
        raise ValueError("nothing to sum")
    return doubled(np.sum(x)), np.concatenate((x, x))


def order(x):
    return np.argsort(x, kind="mergesort")


def busy(n):
    total = 0.0
    for i in range(n):
        total += np.sin(i)
    return total


EXPORTS = {
    "exact": ((types.float64,), rounded, {}),
    "fast": ((types.float64,), rounded, {"fastmath": True}),
    "exact_again": ((types.float64,), rounded, {}),
    "python_division": ((types.float64, types.float64), divided, {}),
    "numpy_division": ((types.float64, types.float64), divided, {"error_model": "numpy"}),
    "lengths": ((VECTOR,), lengths, {}),
    "order": ((VECTOR,), order, {}),
    "busy": ((types.int64,), busy, {"nogil": True}),
    "undisturbed": ((types.int64,), busy, {"nogil": False}),
}


def compile_into(folder):
    """First an older version with fewer functions, which the complete one replaces."""
    functions = [aot.Function(name, *rest) for name, rest in EXPORTS.items()]
    code = folder / f"functions{toolchain.OBJECT}"
    toolchain.build_runtime(folder)
    for version in (functions[:1], functions):
        code.write_bytes(aot.object_code("canary", version))
        toolchain.link_module("canary", code, folder, folder)


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    if not (shutil.which("g++") or shutil.which("clang++") or shutil.which("cl")):
        pytest.skip("no C++ compiler here")
    folder = tmp_path_factory.mktemp("aot")
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:  # it does nothing else with numba
        pool.submit(compile_into, folder).result()
    spec = importlib.util.spec_from_file_location("canary", next(folder.glob("canary*")))
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


def test_each_function_keeps_its_own_options(compiled):
    assert compiled.exact(TINY) == compiled.exact_again(TINY) == 0.0
    assert compiled.fast(TINY) == TINY
    assert compiled.numpy_division(1.0, 0.0) == np.inf
    with pytest.raises(ZeroDivisionError):
        compiled.python_division(1.0, 0.0)


def test_arrays_tuples_and_errors_are_returned(compiled):
    total, twice = compiled.lengths(np.arange(3.0))
    assert total == 6.0 and np.array_equal(twice, [0.0, 1.0, 2.0, 0.0, 1.0, 2.0])
    with pytest.raises(ValueError, match="nothing to sum"):
        compiled.lengths(np.zeros(0))


def test_numbas_own_decorated_functions_are_linked(compiled):
    assert np.array_equal(compiled.order(np.array([3.0, 1.0, 2.0, 1.0])), [1, 3, 2, 0])


def turns_during(call):
    """When another thread ran, and how long the call used a processor, both in s."""
    turns, is_over = [time.perf_counter()], threading.Event()

    def tick():
        while not is_over.wait(0.002):
            turns.append(time.perf_counter())

    other = threading.Thread(target=tick)
    other.start()
    before = time.thread_time()
    call()
    held_s = time.thread_time() - before
    is_over.set()
    other.join()
    return np.array([*turns, time.perf_counter()]), held_s


def test_other_threads_run_meanwhile(compiled):
    """In a few tenths of a second; a computer with other work may not let it run the first time."""
    most = 0
    for _ in range(5):
        turns, _kept = turns_during(lambda: compiled.busy(20_000_000))
        most = max(most, len(turns))
        if most > 10:
            break
    assert most > 10


def test_other_threads_wait_while_the_gil_is_held(compiled):
    """No other thread runs for at least as long as it computed, on any loaded computer."""
    turns, held_s = turns_during(lambda: compiled.undisturbed(20_000_000))
    assert np.diff(turns).max() > 0.9 * held_s


def test_pickled_objects_are_created_once(compiled, monkeypatch):
    """Returning arrays needs no import each time: in a process with Qt, PySide's hook is Python."""
    x = np.arange(3.0)
    compiled.lengths(x)
    asked, real = [], builtins.__import__

    def counted(name, *args, **kwargs):
        asked.append(name)
        return real(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", counted)
    for _ in range(10):
        _, twice = compiled.lengths(x)
        with pytest.raises(ValueError, match="nothing to sum"):
            compiled.lengths(x[:0])
    assert "numpy" not in asked
    assert type(twice) is np.ndarray and twice[-1] == 2.0
