"""``python -m tests.benchmarks.kernels``: the kernels that cost most, by the ways to compile them.

One second of data with images is tracked, and the time in each kernel that Python calls is added
up. The most expensive ones are then called with the arguments of that second as the library has
them, and as numba compiles them on their first call, for this processor.
"""

from __future__ import annotations

import argparse
import functools
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, ClassVar, NamedTuple

import numpy as np

from tracker.kernels import decorator, jit

KEPT = 7
"""Calls of a kernel whose arguments are kept, of its first and each tenth."""
MOST_S = 0.05  # for each way and kernel
IMAGES = 6


class Timed:
    """A kernel that measures its calls and keeps the arguments of some."""

    made: ClassVar[list[Timed]] = []

    def __init__(self, kernel: Any) -> None:
        functools.update_wrapper(self, kernel.py_func)
        self.kernel, self.calls, self.seconds = kernel, 0, 0.0
        self.kept: list[tuple[Any, ...]] = []
        Timed.made.append(self)

    def __call__(self, *args: Any, **named: Any) -> Any:
        if not named and self.calls % 10 == 0 and len(self.kept) < KEPT:
            self.kept.append(copied(args))
        start = time.perf_counter()
        result = self.kernel(*args, **named)
        self.seconds += time.perf_counter() - start
        self.calls += 1
        return result

    def __getattr__(self, name: str) -> Any:
        return getattr(self.kernel, name)


class Row(NamedTuple):
    """Calls in the second of data, and µs per call of each way."""

    name: str
    calls: int
    library: float
    numba: float


def copied(value: Any) -> Any:
    """The argument with arrays of its own: kernels write to some."""
    if isinstance(value, np.ndarray):
        return value.copy(order="K")
    if isinstance(value, tuple):
        inside = [copied(v) for v in value]
        return type(value)(*inside) if hasattr(value, "_fields") else tuple(inside)
    return value


def fastest(function: Callable[..., Any], kept: Sequence[tuple[Any, ...]], most_s: float) -> float:
    """Mean over the kept arguments of the fastest call with each, in µs."""
    function(*copied(kept[0]))  # it may be compiled now
    best = np.full(len(kept), np.inf)
    end = time.perf_counter() + most_s
    while True:
        for k, args in enumerate(kept):
            own = copied(args)
            start = time.perf_counter()
            function(*own)
            best[k] = min(best[k], time.perf_counter() - start)
        if time.perf_counter() > end:
            return float(1e6 * best.mean())


def measure(count: int) -> list[Row]:
    """The most expensive kernels, that with the most time first."""
    make = decorator._make
    decorator._make = lambda function, options: Timed(make(function, options))
    from tests.benchmarks import schedule  # it imports the kernels

    second = schedule.make_second(images=IMAGES)
    calls = (
        schedule.pipeline_call(second, "chain"),
        schedule.detection_call(second, schedule._profile()),
    )
    for call in calls:
        call()
    for kernel in Timed.made:
        kernel.calls, kernel.seconds, kernel.kept = 0, 0.0, []
    for call in calls:
        call()
    called = [kernel for kernel in Timed.made if kernel.kept]
    return [_row(kernel) for kernel in sorted(called, key=lambda k: -k.seconds)[:count]]


def _row(timed: Timed) -> Row:
    function = timed.py_func
    by_numba = jit.compiled(function, timed.options)
    us = [fastest(way, timed.kept, MOST_S) for way in (timed.kernel, by_numba)]
    return Row(f"{function.__module__}.{function.__name__}", timed.calls, *us)


def main(arguments: Sequence[str] | None = None) -> int:
    """The command; returns the exit code."""
    p = argparse.ArgumentParser(prog="python -m tests.benchmarks.kernels")
    p.add_argument("--rows", type=int, default=20, help="kernels to show")
    rows = measure(p.parse_args(arguments).rows)
    print("| kernel | calls | library, µs | numba, µs | library / numba |")
    print("|---|--:|--:|--:|--:|")
    for r in rows:
        times = f"{r.library:.1f} | {r.numba:.1f} | {r.library / r.numba:.2f}"
        print(f"| `{r.name}` | {r.calls} | {times} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
