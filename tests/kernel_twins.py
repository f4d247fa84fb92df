"""Each kernel against its plain twin: the same source, run by Python and numpy.

To be imported before any kernel. A kernel's first call of a run out of a test's own thread, with
arrays of no more than ``most`` numbers, is made twice: compiled, and plain with all kernels that it
calls plain too. Results and what was written into arguments must agree, and plain kernels can write
only to what their annotations say they write to. A run of all tests fails where a kernel that
Python calls was never compared, and where the product calls one with other types than those that it
was compiled for: a user would wait for a compiler there. Programs that tests start are not
concerned.

A kernel that only other kernels call runs as plain Python if a test calls it with small arrays.
In the product it is compiled only as part of other kernels, and is compared there; numba would take
up to 13 s to compile it separately in each process.
"""

from __future__ import annotations

import functools
import os
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

from tracker.kernels import decorator, exported, library, signature
from tracker.kernels.fingerprint import is_kernel, is_ours

DONE = "GLOVETRACK_KERNELS_COMPARED"
"""Environment variable: a file that all processes of a run add kernels' names to."""

MISFITS = "GLOVETRACK_KERNELS_MISFITS"
"""Environment variable: a file of the calls whose types no compiled kernel fits."""

PACKAGE = str(Path(decorator.__file__).parents[1].parent)

MOST = 100_000
"""Numbers in all arrays of a call: Python takes microseconds for each."""

FEW = 5_000
"""The same, where Python alone does the work."""

CLOSE = 1e-9
"""Relative to the largest number of an array: sums in another order, and another LAPACK."""

CLOSE_FAST = 1e-4
"""The same with fast-math, where images are drawn in single precision."""

USUAL = "not long"
"""The selection of `make test`: it too compares every kernel."""

OTHERWISE = {
    "tracker.vision.hue_table._fill_table": "16 million colours; test_detector asks OpenCV",
}
"""Kernels for which Python would take minutes, and their substitutes."""


class Twins:
    """Compares; ``most`` may be raised for a while, where a test knows its arrays to be small."""

    def __init__(self) -> None:
        self.most = MOST
        self._plain: dict[Any, FunctionType] = {}

    def install(self) -> None:
        """Every kernel of the product that is made from now on is compared."""
        make = decorator._make
        decorator._make = lambda function, options: self._compared(make(function, options))
        fallback = library.Library._fallback
        library.Library._fallback = lambda of, kernel: _noted(of, kernel, fallback(of, kernel))

    def _compared(self, kernel: Any) -> Any:
        name = _name(kernel)
        wanted = is_ours(name) and name not in OTHERWISE
        return Compared(kernel, self) if wanted else kernel

    def is_small(self, args: tuple[Any, ...]) -> bool:
        return _numbers(args) <= self.most

    def was_compared(self, kernel: Any) -> bool:
        """Whether another process of this run has compared the kernel already; one comparison is
        sufficient."""
        done, name = Path(os.environ[DONE]), _name(kernel)
        return is_ours(name) and done.exists() and name in done.read_text("utf-8").splitlines()

    def compare(self, kernel: Any, args: tuple[Any, ...]) -> Any:
        """The kernel's result, if the twin's is the same."""
        name = _name(kernel)
        theirs = _guarded(kernel.py_func, args, _copy)
        result = kernel(*args)
        with np.errstate(all="ignore"):
            expected = self._twin(kernel)(*theirs)
        close = CLOSE_FAST if kernel.options.get("fastmath") else CLOSE
        assert_same(result, expected, close, f"{name}: result")
        assert_same(args, theirs, close, f"{name}: argument")
        with Path(os.environ[DONE]).open("a", encoding="utf-8") as done:
            done.write(f"{name}\n")
        return result

    def plain(self, kernel: Any, args: tuple[Any, ...]) -> Any:
        """What the twin makes of ``args``, with what it writes in them."""
        with np.errstate(all="ignore"):
            return self._twin(kernel)(*_guarded(kernel.py_func, args, _view))

    def _twin(self, kernel: Any) -> FunctionType:
        """A kernel's Python function in a world without compiled kernels."""
        function = kernel.py_func
        if function not in self._plain:
            world: dict[str, Any] = {}
            made = FunctionType(function.__code__, world, function.__name__, function.__defaults__)
            self._plain[function] = made  # before its world: kernels may call themselves
            world.update({k: self._uncompiled(v) for k, v in function.__globals__.items()})
        return self._plain[function]

    def _uncompiled(self, value: Any) -> Any:
        """What a twin sees in place of a global value."""
        if is_kernel(value):
            return lambda *args: self._twin(value)(*_guarded(value.py_func, args, _view))
        if isinstance(value, ModuleType) and is_ours(value.__name__):
            inside = {k: v for k, v in vars(value).items() if not isinstance(v, ModuleType)}
            return SimpleNamespace(**{k: self._uncompiled(v) for k, v in inside.items()})
        return value


