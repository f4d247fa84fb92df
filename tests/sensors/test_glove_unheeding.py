"""Gloves that do not follow the protocol: another rate, no HELLO, HELLO twice, a low battery."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.sensors.scripted_glove import LATENCY, SKEW, N, Run, Scripted
from tracker import GRAVITY
from tracker.base.notices import warning
from tracker.messages import ImuSample
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.sensors.link_params import LinkParams, LinkState
from tracker.sensors.protocol import (
    BAUD,
    GloveStatus,
    Hello,
    Rate,
    Samples,
    Stop,
)
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove


@pytest.mark.long
@pytest.mark.parametrize("said_hz", [50, 100])
@pytest.mark.parametrize("rate_hz", [50.0, 120.0, 200.0])
def test_an_ignored_rate_is_reported_once_and_times_are_correct(
    said_hz: int, rate_hz: float
) -> None:
    run = Run(Scripted(Hello(1, N, rate_hz=said_hz), rate_hz))
    run.go(12.0)
    (reported,) = run.notices
    assert reported.code == "glove.other_rate" and reported.values["asked_hz"] == 100
    assert reported.values["rate_hz"] == pytest.approx(rate_hz, rel=0.01)
    assert run.link.figures.clock_jumps == 0 and run.link.figures.lost == 0
    assert len(run.samples) == pytest.approx(12 * rate_hz, abs=2)
    assert np.abs(run.errors()).max() < 0.002
    assert run.link.figures.skew_ppm == pytest.approx(-1e6 * SKEW, abs=100)


def test_losses_at_an_ignored_rate_are_not_clock_jumps() -> None:
    glove = Scripted(Hello(1, N, rate_hz=50), 50.0)
    run = Run(glove)
    for _ in range(20):
        run.go(0.5)
        glove.seq += 10  # packets that were not sent
        glove.next += 10 / glove.rate_hz
    assert run.link.figures.clock_jumps == 0 and run.link.figures.lost == pytest.approx(190, abs=10)
    assert np.abs(run.errors()).max() < 0.002


def test_an_obedient_glove_is_not_reported() -> None:
    run = Run(Scripted(Hello(1, N, rate_hz=50), 50.0, obeys=True))
    run.go(3.0)
    assert run.notices == []
    assert len(run.samples) == pytest.approx(300, abs=3)


def test_a_new_rate_is_accepted_while_streaming_and_detected_by_times() -> None:
    run = Run(Scripted(Hello(7, N), 100.0, obeys=True))
    run.go(2.0)
    before, events = run.link.report(), list(run.notices)
    assert (before.requested_rate_hz, before.glove_id, before.state) == (100, 7, "streaming")
    assert before.rate_hz == pytest.approx(100.0, rel=0.01)
    run.link.request_rate(50)
    assert run.link.report().requested_rate_hz == 50
    run.go(3.0)
    assert run.glove.received[-1] == Rate(50) and run.glove.received.count(Rate(50)) == 1
    assert run.link.report().rate_hz == pytest.approx(50.0, rel=0.01)
    assert run.notices == events, "a rate that was asked for is no news"
    steps = np.diff([s.t for s in run.samples[-50:]])
    np.testing.assert_allclose(steps, 0.02, atol=0.002)
    with pytest.raises(ValueError, match="rate"):
        run.link.request_rate(120)


def test_an_ignored_new_rate_is_in_the_report() -> None:
    run = Run(Scripted(Hello(7, N), 100.0))
    run.go(2.0)
    run.link.request_rate(200)
    run.go(4.0)
    report = run.link.report()
    assert report.requested_rate_hz == 200 and report.rate_hz == pytest.approx(100.0, rel=0.01)
    assert [n.values["asked_hz"] for n in run.notices if n.code == "glove.other_rate"] == [200]


def test_a_real_clock_jump_is_reported_even_if_it_looks_like_a_rate() -> None:
    run = Run(Scripted(Hello(1, N)))
    run.go(2.0)
    glove = run.glove
    for jump_us in (500_000, 10_000, -4_000_000):
        before, honest = len(run.samples), glove.packet
        offset = jump_us
        glove.packet = lambda t, f=honest, d=offset: moved(f(t), d)  # type: ignore[method-assign]
        run.go(1.0)
        assert len(run.samples) > before + 90
    jumps = [n.values["jump_s"] for n in run.notices if n.code == "glove.clock_jumped"]
    assert jumps == pytest.approx([0.5, 0.01, -4.0], abs=5e-4)
    assert np.abs(run.errors()[-50:]).max() < 0.002


def moved(packet: Samples, by_us: int) -> Samples:
    return Samples(packet.seq, (packet.t_us + by_us) % 2**32, packet.raw)


@pytest.mark.parametrize("range_g", [2, 4, 8, 16])
def test_without_hello_gravity_determines_the_range(range_g: int) -> None:
    counts = 32768 // range_g
    run = Run(Scripted(None, rest_counts=counts))
    run.glove.motion = 0.2 * counts
    run.go(6.0)
    assert run.samples and not any(s.valid.any() for s in run.samples), "it is being shaken"
    assert np.isnan(run.samples[-1].accel).all()
    run.glove.motion = 0.004 * counts
    run.go(1.2)
    last = run.samples[-1]
    assert last.valid.all()
    assert np.linalg.norm(last.accel, axis=1) == pytest.approx([GRAVITY] * N, rel=0.05)
    assert run.codes == ["glove.no_hello", "glove.ranges_unknown", "glove.range_from_rest"]
    assert run.notices[-1].values["accel_g"] == range_g


def test_a_magnitude_that_fits_no_range_is_rejected() -> None:
    run = Run(Scripted(None, rest_counts=2900))  # between 8 and 16 g
    run.go(8.0)
    assert len(run.samples) > 300 and not any(s.valid.any() for s in run.samples)


def test_late_ranges_are_accepted() -> None:
    run = Run(Scripted(None, rest_counts=2900))
    run.go(5.0)
    run.glove.put(Hello(1, N, gyro_range_dps=500, accel_range_g=8))
    run.go(0.5)
    assert run.samples[-1].valid.all()
    assert run.samples[-1].accel[0, 2] == pytest.approx(2900 / 4096 * GRAVITY)


def test_a_glove_left_streaming_is_stopped_and_queried_again() -> None:
    glove = Scripted(None)
    glove.streaming = True
    run = Run(glove)
    run.go(1.9)
    assert len(run.samples) > 150 and run.link.state == LinkState.GREETING
    glove.hello = Hello(1, N)
    run.go(1.0)
    assert any(isinstance(f, Stop) for f in glove.received)
    assert run.link.hello == Hello(1, N) and run.link.state == LinkState.STREAMING
    assert run.samples[-1].valid.all()
    assert "glove.restarted" not in run.codes


@pytest.mark.parametrize("late", [0.0, 0.02, 0.3])
def test_a_delayed_hello_is_not_a_restart(late: float) -> None:
    """The boot's HELLO and the answer to HELLO? cross on the line."""
    glove = Scripted(None)
    glove.put(Hello(1, N))
    run = Run(glove)
    run.go(late)
    glove.put(Hello(1, N))
    run.go(1.0)
    assert run.notices == [] and run.link.figures.resets == 0
    assert len(run.samples) > 60


