"""The command ``glovetrack``, also ``python -m app``."""

from __future__ import annotations

import multiprocessing
import sys

from tracker.base.numeric_threads import limit_this_process

limit_this_process()  # before numpy is imported; processes that this one starts inherit it

from tracker.cli import main  # noqa: E402

__all__ = ["main"]

if __name__ == "__main__":
    # In a frozen program the simulated camera's process starts here too, and must not go on.
    multiprocessing.freeze_support()
    sys.exit(main())
