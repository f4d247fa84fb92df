"""Urgent work has priority over work that requests permission."""

import threading
import time

from tracker.live.right_of_way import RightOfWay

PLENTY = 20.0  # s, longer than any computer needs


def test_low_priority_work_waits_until_all_urgent_work_is_done():
    way, order = RightOfWay(patience=PLENTY), list[str]()

    def paint() -> None:
        way.give()
        order.append("painted")

    painter, began = threading.Thread(target=paint), time.monotonic()
    with way:
        with way:
            painter.start()
        painter.join(0.05)  # it would be finished long before
        order.append("worked")
    painter.join(PLENTY)
    assert order == ["worked", "painted"]
    assert time.monotonic() - began < PLENTY / 2  # woken, not timed out


def test_without_urgent_work_there_is_no_wait():
    way = RightOfWay(patience=PLENTY)
    with way:
        assert way.is_taken
    assert not way.is_taken
    began = time.monotonic()
    way.give()
    assert time.monotonic() - began < PLENTY / 2


def test_low_priority_work_proceeds_after_a_timeout():
    """A busy engine must not block the window: half of the time is the window's."""
    clock = [0.0]
    patience = 0.3  # s; a hundred of them are longer than any computer needs
    way = RightOfWay(patience=patience, clock=lambda: clock[0])
    with way:
        began = time.monotonic()
        way.give()
        waited = time.monotonic() - began
        for _ in range(100):
            way.give()  # at once
        assert waited >= 0.9 * patience
        assert time.monotonic() - began - waited < 100 * patience / 2
        clock[0] = 2 * patience
        began = time.monotonic()
        way.give()
        assert time.monotonic() - began >= 0.9 * patience
