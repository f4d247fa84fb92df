"""Slow, failing and blocked outputs next to a working one; trackers that publish or are polled."""

from __future__ import annotations

import threading
import time

import pytest

from tracker.base.notices import Notice, notice, warning
from tracker.messages import Estimate
from tracker.streaming.attach import attach
from tracker.streaming.streams import BACKLOG, Streams, of_all_hands


class Sink:
    """An output that stores what it receives, and can be blocked or broken."""

    def __init__(self, name: str = "sink") -> None:
        self.name, self.closed = name, 0
        self.got: list[float] = []
        self.open = threading.Event()
        self.open.set()
        self.fault: Exception | None = None

    def send(self, estimate: Estimate) -> None:
        self.open.wait(200)
        if self.fault:
            raise self.fault
        self.got.append(estimate.t)

    def close(self) -> None:
        self.closed += 1


class Tracker:
    """Offers a new estimate on request of the test."""

    def __init__(self) -> None:
        self.estimate: Estimate | None = None

    def latest_estimate(self) -> Estimate | None:
        return self.estimate


def test_a_blocked_output_delays_neither_caller_nor_other_outputs(make_estimate, wait_for) -> None:
    slow, healthy = Sink("slow"), Sink("healthy")
    slow.open.clear()
    streams = Streams([slow, healthy])
    for k in range(200):
        streams.offer(make_estimate(float(k)))
        wait_for(lambda k=k: len(healthy.got) == k + 1)
    assert slow.got == [], "it is blocked all the time"
    assert healthy.got == [float(k) for k in range(200)]
    slow.open.set()
    wait_for(lambda: len(slow.got) == 1 + BACKLOG)
    newest = [float(k) for k in range(200 - BACKLOG, 200)]
    assert slow.got == [0.0, *newest], "it misses the oldest"
    wait_for(lambda: streams.counts()[0].sent == 1 + BACKLOG)
    count = streams.counts()[0]
    assert (count.dropped, count.failed, count.left_out) == (199 - BACKLOG, 0, 199 - BACKLOG)
    streams.close()


