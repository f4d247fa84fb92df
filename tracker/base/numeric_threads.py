"""One thread for BLAS and OpenCV in our own computing.

Two BLAS threads make small products up to a hundred times slower on a loaded computer, and the last
bits of large products depend on their number. OpenCV distributes even twenty points over its
threads: a call of 20 µs waits up to 6 ms for a core that is busy. Importing the package changes
nothing: a program that uses it keeps its own settings outside our calls.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

VARIABLES = (
    "OPENBLAS_NUM_THREADS",
    "OMP_NUM_THREADS",
    "MKL_NUM_THREADS",
    "OPENCV_FOR_THREADS_NUM",
)
"""Read by these libraries when they are loaded."""


def limit_this_process() -> None:
    """One thread from now on, for a process of our own and for those that it starts."""
    for name in VARIABLES:
        os.environ.setdefault(name, "1")
    if "numpy" in sys.modules:  # its library has read them before
        from threadpoolctl import threadpool_limits

        threadpool_limits(1, "blas")
    if "cv2" in sys.modules:
        import cv2

        cv2.setNumThreads(1)


@contextmanager
def one_numeric_thread() -> Iterator[None]:
    """One thread within a ``with``; the host's settings are restored after it."""
    import cv2
    from threadpoolctl import threadpool_limits

    threads = cv2.getNumThreads()
    with threadpool_limits(1, "blas"):
        cv2.setNumThreads(1)
        try:
            yield
        finally:
            cv2.setNumThreads(threads)
