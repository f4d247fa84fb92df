"""Numbers and times of packets with overflow, losses and clock jumps."""

import numpy as np
import pytest

from tracker.sensors.packet_clock import PacketClock
from tracker.sensors.protocol import Samples

PERIOD, WIRE = 0.01, 0.0038  # s
RAW = np.zeros((7, 6), np.int16)


def packet(seq: int, t_us: int) -> Samples:
    return Samples(seq % 2**16, t_us % 2**32, RAW)


def test_numbers_and_times_are_unwrapped():
    clock, first_seq, first_us = PacketClock(PERIOD, WIRE), 2**16 - 3, 2**32 - 25_000
    for k in range(10):
        read = clock.read(packet(first_seq + k, first_us + 10_000 * k), 5.0 + PERIOD * k)
        assert read.seq == first_seq + k and (read.lost, read.jumped) == (0, 0.0)
        assert read.t_device == pytest.approx(1e-6 * first_us + PERIOD * k, abs=1e-9)
        assert read.t == pytest.approx(5.0 - WIRE + PERIOD * k, abs=1e-9), "when it left"


def test_lost_packets_are_counted_unless_they_arrive_late():
    clock = PacketClock(PERIOD, WIRE)
    clock.read(packet(10, 0), 1.0)
    assert clock.read(packet(14, 40_000), 1.04).lost == 3
    assert clock.read(packet(14, 40_000), 1.05) is None
    assert clock.read(packet(13, 30_000), 1.06) is None
    assert clock.read(packet(15, 50_000), 1.05).lost == 0


def test_a_clock_jump_is_reported_and_the_clock_mapped_again():
    clock = PacketClock(PERIOD, WIRE)
    clock.read(packet(0, 0), 1.0)
    assert clock.read(packet(1, 12_000), 1.01).jumped == 0.0, "within what a crystal and a chip do"
    jumped = clock.read(packet(2, 522_000), 1.02)
    assert jumped.jumped == pytest.approx(0.5)
    assert jumped.t == pytest.approx(1.02 - WIRE, abs=1e-9), "the new clock's first packet"


def test_after_a_restart_nothing_is_lost():
    clock = PacketClock(PERIOD, WIRE)
    clock.read(packet(500, 7_000_000), 1.0)
    clock.restart()
    again = clock.read(packet(0, 1_000), 3.0)
    assert (again.seq, again.lost, again.jumped) == (0, 0, 0.0)
