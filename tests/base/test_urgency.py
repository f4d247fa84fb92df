"""A thread that requests low latency, as reported by the system."""

from __future__ import annotations

import ctypes
import os
import platform
import threading
import time
from multiprocessing.connection import Connection

import pytest

from tracker.base import urgency
from tracker.base.child import start_child
from tracker.base.urgency import (
    CALLS,
    SLICE_NS,
    UrgencyGuard,
    _Attributes,
    is_real_time,
    may_run_first,
    run_first,
    run_soon,
)

GETS = {"x86_64": 315, "aarch64": 275}  # number of sched_getattr


def attributes() -> _Attributes:
    """Linux's scheduling attributes of the calling thread."""
    found = _Attributes()
    call, size = GETS[platform.machine()], ctypes.sizeof(found)
    assert ctypes.CDLL(None).syscall(call, 0, ctypes.byref(found), size, 0) == 0
    return found


def kernel() -> tuple[int, ...]:
    return tuple(int(part) for part in platform.release().split(".")[:2])


def test_a_thread_gets_short_slices_and_others_keep_their_attributes() -> None:
    if platform.system() != "Linux":
        assert not run_soon()
        return
    seen: list[tuple[bool, _Attributes]] = []
    before = attributes()

    def work() -> None:
        os.setpriority(os.PRIO_PROCESS, 0, before.nice + 3)
        seen.append((run_soon(), attributes()))

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    ((accepted, after),) = seen
    assert accepted
    reported_runtime = SLICE_NS if kernel() >= (6, 12) else 0  # an older kernel ignores it
    assert (after.policy, after.nice, after.runtime) == (0, before.nice + 3, reported_runtime)
    assert attributes().runtime == before.runtime


def test_an_unknown_architecture_is_not_modified(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(platform, "machine", lambda: "vax")
    assert "vax" not in CALLS
    assert not run_soon()


def report_policy(pipe: Connection) -> None:
    pipe.send(is_real_time())


def begin_first(pipe: Connection) -> None:
    """Reports whether this process, a thread, a child, and a guarded process go first."""
    seen = [run_first(), is_real_time()]
    thread = threading.Thread(target=lambda: seen.append(is_real_time() and run_soon()))
    thread.start()
    thread.join()
    child, process = start_child("policy", report_policy, daemon=False)
    seen.append(child.recv())
    process.join()
    urgency.CHECK_EVERY, urgency.REST = 0.0, 0.05  # type: ignore[assignment]
    guard = UrgencyGuard(cores=100)
    guard.check()
    seen.append(is_real_time())
    guard._most = 0.0  # any work is too much
    sum(range(100_000))
    guard.check()
    seen.append(is_real_time())
    guard._most = 100.0
    time.sleep(0.1)
    guard.check()
    pipe.send([*seen, is_real_time()])


def test_a_process_that_goes_first_is_an_ordinary_one_while_it_takes_all_cores() -> None:
    pipe, process = start_child("first", begin_first, daemon=False)
    allowed, *seen = pipe.recv()
    process.join()
    if not may_run_first():
        assert seen == [False] * 6
        return
    itself, thread, child, idle, busy, later = seen
    assert allowed and itself and thread and idle and later
    assert not child and not busy
