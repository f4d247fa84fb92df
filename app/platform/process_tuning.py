"""How the threads of this process share memory and the interpreter."""

from __future__ import annotations

import ctypes
import gc
import sys
from collections.abc import Iterator
from contextlib import contextmanager

ARENA_MAX = -8  # of glibc's mallopt
ARENAS = 2
SWITCH_S = 0.0005
"""How long a thread that wants the interpreter waits before it requests it. With Python's 5 ms a
packet waits 37 ms (99th percentile) next to a thread that never sleeps, with a tenth of that 1 to 3
ms. Tracking needs less than that for a packet, and painting gives way to it
(`app.platform.painting_pauses`): with more frequent requests the threads would interrupt each other
in the middle of a packet, and each switch waits for a processor."""


def tune_process() -> None:
    """Call once, before any thread is started."""
    keep_few_arenas()
    sys.setswitchinterval(SWITCH_S)


def keep_few_arenas() -> None:
    """Share two heaps between all threads instead of two per core and thread.

    Each heap retains memory of freed images: with the default of eight and more the demo uses 30 to
    60 MB more.
    """
    if sys.platform.startswith("linux"):
        mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
        if mallopt is not None:  # musl has none
            mallopt(ARENA_MAX, ARENAS)


@contextmanager
def collection_postponed() -> Iterator[None]:
    """Collect no garbage within a ``with`` until `freeze_permanent_objects`.

    Most objects that a start makes are permanent. Traversing them again and again takes a tenth of
    the time of importing the window.
    """
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


def freeze_permanent_objects() -> None:
    """Collect garbage now, and exclude the remaining objects from later collections.

    The window and its libraries are about 400 000 permanent objects; traversing them blocks all
    threads for 60 to 150 ms, several times a minute. A repeated call includes the objects that were
    excluded before, so that none of them leaks. The call itself takes such a pause: call it while
    nothing is tracked.
    """
    gc.unfreeze()
    freeze_new_objects()
    gc.enable()


def freeze_new_objects() -> None:
    """As `freeze_permanent_objects`, for the objects since its last call alone: a short pause."""
    gc.collect()
    gc.freeze()
