"""How the threads of this process share memory and the interpreter."""

from __future__ import annotations

import ctypes
import gc
import sys

ARENA_MAX = -8  # of glibc's mallopt
ARENAS = 2
SWITCH_S = 0.0005
"""How long a thread that wants the interpreter waits before it asks for it. With Python's 5 ms a
packet waits 37 ms (99 %) beside a thread that never rests, with a tenth of that 1 to 3. What
tracks takes less for a packet, and what paints gives way to it (`app.platform.courtesy`): asked
more often they change places in the middle of it, and each change waits for a processor."""


def tune_process() -> None:
    """To be called once, before any thread is started."""
    keep_few_arenas()
    sys.setswitchinterval(SWITCH_S)


def keep_few_arenas() -> None:
    """Share two heaps between all threads instead of two per core and thread.

    Each heap keeps what images have left in it: with the usual eight and more the demo holds
    30 to 60 MB in pieces that nobody uses.
    """
    if sys.platform.startswith("linux"):
        mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
        if mallopt is not None:  # musl has none
            mallopt(ARENA_MAX, ARENAS)


def set_aside_what_stays() -> None:
    """Free what is garbage now, and let the collector look at newer objects alone from here on.

    The window and its libraries are some 400 000 objects that stay; going through them holds all
    threads for 60 to 150 ms, several times a minute. Called again it takes up what was set aside
    before, so that nothing is kept for good. Costs such a pause itself: for a moment at which none
    is noticed.
    """
    gc.unfreeze()
    gc.collect()
    gc.freeze()
