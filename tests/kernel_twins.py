"""Each kernel against its plain twin: the same source, run by Python and numpy.

To be imported before any kernel. The first call of a kernel for each line of signatures.txt, out
of a test's own thread and with arrays of no more than ``most`` numbers, is made twice: compiled,
and plain with all kernels that it calls plain too. Results and what was written into arguments must
agree. A run of all tests fails where a kernel of the list was never compared. Programs that tests
start are not concerned.
"""

from __future__ import annotations

import copy
import functools
import os
import threading
from collections import defaultdict
from pathlib import Path
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tracker.kernels import decorator
from tracker.kernels.fingerprint import OURS, is_kernel
from tracker.kernels.kinds import UnknownKindError, kinds_of
from tracker.kernels.mode import MODE
from tracker.kernels.record import SIGNATURES

DONE = "GLOVETRACK_KERNELS_COMPARED"
"""Environment variable: a file that all processes of a run add lines of signatures.txt to."""

MOST = 100_000
"""Numbers in all arrays of a call: Python takes microseconds for each."""

CLOSE = 1e-9
"""Relative to the largest number of an array: sums in another order, and another LAPACK."""

CLOSE_FAST = 1e-4
"""The same with fast-math, where images are drawn in single precision."""

OTHERWISE = {
    "tracker.vision.hue_table._fill_table": "16 million colours; test_detector asks OpenCV",
}
"""Kernels that Python would take minutes for, and what stands for their twin."""


class Twins:
    """Compares; ``most`` may be raised for a while, where a test knows its arrays to be small."""

    def __init__(self) -> None:
        self.most = MOST
        self._plain: dict[Any, FunctionType] = {}
        self._open: dict[str, set[str]] = defaultdict(set)  # kinds by kernel, not yet compared here
        for line in SIGNATURES.read_text("utf-8").splitlines():
            name, _, kinds = line.partition(" ")
            if name not in OTHERWISE:
                self._open[name].add(kinds)

    def install(self) -> None:
        """Every kernel that is made from now on is compared."""
        make = decorator._make
        decorator._make = lambda function, options: self._compared(make(function, options))

    def _compared(self, kernel: Any) -> Any:
        wanted = self._open.get(_name(kernel))
        return Compared(kernel, wanted, self) if wanted else kernel

    def is_small(self, args: tuple[Any, ...]) -> bool:
        return _numbers(args) <= self.most

    def compare(self, kernel: Any, kinds: str, args: tuple[Any, ...]) -> Any:
        """The kernel's result, if the twin's is the same."""
        line = f"{_name(kernel)} {kinds}"
        theirs = copy.deepcopy(args)
        result = kernel(*args)
        with np.errstate(all="ignore"):
            expected = self._twin(kernel)(*theirs)
        close = CLOSE_FAST if kernel.options.get("fastmath") else CLOSE
        assert_same(result, expected, close, f"{line}: result")
        assert_same(args, theirs, close, f"{line}: argument")
        with Path(os.environ[DONE]).open("a", encoding="utf-8") as done:
            done.write(f"{line}\n")
        return result

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
            return lambda *args: self._twin(value)(*args)
        if isinstance(value, ModuleType) and value.__name__.partition(".")[0] in OURS:
            inside = {k: v for k, v in vars(value).items() if not isinstance(v, ModuleType)}
            return SimpleNamespace(**{k: self._uncompiled(v) for k, v in inside.items()})
        return value


TWINS = Twins()
TWINS.install()


class Compared:
    """A kernel, some calls of which are compared; in all else the kernel itself."""

    def __init__(self, kernel: Any, wanted: set[str], twins: Twins) -> None:
        functools.update_wrapper(self, kernel.py_func)
        self._kernel, self._wanted, self._twins = kernel, wanted, twins

    def __call__(self, *args: Any, **named: Any) -> Any:
        kinds = self._new(args) if self._wanted and not named else None
        if kinds is None:
            return self._kernel(*args, **named)
        self._wanted.remove(kinds)
        return self._twins.compare(self._kernel, kinds, args)

    def _new(self, args: tuple[Any, ...]) -> str | None:
        """Kinds of a call that is to be compared."""
        if threading.current_thread() is not threading.main_thread():
            return None
        if not self._twins.is_small(args):
            return None
        try:
            kinds = kinds_of(args)
        except UnknownKindError:
            return None
        return kinds if kinds in self._wanted else None

    def __getattr__(self, name: str) -> Any:
        return getattr(self._kernel, name)


def _name(kernel: Any) -> str:
    """As signatures.txt has it."""
    return f"{kernel.py_func.__module__}.{kernel.py_func.__qualname__}"


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

    def __init__(self, done: Path) -> None:
        self._done = done
        self._missing: list[str] = []

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        done = set(self._done.read_text("utf-8").splitlines()) if self._done.exists() else set()
        lines = SIGNATURES.read_text("utf-8").splitlines()
        self._missing = [x for x in lines if x not in done and x.split(" ")[0] not in OTHERWISE]
        if self._missing and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        if self._missing:
            terminalreporter.section("kernels that were not compared with their twins")
            terminalreporter.write_line("\n".join(self._missing))
            terminalreporter.write_line(
                "Lines that nothing calls any more go by `make signatures`."
            )


def register(config: pytest.Config, folder: Path) -> None:
    """Workers add to one file; whether all is in it is asked after a run of all tests."""
    if hasattr(config, "workerinput"):
        return
    os.environ[DONE] = str(folder / "kernels_compared.txt")
    every = config.args == config.getini("testpaths") and not config.option.keyword
    listing = os.environ.get(MODE) == "record"  # the list itself is being made anew
    if every and not config.option.markexpr and not listing:
        config.pluginmanager.register(EveryKernel(Path(os.environ[DONE])), "every_kernel")
