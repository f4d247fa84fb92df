"""Compiled functions: one decorator, and their compilation ahead of time.

    @kernel
    def norm(v: Vector) -> float: ...

A kernel is a function of numbers, arrays and tuples of them that numba can compile. Where the
library (`tracker.kernels.build`) contains it for the given types, that code runs and numba is not
even imported; otherwise numba compiles it and caches the result; without numba it runs as plain
Python, slowly, and the log reports it. Kernels release the GIL, use one thread and, except for the
simulator's images, no fast-math: same input, same output.
"""

from tracker.kernels.decorator import are_compiled, compiler, kernel

__all__ = ["are_compiled", "compiler", "kernel"]