TWINS = Twins()
TWINS.install()


class Compared:
    """A kernel whose first call is compared; in all else the kernel itself."""

    def __init__(self, kernel: Any, twins: Twins) -> None:
        functools.update_wrapper(self, kernel.py_func)
        self._kernel, self._twins, self._is_done = kernel, twins, False

    def __call__(self, *args: Any, **named: Any) -> Any:
        if self._runs_plain and not named and _numbers(args) <= FEW:
            return self._twins.plain(self._kernel, args)
        if self._is_done or named or not self._can_be_compared(args):
            return self._kernel(*args, **named)
        self._is_done = True
        if self._twins.was_compared(self._kernel):
            return self._kernel(*args)
        return self._twins.compare(self._kernel, args)

    @functools.cached_property
    def _runs_plain(self) -> bool:
        """Only kernels call it; asked of the source where the library has not got it."""
        name, made = _name(self._kernel), decorator._library()
        if made is None or not is_ours(name) or name in made._entries:
            return False
        return name not in _exported()

    def _can_be_compared(self, args: tuple[Any, ...]) -> bool:
        in_test = threading.current_thread() is threading.main_thread()
        return in_test and self._twins.is_small(args)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._kernel, name)


def _noted(of: library.Library, kernel: Any, run: Callable[..., Any]) -> Callable[..., Any]:
    """``run``, and that it was needed although the kernel is in the library."""
    held = library._name(kernel)
    if held not in of._entries or not of._is_of_its_source(kernel):
        return run

    def note(*args: Any) -> Any:
        caller = _caller()
        if MISFITS in os.environ and caller.startswith(PACKAGE) and "/tests/" not in caller:
            types = ", ".join(library._described(arg) for arg in args)
            with Path(os.environ[MISFITS]).open("a", encoding="utf-8") as misfits:
                misfits.write(f"{caller}: {held}({types})\n")
        return run(*args)

    return note


def _caller() -> str:
    """The file and line that calls a kernel."""
    frame = sys._getframe(2)
    while frame.f_back is not None and frame.f_code.co_filename in (__file__, library.__file__):
        frame = frame.f_back
    return f"{frame.f_code.co_filename}:{frame.f_lineno}"


@functools.cache
def _exported() -> frozenset[str]:
    """As the first process of this run to ask has found: it takes a second or two."""
    found = Path(os.environ[DONE]).with_name("kernels_exported.txt")
    if not found.exists():
        part = found.with_suffix(f".{os.getpid()}")
        part.write_text("\n".join(exported.exported()), "utf-8")
        part.replace(found)
    return frozenset(found.read_text("utf-8").splitlines())


def _name(kernel: Any) -> str:
    return f"{kernel.py_func.__module__}.{kernel.py_func.__qualname__}"


class Guard(NamedTuple):
    """One argument as described by a kernel's annotation."""

    may_write: bool
    members: tuple[Guard, ...]  # of a tuple