class ThreadSink(Sink):
    """Also stores in which thread it sends."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.threads: list[threading.Thread] = []

    def send(self, estimate: Estimate) -> None:
        self.threads.append(threading.current_thread())
        super().send(estimate)


def test_outputs_share_a_thread_until_one_hangs(make_estimate, wait_for) -> None:
    slow, healthy, other = (ThreadSink(name) for name in ("slow", "healthy", "other"))
    parts = [Streams([sink]) for sink in (slow, healthy, other)]

    def offer(t: float) -> None:
        for part in parts:
            part.offer(make_estimate(t))

    offer(0.0)
    wait_for(lambda: len(other.got) == 1)
    assert slow.threads == healthy.threads == other.threads
    slow.open.clear()
    offer(1.0)
    wait_for(lambda: healthy.got == other.got == [0.0, 1.0])
    assert healthy.threads[1] is other.threads[1] is not slow.threads[1]
    slow.open.set()
    offer(2.0)
    wait_for(lambda: all(sink.got == [0.0, 1.0, 2.0] for sink in (slow, healthy, other)))
    assert slow.threads[2] is slow.threads[1] and healthy.threads[2] is other.threads[2]
    for part in parts:
        part.close()
    wait_for(lambda: not any(t.name.startswith("glovetrack-sender") for t in threading.enumerate()))


def test_a_failing_output_is_reported_once_and_recovers(make_estimate, wait_for) -> None:
    reported: list[Notice] = []
    sink = Sink("UDP")
    sink.fault = OSError("network is unreachable")
    streams = Streams([sink], reported.append)
    for k in range(3):
        streams.offer(make_estimate())
        wait_for(lambda k=k: streams.counts()[0].failed == k + 1)
    assert reported == [warning("stream.failing", stream="UDP", why="network is unreachable")]
    assert streams.counts()[0].error == "network is unreachable"
    sink.fault = None
    streams.offer(make_estimate())
    wait_for(lambda: streams.counts()[0].sent == 1)
    wait_for(lambda: len(reported) == 2)
    assert reported[1] == notice("stream.works_again", stream="UDP")
    streams.close()
    assert sink.closed == 1


def test_closing_does_not_wait_for_a_blocked_output(make_estimate) -> None:
    sink = Sink()
    sink.open.clear()
    streams = Streams([sink])
    streams.offer(make_estimate())
    streams.close()
    assert sink.got == [], "it is still blocked"
    sink.open.set()


def test_a_tracker_is_polled_and_each_estimate_sent_once(make_estimate, wait_for) -> None:
    tracker, sink = Tracker(), Sink()
    attached = attach(tracker, [sink])
    time.sleep(0.05)
    assert sink.got == []
    for t in (1.0, 2.0):
        tracker.estimate = make_estimate(t)
        wait_for(lambda t=t: sink.got and sink.got[-1] == t)
    time.sleep(0.05)
    assert sink.got == [1.0, 2.0]
    attached.close()
    attached.close()
    assert sink.closed == 1
    assert not [t for t in threading.enumerate() if t.name == "glovetrack-streams"]


def test_the_rate_is_limited(make_estimate) -> None:
    tracker, sink = Tracker(), Sink()
    attached = attach(tracker, [sink], rate_hz=20)
    end = time.monotonic() + 0.5
    while time.monotonic() < end:
        tracker.estimate = make_estimate(time.monotonic())
        time.sleep(0.002)
    attached.close()
    assert 2 <= len(sink.got) <= 11


class Publishing(Tracker):
    """A tracker that calls its subscribers, as live tracking does."""

    def __init__(self) -> None:
        super().__init__()
        self.subscribers: list = []

    def subscribe(self, subscriber):
        self.subscribers.append(subscriber)
        return lambda: self.subscribers.remove(subscriber) if self.subscribers else None

    def publish(self, estimate: Estimate) -> None:
        for subscriber in self.subscribers:
            subscriber(estimate)


def test_a_burst_of_a_publishing_tracker_is_sent_completely(make_estimate, wait_for) -> None:
    tracker, sink = Publishing(), Sink()
    attached = attach(tracker, [sink])
    burst = [k / 100 for k in range(BACKLOG)]  # as after 0.5 s without CPU time
    for t in burst:
        tracker.publish(make_estimate(t))
    wait_for(lambda: len(sink.got) == len(burst))
    assert sink.got == burst
    wait_for(lambda: attached.counts()[0].sent == len(burst))
    assert attached.counts()[0].left_out == 0
    assert attached.counts()[0].rates_hz[0] > 0
    attached.close()
    attached.close()
    assert not tracker.subscribers and sink.closed == 1


def test_a_lower_rate_drops_estimates_by_their_times(make_estimate, wait_for) -> None:
    tracker, sink = Publishing(), Sink()
    attached = attach(tracker, [sink], rate_hz=25)
    for k in range(40):
        tracker.publish(make_estimate(k / 100))
    attached.close()
    assert sink.got == pytest.approx([k / 25 for k in range(10)])


def test_both_hands_are_counted_together(make_estimate, wait_for) -> None:
    parts = [Streams([Sink(side)]) for side in ("right", "left")]
    for part, n in zip(parts, (3, 5), strict=True):
        for k in range(n):
            part.offer(make_estimate(float(k)))
    wait_for(lambda: [p.counts()[0].sent for p in parts] == [3, 5])
    both = of_all_hands([p.counts()[0] for p in parts])
    assert (both.name, both.sent, both.dropped, len(both.rates_hz)) == ("right", 8, 0, 2)
    assert both.rates_hz[1] > both.rates_hz[0] > 0
    for part in parts:
        part.close()


@pytest.mark.parametrize("rate", [0.0, -1.0, 1000.0])
def test_an_impossible_rate_is_rejected(rate: float) -> None:
    with pytest.raises(ValueError, match="rate"):
        attach(Tracker(), [], rate_hz=rate)
