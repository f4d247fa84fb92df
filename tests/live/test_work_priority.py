"""Urgent work has priority over work that requests permission."""

import threading
import time

from tracker.live.work_priority import WorkPriority

PLENTY = 20.0  # s, longer than any computer needs


def test_low_priority_work_waits_until_all_urgent_work_is_done():
    priority, order = WorkPriority(longest_wait=PLENTY), list[str]()

    def paint() -> None:
        priority.wait()
        order.append("painted")

    painter, began = threading.Thread(target=paint), time.monotonic()
    with priority:
        with priority:
            painter.start()
        painter.join(0.05)  # it would be finished long before
        order.append("worked")
    painter.join(PLENTY)
    assert order == ["worked", "painted"]
    assert time.monotonic() - began < PLENTY / 2  # woken, not timed out


def test_without_urgent_work_there_is_no_wait():
    priority = WorkPriority(longest_wait=PLENTY)
    with priority:
        assert priority.has_urgent_work
    assert not priority.has_urgent_work
    began = time.monotonic()
    priority.wait()
    assert time.monotonic() - began < PLENTY / 2


def test_low_priority_work_proceeds_after_a_timeout():
    """A busy engine must not block the window: half of the time is the window's."""
    clock = [0.0]
    longest_wait = 0.3  # s; a hundred of them are longer than any computer needs
    priority = WorkPriority(longest_wait=longest_wait, clock=lambda: clock[0])
    with priority:
        began = time.monotonic()
        priority.wait()
        waited = time.monotonic() - began
        for _ in range(100):
            priority.wait()  # at once
        assert waited >= 0.9 * longest_wait
        assert time.monotonic() - began - waited < 100 * longest_wait / 2
        clock[0] = 2 * longest_wait
        began = time.monotonic()
        priority.wait()
        assert time.monotonic() - began >= 0.9 * longest_wait
