"""Folders that several of a test run's processes need: each is made by the first that asks."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

PATIENCE = 480.0  # s, on a busy computer
DONE, FAILED = "made.txt", "failed.txt"


def made_once(folder: Path, make: Callable[[Path], object]) -> Path:
    """``folder``, filled by ``make(folder)`` if it does not exist yet; tests only read it."""
    done, failed = folder / DONE, folder / FAILED
    try:
        folder.mkdir(parents=True)
    except FileExistsError:
        wait(lambda: done.exists() or failed.exists(), PATIENCE, f"making {folder.name}")
        assert not failed.exists(), failed.read_text("utf-8")
        return folder
    try:
        make(folder)
    except BaseException as error:
        failed.write_text(f"{folder.name} could not be made: {error}", "utf-8")
        raise
    done.touch()
    return folder


def wait(is_done: Callable[[], bool], timeout: float, what: str) -> None:
    """Look several times a second; fails after ``timeout`` s."""
    end = time.monotonic() + timeout
    while not is_done():
        assert time.monotonic() < end, f"{what} took longer than {timeout:.0f} s"
        time.sleep(0.2)
