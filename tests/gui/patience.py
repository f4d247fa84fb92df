"""Waiting for jobs in low-priority processes, which get little processor time on a loaded computer:
as long as they make progress, and not for a fixed time."""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

AT_MOST = 20  # times the time-out given by a test
LEAST = 60.0  # s, where that is less
STALLED = 10.0  # s without processor time, after which a job is stalled
_USED = slice(11, 13)  # of /proc/PID/stat behind the name: user and system time in ticks


def processor_ticks() -> int:
    """Processor time used by the child processes of this one; 0 if unknown."""
    total = 0
    for child in multiprocessing.active_children():
        try:
            text = Path(f"/proc/{child.pid}/stat").read_text()
        except OSError:
            continue  # it has ended, or this system has no /proc
        total += sum(map(int, text.rpartition(")")[2].split()[_USED]))
    return total


def patient(qtbot: Any) -> Any:
    """``qtbot`` whose ``waitUntil`` continues after its time-out while a job makes progress; its
    time-out is longer than any stall of a computer unless stated."""
    wait = qtbot.waitUntil

    def wait_until(is_done: Callable[[], Any], *, timeout: int = 30_000) -> None:
        end = time.monotonic() + max(AT_MOST * timeout / 1000, LEAST)
        used, used_at = processor_ticks(), time.monotonic()
        while True:
            try:
                wait(is_done, timeout=timeout)
            except qtbot.TimeoutError:
                now, ticks = time.monotonic(), processor_ticks()
                if ticks != used:
                    used, used_at = ticks, now
                is_stalled = not multiprocessing.active_children() or now - used_at > STALLED
                if is_stalled or now > end:
                    raise
            else:
                return

    qtbot.waitUntil = wait_until
    return qtbot
