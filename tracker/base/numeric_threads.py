"""One thread for BLAS and OpenCV in our own computing.

Two BLAS threads make small products up to a hundred times slower on a loaded computer, and the last
bits of large products depend on their number. OpenCV distributes even twenty points over its
threads: a call of 20 µs waits up to 6 ms for a core that is busy. Importing the package changes
nothing: a program that uses it keeps its own settings outside our calls.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

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
        from threadpoolctl import threadpool_limits  # deferred: not every process computes

        threadpool_limits(1, "blas")
    cv2: Any = sys.modules.get("cv2")
    if cv2 is not None:
        cv2.setNumThreads(1)


_changing = threading.Lock()
_limits = ExitStack()
_within = 0  # calls that are within `one_numeric_thread`


@contextmanager
def one_numeric_thread() -> Iterator[None]:
    """One thread within a ``with``; the host's settings are restored at the end of the last one,
    since threads of the host may call us at the same time."""
    global _within
    with _changing:
        if _within == 0:
            _limit_until(_limits)
        _within += 1
    try:
        yield
    finally:
        with _changing:
            _within -= 1
            if _within == 0:
                _limits.close()


def _limit_until(end: ExitStack) -> None:
    import cv2  # deferred: not every process computes
    from threadpoolctl import threadpool_limits

    end.enter_context(threadpool_limits(1, "blas"))
    end.callback(cv2.setNumThreads, cv2.getNumThreads())
    cv2.setNumThreads(1)
