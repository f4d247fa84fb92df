"""From simulated silicon to the engine: `tracker.sensors` communicates with the firmware."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
import pytest

from tests.firmware.glove_oracle import (
    HELLO,
    IMUS,
    SAMPLES,
    STATUS,
    TEMPERATURES,
    samples,
    simulated_glove,
)
from tracker.base.notices import warning
from tracker.messages import Event, ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.sensors.protocol import (
    GloveStatus,
    Haptic,
    Hello,
    Rate,
    Samples,
    Start,
    Stop,
    Temperatures,
    encode,
)


def test_the_engine_decodes_the_same_as_the_oracle(build: Path) -> None:
    with simulated_glove(build, "0:battery 3900", "0:unplug 6") as glove:
        glove.start()
        glove.wait_for(SAMPLES, 60)
        glove.wait_for(TEMPERATURES)
    decoder = FrameDecoder()
    frames = decoder.feed(bytes(glove.raw))
    assert decoder.counters.errors == 0
    assert len(frames) == len(glove.frames)
    seq, t_us, raw = samples(glove.of(SAMPLES))
    got = [f for f in frames if isinstance(f, Samples)]
    assert [f.seq for f in got] == seq.tolist()
    assert [f.t_us for f in got] == t_us.tolist()
    assert np.array_equal([f.raw for f in got], raw)
    hello = next(f for f in frames if isinstance(f, Hello))
    fields = glove.of(HELLO)[0].numbers
    assert (hello.protocol, *hello.firmware, hello.glove_id, hello.imu_count) == fields[:6]
    assert (hello.gyro_range_dps, hello.accel_range_g, hello.rate_hz) == fields[6:9]
    assert hello.chips == tuple(glove.of(HELLO)[0].chips)
    warmth = next(f for f in frames if isinstance(f, Temperatures))
    assert warmth.values_cC[:6] == glove.of(TEMPERATURES)[0].numbers[:6]
    assert warmth.values_cC[6] is None  # unplugged
    status = next(f for f in frames if isinstance(f, GloveStatus))
    wire = glove.of(STATUS)[0].numbers
    assert (status.battery_mV, status.temperature_cC, status.imu_ok, status.dropped) == wire


def test_the_firmware_executes_the_engines_commands(build: Path) -> None:
    with simulated_glove(build) as glove:
        glove.wait_for(HELLO)
        glove.port.write(encode(Rate(200)) + encode(Haptic(1, 77, 50)) + encode(Start()))
        _, t_us, _ = samples(glove.wait_for(SAMPLES, 30))
        glove.port.write(encode(Stop()))
        glove.wait_for(HELLO)
        glove.stop()
    assert np.all(np.diff(t_us) == 5000)
    assert "haptic 1 77 " in glove.printed


def test_the_ordinary_serial_code_reads_the_simulated_chip(build: Path, tmp_path: Path) -> None:
    """`GloveLink` opens the port, greets, starts and gives samples in SI units."""
    felt = np.linspace([-30, -20, -10, -6, -4, -2], [30, 20, 10, 6, 4, 2], IMUS)
    motion = tmp_path / "felt.txt"
    np.savetxt(motion, [[0.0, *felt.ravel()]])
    with simulated_glove(build, "0:unplug 5", motion=motion, fast=False) as glove:
        glove.port.close()
        link = GloveLink(serial_port(glove.port.port), IMUS)
        got: list[ImuSample | Event] = []
        end = time.monotonic() + 20
        while sum(isinstance(m, ImuSample) for m in got) < 50 and time.monotonic() < end:
            got += link.poll(0.1)
        link.close()
    taken = [m for m in got if isinstance(m, ImuSample)]
    assert len(taken) >= 50
    assert np.all(np.diff([m.seq for m in taken]) == 1)
    assert np.allclose(np.diff([m.t_device for m in taken]), 0.01, atol=1e-9)
    answering = [j for j in range(IMUS) if j != 5]
    for sample in taken:
        assert sample.valid.tolist() == [j != 5 for j in range(IMUS)]
        assert np.all(np.isnan(sample.accel[5]))
        # Half a step of ±16 g and ±2000 °/s.
        assert np.allclose(sample.accel[answering], felt[answering, :3], atol=0.0024)
        assert np.allclose(sample.gyro[answering], felt[answering, 3:], atol=0.00054)
    reported = [m.notice for m in got if isinstance(m, Event)]
    assert warning("glove.imu_silent", imu=5) in reported


@pytest.mark.long
def test_a_pulse_is_an_event_at_its_time_on_the_hosts_clock(build: Path) -> None:
    with simulated_glove(build, fast=False) as glove:
        glove.port.close()
        link = GloveLink(serial_port(glove.port.port), IMUS)
        got: list[ImuSample | Event] = []
        commands = 0
        end = time.monotonic() + 30
        while sum(isinstance(m, Event) and m.kind == "pulse" for m in got) < 3:
            assert time.monotonic() < end
            if link.figures.packets > 100 * (commands + 1):
                glove.tell("pulse 50")
                commands += 1
            got += link.poll(0.02)
        link.close()
    pulses = [m for m in got if isinstance(m, Event) and m.kind == "pulse"]
    assert [p.data["number"] for p in pulses] == [1, 2, 3]
    packets = [m for m in got if isinstance(m, ImuSample)]
    device, t = np.array([m.t_device for m in packets]), np.array([m.t for m in packets])
    for pulse in pulses:
        assert isinstance(pulse.data["t_device"], float)
        assert np.interp(pulse.data["t_device"], device, t) == pytest.approx(pulse.t, abs=0.01)
