"""Configures the destination and the level of Python's loggers, for the whole program.

Modules log with ``logging.getLogger(__name__)``. Without the options ``--log-level`` and
``--log-file``, warnings and errors go to standard error. The window adds its own log file.
"""

from __future__ import annotations

import argparse
import logging
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tracker.base.files import check_target

LEVELS = ("debug", "info", "warning", "error")
FORMAT = "%(asctime)s %(levelname)s %(threadName)s %(name)s: %(message)s"
VERBOSE = ("numba", "matplotlib", "PIL", "h5py", "asyncio")
"""Other packages that log each of their steps at the level debug."""


def add_log_options(parser: argparse.ArgumentParser) -> None:
    """``--log-level`` and ``--log-file``."""
    group = parser.add_argument_group("logging")
    group.add_argument(
        "--log-level",
        choices=LEVELS,
        help="lowest level of messages to log (default: info in a file, warning otherwise)",
    )
    group.add_argument(
        "--log-file",
        type=Path,
        metavar="FILE",
        help="write the log to this new file instead of standard error",
    )


@contextmanager
def logging_to(level: str | None, path: Path | None) -> Iterator[None]:
    """Log messages of at least ``level`` to ``path`` or else to standard error during the block.

    Warnings and errors go to standard error in any case. Raises FileError if the file exists.
    """
    root = logging.getLogger()
    before = root.level
    shown = logging.StreamHandler()
    shown.setLevel(logging.WARNING if path or not level else level.upper())
    if level and not path:
        shown.setFormatter(logging.Formatter(FORMAT))
    handlers: list[logging.Handler] = [shown]
    if path is not None:
        check_target(path, force=False)
        handlers.append(logging.FileHandler(path, encoding="utf-8"))
        handlers[-1].setFormatter(logging.Formatter(FORMAT))
    for name in VERBOSE:
        logging.getLogger(name).setLevel(logging.INFO)
    root.setLevel((level or "info").upper())
    for handler in handlers:
        root.addHandler(handler)
    try:
        yield
    finally:
        root.setLevel(before)
        for handler in handlers:
            root.removeHandler(handler)
            handler.close()
