"""One BLAS thread for our own computing.

Two threads make small products up to a hundred times slower on a loaded computer, and the last bits
of large products depend on their number. Importing the package changes nothing: a program that
uses it keeps its own setting outside our calls.
"""

from __future__ import annotations

import os
import sys
from contextlib import AbstractContextManager

VARIABLES = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
"""Read by BLAS libraries when they are loaded."""


def limit_this_process() -> None:
    """One thread from now on, for a process of our own and for those that it starts."""
    for name in VARIABLES:
        os.environ.setdefault(name, "1")
    if "numpy" in sys.modules:  # its library has read them before
        from threadpoolctl import threadpool_limits

        threadpool_limits(1, "blas")


def one_blas_thread() -> AbstractContextManager[object]:
    """One thread within a ``with``; the host's setting is restored after it."""
    from threadpoolctl import threadpool_limits

    return threadpool_limits(1, "blas")
