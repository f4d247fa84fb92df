"""How the C library keeps memory that was freed."""

from __future__ import annotations

import ctypes
import sys

ARENA_MAX = -8  # of glibc's mallopt
ARENAS = 2


def keep_few_arenas() -> None:
    """Share two heaps between all threads instead of two per core and thread.

    Each heap keeps what pictures have left in it: with the usual eight and more the demo holds
    30 to 60 MB in pieces that nobody uses.
    """
    if sys.platform.startswith("linux"):
        mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
        if mallopt is not None:  # musl has none
            mallopt(ARENA_MAX, ARENAS)
