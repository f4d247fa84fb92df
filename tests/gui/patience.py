"""Waiting for jobs, which get little processor time on a loaded computer: as long as they make
progress, and not for a fixed time."""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from app.window.docks import DockShares
from tests.gui import jobs_here

USUAL_MS = 60_000  # longer than any stall of a computer
AT_MOST = 20  # times the time-out given by a test, while a job makes progress
LEAST = 60.0  # s, where that is less
STALLED = 10.0  # s without processor time, after which a job is stalled
TURNS = 5  # of the event loop without a change, after which a layout is complete
_USED = slice(11, 13)  # of /proc/PID/stat behind the name: user and system time in ticks


def processor_ticks() -> int:
    """Processor time used by jobs in this process and by its child processes; 0 if unknown."""
    places = [f"/proc/{child.pid}/stat" for child in multiprocessing.active_children()]
    places += [f"/proc/self/task/{job.native_id}/stat" for job in list(jobs_here.RUNNING)]
    total = 0
    for place in places:
        try:
            text = Path(place).read_text()
        except OSError:
            continue  # it has ended, or this system has no /proc
        total += sum(map(int, text.rpartition(")")[2].split()[_USED]))
    return total


def patient(qtbot: Any) -> Any:
    """``qtbot`` whose ``waitUntil`` continues after its time-out while a job makes progress; its
    time-outs are longer than any stall of a computer unless stated."""
    wait, wait_for_signal = qtbot.waitUntil, qtbot.waitSignal

    def wait_until(is_done: Callable[[], Any], *, timeout: int = USUAL_MS) -> None:
        end = time.monotonic() + max(AT_MOST * timeout / 1000, LEAST)
        used, used_at = processor_ticks(), time.monotonic()
        while True:
            try:
                wait(is_done, timeout=timeout)
            except qtbot.TimeoutError:
                now, ticks = time.monotonic(), processor_ticks()
                if ticks != used:
                    used, used_at = ticks, now
                has_jobs = bool(multiprocessing.active_children() or jobs_here.RUNNING)
                is_stalled = not has_jobs or now - used_at > STALLED
                if is_stalled or now > end:
                    raise
            else:
                return

    def wait_signal(signal: Any, *, timeout: int = USUAL_MS, **options: Any) -> Any:
        return wait_for_signal(signal, timeout=timeout, **options)

    qtbot.waitUntil = wait_until
    qtbot.waitSignal = wait_signal
    return qtbot


def settled(window: Any, qtbot: Any) -> None:
    """Wait until nothing in the main window has moved for some turns of the event loop: layouts are
    made in several of them, each of which takes as long as the computer needs."""
    shares = window.findChild(DockShares)
    seen: list[object] = []

    def is_still() -> bool:
        seen.append((window.size(), *(dock.geometry() for dock in window.docks.values())))
        return not shares._rest.isActive() and seen[-TURNS:] == seen[-1:] * TURNS

    qtbot.waitUntil(is_still)
