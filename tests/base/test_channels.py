"""Channels with several threads: every loss is counted, no thread waits forever."""

from __future__ import annotations

import threading
import time

import pytest

from tracker.base.channels import Backlog, Closed, Fifo, Latest


def test_latest_keeps_the_newest_and_counts_the_rest() -> None:
    slot: Latest[int] = Latest()
    assert slot.get() is None
    for n in range(5):
        slot.put(n)
    assert slot.get() == 4
    assert slot.get() is None
    assert slot.dropped == 4


def test_backlog_discards_the_oldest_and_counts() -> None:
    queue: Backlog[int] = Backlog(3)
    assert all(queue.put(n) for n in range(5))
    assert queue.dropped == 2
    queue.close()
    assert not queue.put(9)
    assert [queue.get() for _ in range(3)] == [2, 3, 4]
    with pytest.raises(Closed):
        queue.get()
    with pytest.raises(ValueError, match="size"):
        Backlog(0)


def test_fifo_rejects_values_when_full() -> None:
    queue: Fifo[int] = Fifo(3)
    assert [queue.put(n) for n in range(5)] == [True, True, True, False, False]
    assert queue.overflowed == 2
    assert queue.fill == 1.0
    assert queue.drain() == [0, 1, 2]
    assert queue.get() is None
    with pytest.raises(ValueError, match="size"):
        Fifo(0)


def test_closed_fifo_returns_the_rest_then_reports_closure() -> None:
    queue: Fifo[int] = Fifo(3)
    queue.put(1)
    queue.close()
    assert queue.put(2) is False
    assert queue.overflowed == 0
    assert queue.get(None) == 1
    with pytest.raises(Closed):
        queue.get(None)


@pytest.mark.parametrize("channel", [Latest(), Fifo(1)])
def test_close_wakes_waiting_threads(channel: Latest[int] | Fifo[int]) -> None:
    woken = threading.Event()

    def wait() -> None:
        with pytest.raises(Closed):
            channel.get(None)
        woken.set()

    thread = threading.Thread(target=wait)
    thread.start()
    channel.close()
    assert woken.wait(60.0)
    thread.join()


def test_timeout_is_respected() -> None:
    started = time.monotonic()
    assert Fifo[int](1).get(0.05) is None
    assert time.monotonic() - started > 0.04


def test_every_value_arrives_once_and_in_order_or_is_counted() -> None:
    queue: Fifo[tuple[int, int]] = Fifo(16)
    accepted = [0, 0, 0]

    def produce(who: int) -> None:
        for n in range(2000):
            accepted[who] += queue.put((who, n), timeout=0.001)

    threads = [threading.Thread(target=produce, args=(k,)) for k in range(3)]
    for thread in threads:
        thread.start()
    got: list[tuple[int, int]] = []
    while any(t.is_alive() for t in threads) or len(queue):
        item = queue.get(0.01)
        if item is not None:
            got.append(item)
    assert len(got) + queue.overflowed == 6000
    for who in range(3):
        mine = [n for k, n in got if k == who]
        assert len(mine) == accepted[who]
        assert mine == sorted(set(mine))