def test_a_real_restart_is_reported_once() -> None:
    glove = Scripted(Hello(1, N))
    run = Run(glove)
    run.go(3.0)
    glove.streaming, glove.seq = False, 0
    glove.put(Hello(1, N))
    run.go(1.0)
    assert run.codes == ["glove.restarted"]
    assert run.link.figures.resets == 1


@pytest.mark.parametrize("wire_baud", [0, BAUD, 115_200])
def test_transmission_time_is_subtracted_on_a_uart(wire_baud: int) -> None:
    glove = Scripted(Hello(1, N), wire_baud=wire_baud)
    run = Run(glove)
    run.go(3.0)
    # the host polls each millisecond; the packet's own time would be 1.9 or 4.1 ms
    assert np.median(run.errors()) == pytest.approx(LATENCY, abs=0.0012)


def test_a_low_battery_is_reported_once_until_it_was_charged() -> None:
    run = Run(Scripted(Hello(1, N)))
    run.go(0.1)
    for millivolt in (3700, 3490, 3480, 3510, 3490, 3650, 3499):
        run.glove.put(GloveStatus(millivolt, 2900, 0b111, 4))
        run.go(0.01)
    assert run.notices == [warning("glove.battery_low", volts=v) for v in (3.49, 3.499)]
    values = run.link.figures.values()
    assert values["battery_low"] == 1.0 and values["glove_dropped"] == 4.0


def test_two_hundred_a_second_require_the_fast_line() -> None:
    with pytest.raises(ValueError, match="250000"):
        LinkParams(rate_hz=200, baud=115_200)


def resting() -> Iterator[ImuSample]:
    accel = np.tile([0.0, 0.0, GRAVITY], (N, 1))
    for k in range(100_000):
        t = k / 100
        yield ImuSample(t, t, t, k, accel, np.zeros((N, 3)), np.ones(N, bool))


def test_the_emulated_glove_without_hello_has_correct_scale_and_times(tmp_path: Path) -> None:
    t_0 = time.monotonic()
    device = SimulatedGlove(
        resting(), N, t_0, GloveDeviceParams(says_hello=False, accel_range_g=8, skew=0.0)
    )
    link = GloveLink(serial_port(device.path), N, LinkParams(boot=0.05, timeout=0.05))
    try:
        got: list[ImuSample] = []
        while not (got and got[-1].valid.all()) and time.monotonic() < t_0 + 10:
            got += [m for m in link.poll(0.02) if isinstance(m, ImuSample)]
        assert got[-1].accel[0] == pytest.approx([0.0, 0.0, GRAVITY], abs=0.01)
        assert not got[0].valid.any()
        true = np.array([s.t_device - 4.0 + t_0 for s in got])
        lateness = np.array([s.t for s in got]) - true
        # the emulator polls its clock each 2 ms; a packet's 3.8 ms on a UART are not simulated
        assert -5e-4 < np.min(lateness) < 4e-3
    finally:
        link.close()
        device.stop()
