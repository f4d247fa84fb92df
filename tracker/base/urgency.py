"""Low scheduling latency for threads, and for a process, whose work is short and urgent.

A process with a real-time priority (SCHED_RR) runs before all ordinary ones, whatever their number.
Nice levels count only among processes of one session or one control group: next to a loaded
terminal, level -5 has no effect on a desktop.

Linux gives each thread the processor for a slice of a few milliseconds, and a thread that wakes up
waits for the end of others' slices. From 6.12 on, a thread may request shorter slices: it gets no
more time in total, but earlier (sched_setattr(2), `sched_runtime` of SCHED_OTHER). On other systems
there is no such request. With three loaded processes on two cores, a thread wakes up 0.5 ms late
instead of 2.3 ms (90 %).
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import platform
import sys
import time
from pathlib import Path

if sys.platform != "win32":
    import resource

SLICE_NS = 100_000
FIRST = -5
"""Nice level of a process that goes before others; with a lower one, the window of a loaded
computer would stop."""
REAL_TIME = 1
"""The lowest real-time priority: sound and the system's own threads have higher ones."""
DEVICE = 2
"""Of a process that stands for a device, which interrupts whatever runs."""
SPARED = 0.5  # of a core, which remains to others in any case
CHECK_EVERY, REST = 1.0, 10.0  # s between checks, and until a process may be urgent again
CALLS = {"x86_64": 314, "aarch64": 274}  # number of sched_setattr


class _Attributes(ctypes.Structure):
    """``struct sched_attr``; policy 0 is SCHED_OTHER."""

    _fields_ = (
        ("size", ctypes.c_uint32),
        ("policy", ctypes.c_uint32),
        ("flags", ctypes.c_uint64),
        ("nice", ctypes.c_int32),
        ("priority", ctypes.c_uint32),
        ("runtime", ctypes.c_uint64),
        ("deadline", ctypes.c_uint64),
        ("period", ctypes.c_uint64),
    )


def run_soon() -> bool:
    """Requests it for the calling thread; returns whether the system accepted the request. An older
    Linux accepts it without effect. A thread with a real-time priority needs no request."""
    call = CALLS.get(platform.machine())
    if not sys.platform.startswith("linux") or call is None:
        return False
    if is_real_time():
        return True
    nice = os.getpriority(os.PRIO_PROCESS, 0)  # of this thread; it stays
    wanted = _Attributes(ctypes.sizeof(_Attributes), 0, 0, nice, 0, SLICE_NS, 0, 0)
    return bool(ctypes.CDLL(None).syscall(call, 0, ctypes.byref(wanted), 0) == 0)


def run_first() -> bool:
    """Requests that this process goes before others; returns whether the system allows it.

    To be called before it starts threads, which inherit it. Linux allows it to root, and to users
    with a limit ``rtprio`` or ``nice`` in ``/etc/security/limits.conf``: a real-time priority, and
    the nice level `FIRST` in case that ends (`UrgencyGuard`).
    """
    if not hasattr(os, "setpriority"):
        return False
    raised = _set_real_time(0)
    with contextlib.suppress(OSError):
        os.setpriority(os.PRIO_PROCESS, 0, FIRST)
        return True
    return raised


def run_as_device() -> bool:
    """Requests that this process goes before all others, since it stands for a device that has a
    processor of its own; returns whether the system allows it. As with `run_first`, before it
    starts threads. Only for processes that need a few percent of a core."""
    return _set_real_time(0, DEVICE)


def run_as_others() -> None:
    """Ends a real-time priority that this process inherited: only the process that tracks needs
    one, not its recorder."""
    if is_real_time():
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))


def is_real_time() -> bool:
    """Whether the calling thread has a real-time priority."""
    return hasattr(os, "SCHED_RR") and os.sched_getscheduler(0) == os.SCHED_RR


def may_run_first() -> bool:
    """Whether the system would give this user's programs a real-time priority."""
    if not hasattr(os, "SCHED_RR"):
        return False
    soft, _ = resource.getrlimit(resource.RLIMIT_RTPRIO)
    return os.geteuid() == 0 or soft == resource.RLIM_INFINITY or soft >= REAL_TIME


def _set_real_time(thread: int, priority: int = REAL_TIME) -> bool:
    """0: the calling thread."""
    if not hasattr(os, "SCHED_RR"):
        return False
    try:
        os.sched_setscheduler(thread, os.SCHED_RR, os.sched_param(priority))
    except OSError:
        return False
    return True


class UrgencyGuard:
    """Ends the real-time priority of this process while it takes almost all cores: the window and
    the desktop would stop. It returns after `REST` s."""

    def __init__(self, cores: int | None = None) -> None:
        self._most = (cores or usable_cores()) - SPARED
        self._checked = time.monotonic(), time.process_time()
        self._urgent, self._until = is_real_time(), 0.0

    def check(self) -> None:
        """To be called at least once a second; looks no more often."""
        if not self._urgent:
            return
        now, (then, spent_then) = time.monotonic(), self._checked
        if now - then < CHECK_EVERY:
            return
        spent = time.process_time()
        self._checked = now, spent
        if (spent - spent_then) / (now - then) > self._most:
            self._until = now + REST
            for thread in _threads():
                with contextlib.suppress(ProcessLookupError):  # it has ended
                    os.sched_setscheduler(thread, os.SCHED_OTHER, os.sched_param(0))
        elif self._until and now >= self._until:
            self._until = 0.0
            for thread in _threads():
                _set_real_time(thread)


def usable_cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _threads() -> list[int]:
    """Of this process."""
    return [int(task.name) for task in Path("/proc/self/task").iterdir()]
