"""A thread that requests low latency, as reported by the system."""

from __future__ import annotations

import ctypes
import os
import platform
import threading

import pytest

from tracker.base.urgency import CALLS, SLICE_NS, _Attributes, run_soon

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
