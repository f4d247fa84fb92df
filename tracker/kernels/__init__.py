"""Compiled functions: one decorator, and how they are compiled before they are needed.

    @kernel
    def norm(v: Vector) -> float: ...

A kernel is a function of numbers, arrays and tuples of them that numba can compile. Where the
library (`tracker.kernels.build`) holds it for the types at hand, that code runs and numba
is not even imported; otherwise numba compiles it and caches what it compiled; without numba it runs
as the Python it is, slowly, and the log says so. Kernels release Python's lock, use one thread and,
but for the simulator's images, no fast-math: same input, same output.
"""

from tracker.kernels.decorator import are_compiled, compiler, kernel

__all__ = ["are_compiled", "compiler", "kernel"]