def _guarded(function: Any, args: tuple[Any, ...], other: Callable[[Any], Any]) -> tuple[Any, ...]:
    """``other`` arrays in place of those given, that are writable where the kernel requires it."""
    pairs = zip(args, _guards(function), strict=False)  # what is not given has its default
    return tuple(_guard(value, guard, other) for value, guard in pairs)


@functools.cache
def _guards(function: Any) -> tuple[Guard, ...]:
    return tuple(_guard_of(annotation) for annotation in signature.parameters(function).values())


def _guard_of(annotation: Any, written: bool = False) -> Guard:
    written = written or signature.is_written(annotation)
    inside = signature.members(annotation) or ()
    return Guard(written, tuple(_guard_of(member, written) for _, member in inside))


def _guard(value: Any, guard: Guard, other: Callable[[Any], Any]) -> Any:
    if isinstance(value, np.ndarray):
        made = other(value)
        made.setflags(write=guard.may_write and made.flags.writeable)
        return made
    if isinstance(value, tuple):
        made = [_guard(v, m, other) for v, m in zip(value, guard.members, strict=True)]
        return type(value)(*made) if hasattr(value, "_fields") else tuple(made)
    return value


def _copy(array: np.ndarray) -> np.ndarray:
    return array.copy()


def _view(array: np.ndarray) -> np.ndarray:
    return array.view()


def _numbers(value: Any) -> int:
    if isinstance(value, np.ndarray):
        return value.size
    return sum(_numbers(v) for v in value) if isinstance(value, tuple) else 0


def assert_same(ours: Any, theirs: Any, close: float, where: str) -> None:
    """Numbers, arrays and tuples of them agree to a share of the largest."""
    if isinstance(ours, tuple):
        assert len(ours) == len(theirs), where
        for i, (a, b) in enumerate(zip(ours, theirs, strict=True)):
            assert_same(a, b, close, f"{where} {i}")
    elif ours is None or theirs is None:
        assert ours is theirs, where
    else:
        a, b = _comparable(ours), _comparable(theirs)
        scale = np.max(np.abs(b[np.isfinite(b)]), initial=0.0)
        np.testing.assert_allclose(a, b, rtol=close, atol=close * scale, err_msg=where)


def _comparable(value: Any) -> np.ndarray:
    array = np.asarray(value)
    return array if array.dtype.kind in "fc" else array.astype(float)


class EveryKernel:
    """A plugin of the process that has started the workers."""

    def __init__(self, done: Path, misfits: Path) -> None:
        self._done, self._noted = done, misfits
        self._missing: list[str] = []
        self._misfits: list[str] = []

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if self._noted.exists():
            self._misfits = sorted(set(self._noted.read_text("utf-8").splitlines()))
        done = set(self._done.read_text("utf-8").splitlines()) if self._done.exists() else set()
        self._missing = sorted(_exported() - done - OTHERWISE.keys())
        if (self._missing or self._misfits) and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        if self._missing:
            terminalreporter.section("kernels that were not compared with their twins")
            terminalreporter.write_line("\n".join(self._missing))
        if self._misfits:
            terminalreporter.section("calls of kernels with types that they were not compiled for")
            terminalreporter.write_line("\n".join(self._misfits))


def register(config: pytest.Config, folder: Path) -> None:
    """Workers add to one file; whether all is in it is asked after a run of all tests."""
    if hasattr(config, "workerinput"):
        return
    os.environ[DONE] = str(folder / "kernels_compared.txt")
    os.environ.setdefault(MISFITS, str(folder / "kernels_misfits.txt"))
    every = config.args == config.getini("testpaths") and not config.option.keyword
    if every and config.option.markexpr in ("", USUAL) and not config.option.collectonly:
        config.pluginmanager.register(
            EveryKernel(Path(os.environ[DONE]), Path(os.environ[MISFITS])), "every_kernel"
        )
