"""Images are begun right after packets: rules, and a queue with both, on a simulated clock."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.live.inbox import LATE, LONGEST, PacketRhythm

PERIOD = 0.01


def rhythm_of(takes: float, *phases: float, seconds: float = 1.0) -> PacketRhythm:
    """After ``seconds`` of packets of one glove for each phase, and of images."""
    rhythm = PacketRhythm()
    times = [(t + p, str(p)) for t in np.arange(0.0, seconds, PERIOD) for p in phases]
    for t, side in sorted(times):
        rhythm.packet(side, t)
    for _ in range(100):
        rhythm.image(takes)
    return rhythm


def test_an_image_that_would_delay_the_next_packet_waits_for_it() -> None:
    rhythm = rhythm_of(0.003, 0.0)  # the last packet at 0.99
    assert rhythm.hold(0.991) == 0.0
    assert rhythm.hold(0.998) == pytest.approx(0.002 + LATE, abs=1e-6)


def test_a_packet_that_does_not_come_is_not_waited_for() -> None:
    rhythm = rhythm_of(0.003, 0.0)
    assert 0.0 < rhythm.hold(1.0005) <= LATE
    assert rhythm.hold(1.002) == 0.0 and rhythm.hold(5.0) == 0.0
    assert PacketRhythm().hold(1.0) == 0.0
    assert rhythm_of(0.003).hold(1.0) == 0.0


def test_an_image_longer_than_each_gap_begins_with_the_longest_gap() -> None:
    rhythm = rhythm_of(0.02, 0.0, 0.003)  # expected at 1.000 and 1.003
    assert rhythm.hold(0.998) > 0.0
    rhythm.packet("0.0", 1.0)
    assert rhythm.hold(1.001) > 0.0
    rhythm.packet("0.003", 1.003)
    assert rhythm.hold(1.0035) == 0.0


def test_an_image_is_held_for_a_limited_time() -> None:
    rhythm = rhythm_of(0.02, 0.0, 0.005)
    now, end = 0.9999, 0.9999 + LONGEST
    while (hold := rhythm.hold(now)) > 0.0:
        now += hold
        rhythm.packet("0.0" if now % PERIOD < PERIOD / 2 else "0.005", now - LATE)
    assert now <= end + 1e-9


@pytest.mark.parametrize("hands", [1, 2])
def test_packets_wait_less_than_without_it(hands: int) -> None:
    """A queue with one server: packets take 0.6 ms, images 3 ms on average (a gamma distribution),
    those of two hands twice as long. The images' own delay grows by less than half a period."""
    held, plain = waits(hands, hold=True), waits(hands, hold=False)
    ratio = 0.5 if hands == 1 else 0.85
    assert np.percentile(held[0], 99) < ratio * np.percentile(plain[0], 99)
    assert np.median(held[1]) < np.median(plain[1]) + PERIOD / 2


def waits(hands: int, hold: bool) -> tuple[list[float], list[float]]:
    """s from arrival to end of each packet and image in a minute."""
    rng, rhythm = np.random.default_rng(1), PacketRhythm()
    arrivals = [np.arange(0.0, 60.0, PERIOD) + 0.0035 * k for k in range(hands)]
    packets = sorted((t, str(k)) for k, ts in enumerate(arrivals) for t in ts)
    packets = [
        (t + abs(e), k) for (t, k), e in zip(packets, rng.normal(0, 5e-4, 10**5), strict=False)
    ]
    images = list(np.arange(0.1, 59.0, 1 / 60))
    now, waited, seen = 0.0, [], []
    while images:
        now = max(now, min(packets[0][0], images[0]))
        if packets[0][0] <= now:
            t, side = packets.pop(0)
            rhythm.packet(side, t)
            now += 6e-4
            waited.append(now - t)
            continue
        wait = rhythm.hold(now) if hold else 0.0
        if packets[0][0] < now + wait:
            now = packets[0][0]
            continue
        rhythm.begun()
        took = hands * float(rng.gamma(4.0, 7.5e-4))
        now += wait + took
        rhythm.image(took)
        seen.append(now - images.pop(0))
    return waited, seen
