"""Simulated gloves in a separate process, through the ordinary link."""

from __future__ import annotations

import itertools
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import DeviceError
from tracker.base.urgency import may_run_first
from tracker.glove import library
from tracker.messages import Event, ImuSample
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.simulation.demo import DemoSpec, build
from tracker.simulation.drawn_ahead import PACKETS, DrawnAhead
from tracker.simulation.glove_process import GloveProcess

SPEC = DemoSpec(*library.texts(), duration=60.0)
START = 60.0  # s, for a process on a loaded computer
LSB_GYRO = np.deg2rad(2000.0) / 32768
LOADED = "import sys, tracker.simulation.camera_device, tracker.simulation.glove_process; "
LOADED += "print([name for name in sys.modules if name.startswith('scipy')])"


@pytest.fixture
def worn() -> Iterator[GloveProcess]:
    process = GloveProcess(SPEC)
    yield process
    process.close()


def received(link: GloveLink, until: Callable[[list[ImuSample | Event]], bool]) -> list:
    """All messages from the link until a condition is met."""
    found: list[ImuSample | Event] = []
    deadline = time.monotonic() + START
    while not until(found):
        assert time.monotonic() < deadline, found[-3:]
        found += link.poll(0.05)
    return found


@pytest.mark.long
def test_packets_have_the_wearers_motion_and_the_cable_is_unplugged_at_the_end(
    worn: GloveProcess,
) -> None:
    paths = worn.paths(START)
    assert list(paths) == ["right"]
    link = GloveLink(serial_port(paths["right"]), 7)
    worn.begin(time.monotonic() + 0.1)
    found = received(link, lambda got: sum(isinstance(x, ImuSample) for x in got) > 20)
    assert link.hello is not None and link.hello.glove_id == 1
    got = [x for x in found if isinstance(x, ImuSample)]
    # packets generated before a reader was connected are lost, so they are identified by their
    # times
    true = list(itertools.islice(build(SPEC).imu_samples(), 3000))
    device = np.array([s.t_device for s in got]) - 4.0  # start_us; skew is 60e-6
    rows = np.searchsorted([s.t for s in true], device / (1 + 60e-6) - 1e-5)
    assert [s.seq for s in got] == list(range(got[0].seq, got[0].seq + len(got)))
    for sample, row in zip(got, rows, strict=True):
        assert sample.gyro == pytest.approx(true[row].gyro, abs=0.51 * LSB_GYRO)
    worn.close()
    arrived = received(link, lambda got: any(isinstance(x, Event) for x in got))
    assert "glove.unplugged" in [x.code for x in arrived if isinstance(x, Event)]
    link.close()


def test_only_the_sending_process_goes_before_all_others(worn: GloveProcess) -> None:
    """It stands for the device; generating packets takes longer."""
    worn.paths(START)
    sends, generates = (os.sched_getscheduler(p.pid or 0) for p in worn._processes)
    assert (sends == os.SCHED_RR) == may_run_first()
    assert generates == os.SCHED_OTHER


def test_without_the_process_that_generates_the_glove_is_silent_and_ends(
    worn: GloveProcess,
) -> None:
    link = GloveLink(serial_port(worn.paths(START)["right"]), 7)
    worn.begin(time.monotonic() + 0.1)
    received(link, lambda got: any(isinstance(x, ImuSample) for x in got))
    worn._processes[1].kill()
    deadline = time.monotonic() + START
    while link.poll(1.0):  # until a second passes without any
        assert time.monotonic() < deadline
    link.close()
    worn.close()
    assert not any(process.is_alive() for process in worn._processes)


def test_a_process_that_cannot_start_is_reported() -> None:
    process = GloveProcess(SPEC)
    process._process.kill()
    with raises(DeviceError, "simulator.glove_not_started"):
        process.paths(START)
    process.close()


def test_packets_are_generated_ahead_in_order_and_limited() -> None:
    made: list[int] = []

    def source() -> Iterator[ImuSample]:
        for sample in itertools.islice(build(SPEC).imu_samples(), 100):
            made.append(sample.seq)
            yield sample

    ahead = DrawnAhead(source())
    first = next(ahead)
    assert first.seq == 0
    deadline = time.monotonic() + START
    while len(made) < PACKETS + 2:  # one is read, one is being generated
        assert time.monotonic() < deadline
    assert [s.seq for s in ahead] == list(range(1, 100))
    assert next(ahead, None) is None
    ahead.close()


def test_an_abandoned_generator_can_be_closed() -> None:
    ahead = DrawnAhead(build(SPEC).imu_samples())
    assert next(ahead).seq == 0
    ahead.close()
    ahead.close()


def test_simulated_devices_start_without_scipy() -> None:
    """Which would take three quarters of their processes' start."""
    done = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, check=True)
    assert done.stdout.decode().strip() == "[]"
