"""Each electrical fault of a simulated glove is recognised, and reported with its remedy."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tracker.messages import Event, ImuSample
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.motor_events import KIND as MOTOR
from tracker.sensors.serial_line import UsbPort, is_suspended, serial_port
from tracker.simulation.electric import ELECTRIC_FAULTS
from tracker.simulation.glove_device import SimulatedGlove
from tracker.simulation.virtual_devices import VirtualGlove

N = 4
EXPECTED = {
    "brown-out": "glove.brown_out",
    "flexed cable": "glove.cable_damaged",
    "loose select": "glove.imu_loose",
    "motor reset": "glove.reset_by_motor",
    "usb suspend": "glove.usb_suspended",
    "wrong baud": "glove.wrong_baud",
    "port busy": "glove.port_busy",
    "port denied": "glove.port_denied",
}
AT_OPENING = ("wrong baud", "port busy", "port denied")


def packets() -> Iterator[ImuSample]:
    rng = np.random.default_rng(1)
    for k in range(3000):
        t = k / 100
        gyro = rng.normal(0, 0.01, (N, 3))
        yield ImuSample(t, t, t, k, gyro + [0, 0, 9.81], gyro, np.ones(N, bool))


class Bench:
    def __init__(self) -> None:
        self.now = 0.0
        self.glove = VirtualGlove(packets(), N)
        self.link = GloveLink(self.glove.open, N, clock=lambda: self.now)
        self.codes: list[str] = []

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while self.now < end:
            self.now += 0.01
            self.glove.advance(self.now)
            for item in self.link.poll(0.0):
                if isinstance(item, Event):
                    self.codes.append(item.notice.code)


def test_every_fault_has_a_notice() -> None:
    assert set(EXPECTED) == set(ELECTRIC_FAULTS)


@pytest.mark.parametrize("kind", ELECTRIC_FAULTS)
def test_the_fault_is_named(kind: str) -> None:
    bench = Bench()
    if kind not in AT_OPENING:
        bench.run(1.0)
    healthy = list(bench.codes)
    bench.glove.fail(kind)
    bench.run(0.1)
    if kind != "brown-out":  # a motor would explain its restarts
        bench.link.vibrate(0, 200, 100)
    bench.run(7.0)
    named = [code for code in bench.codes if code in EXPECTED.values()]
    assert named == [EXPECTED[kind]] and healthy == []


def test_a_motor_that_restarts_a_simulated_glove_is_named() -> None:
    """The same faults on the real-time device of ``glovetrack rig``."""
    device = SimulatedGlove(packets(), N, time.monotonic())
    try:
        device.fail("motor reset")
        link = GloveLink(serial_port(device.path), N)
        codes: list[str] = []
        end = time.monotonic() + 20.0
        while "glove.reset_by_motor" not in codes and time.monotonic() < end:
            for item in link.poll(0.01):
                if isinstance(item, Event) and item.kind != MOTOR:
                    codes.append(item.notice.code)
            if link.figures.packets > 120 and not codes:  # a HELLO sooner may be a late answer
                link.vibrate(0, 200, 100)
        link.close()
    finally:
        device.stop()
    assert codes[:2] == ["glove.restarted", "glove.reset_by_motor"]


def test_a_single_restart_or_damaged_frame_has_no_electrical_cause() -> None:
    bench = Bench()
    bench.run(1.0)
    bench.glove.fail("reset")
    bench.run(3.0)
    assert bench.codes == ["glove.restarted"]


def test_two_adapters_with_one_serial_number_are_reported_once() -> None:
    bench = Bench()
    twins = [UsbPort(f"/dev/ttyUSB{k}", 0x1A86, 0x7523, "0001") for k in range(2)]
    place = GlovePort(
        "/dev/ttyUSB0", ports=lambda: twins, open_at=lambda path, baud: bench.glove.open
    )
    bench.link = GloveLink(place, N, clock=lambda: bench.now)
    bench.run(1.0)
    bench.glove.fail("unplug")
    bench.run(0.5)
    bench.glove.heal()
    bench.run(2.0)
    assert bench.codes.count("glove.twin_adapters") == 1


@pytest.mark.parametrize("status", ["active", "suspended"])
def test_suspension_is_read_from_the_usb_device_of_a_port(tmp_path: Path, status: str) -> None:
    device = tmp_path / "devices" / "usb1" / "1-1" / "1-1:1.0" / "ttyUSB0"
    device.mkdir(parents=True)
    power = tmp_path / "devices" / "usb1" / "1-1" / "power"
    power.mkdir()
    (power / "runtime_status").write_text(f"{status}\n")
    port = tmp_path / "tty" / "ttyUSB0"
    port.mkdir(parents=True)
    (port / "device").symlink_to(device)
    assert is_suspended("/dev/ttyUSB0", tmp_path / "tty") == (status == "suspended")
