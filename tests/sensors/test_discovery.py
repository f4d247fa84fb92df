"""Finding gloves among ports, without disturbing other devices."""

from __future__ import annotations

import errno
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tracker.base.notices import warning
from tracker.messages import ImuSample
from tracker.sensors.discovery import find_gloves, latency_advice, probe, serial_ports
from tracker.sensors.glove_link import serial_port
from tracker.sensors.protocol import Hello, HelloRequest, Samples, encode
from tracker.sensors.serial_line import UsbPort
from tracker.simulation.glove_device import SimulatedGlove


class FakePort:
    """Sends ``data`` repeatedly, one read per 0.1 s, and stores what it receives."""

    timeout: float | None = 0.1

    def __init__(self, data: bytes) -> None:
        self.data, self.received, self.t, self.closed = data, b"", 0.0, False

    @property
    def in_waiting(self) -> int:
        return len(self.data)

    def read(self, size: int) -> bytes:
        self.t += 0.1
        return self.data[:size]

    def write(self, data: bytes) -> int:
        self.received += data
        return len(data)

    def close(self) -> None:
        self.closed = True


def ask(port: FakePort, timeout: float = 2.0) -> object:
    return probe("/dev/x", lambda: port, timeout, lambda: port.t)


def test_other_devices_receive_only_the_request() -> None:
    port = FakePort(b"$GPGGA,123519,4807.038,N\r\n")
    report = ask(port)
    assert not report.is_glove
    assert report.problem is not None and report.problem.code == "port.not_glove"
    assert port.received.replace(b"\0" + encode(HelloRequest()), b"") == b""
    assert port.received.count(encode(HelloRequest())) == 4
    assert port.closed


def test_no_answer_is_reported() -> None:
    assert ask(FakePort(b"")).problem == warning("port.no_answer", port="/dev/x")


def test_hello_between_garbage() -> None:
    hello = Hello(glove_id=77, imu_count=7)
    report = ask(FakePort(b"\x13\x37\0" + encode(hello)))
    assert report.is_glove
    assert report.hello == hello


def test_a_streaming_glove_is_found_too() -> None:
    report = ask(FakePort(encode(Samples(1, 2, np.zeros((7, 6), np.int16)))))
    assert report.is_glove
    assert report.hello is None


class SlowGlove(FakePort):
    """Works only at 115200 baud; at another rate both sides receive garbage."""

    baudrate = 250_000

    def read(self, size: int) -> bytes:
        data_read = super().read(size)
        return data_read if self.baudrate == 115_200 else bytes(b ^ 0x5A for b in data_read)

    def write(self, data: bytes) -> int:
        return super().write(data) if self.baudrate == 115_200 else len(data)


def test_both_speeds_are_tried_on_a_port_opened_once() -> None:
    port, opened = SlowGlove(encode(Hello(glove_id=5, imu_count=7))), []

    def open_port() -> SlowGlove:
        opened.append(port)
        return port

    report = probe("/dev/x", open_port, 4.0, lambda: port.t)
    assert report.hello is not None and report.hello.glove_id == 5
    assert report.baud == 115_200 and len(opened) == 1
    only_fast = probe("/dev/x", open_port, 2.0, lambda: port.t, bauds=(250_000,))
    assert not only_fast.is_glove and only_fast.problem is not None
    assert only_fast.problem.values["bauds"] == (250_000,)


@pytest.mark.parametrize(
    ("number", "words"),
    [(errno.EACCES, "usermod -aG dialout"), (errno.ENOENT, "not there"), (errno.EBUSY, "another")],
)
def test_a_port_that_cannot_be_opened(number: int, words: str) -> None:
    def refuse() -> FakePort:
        raise OSError(number, "no")

    report = probe("/dev/x", refuse)
    assert not report.is_glove
    assert report.problem is not None and report.problem.code == "port.not_opened"
    assert words in str(report.problem.values["why"])


def still() -> Iterator[ImuSample]:
    one = np.ones(2, bool)
    for k in range(10_000):
        yield ImuSample(k / 100, k / 100, k / 100, k, np.zeros((2, 3)), np.zeros((2, 3)), one)


def test_a_simulated_glove_among_absent_ports(tmp_path: Path) -> None:
    device = SimulatedGlove(still(), 2)
    try:
        absent, there = find_gloves([str(tmp_path / "none"), str(device.path)], timeout=3.0)
        assert absent.problem is not None and absent.problem.code == "port.not_opened"
        assert there.hello is not None
        assert there.hello.imu_count == 2
        second = probe(str(device.path), serial_port(str(device.path)), 3.0)
        assert second.hello == there.hello  # the request changed nothing: it still sends HELLO
    finally:
        device.stop()


def test_ports_are_listed_without_error() -> None:
    assert all(p.startswith("/dev/") for p in serial_ports())


@pytest.mark.parametrize(("value", "is_warned"), [("16\n", True), ("1\n", False), ("?", False)])
def test_latency_timer(tmp_path: Path, value: str, is_warned: bool) -> None:
    folder = tmp_path / "ttyUSB0"
    folder.mkdir()
    (folder / "latency_timer").write_text(value)
    advice = latency_advice("/dev/ttyUSB0", tmp_path, "linux")
    assert (advice is not None) == is_warned
    if advice is not None:
        assert (advice.code, advice.values["latency_ms"]) == ("port.latency_linux", 16)
    assert latency_advice("/dev/ttyACM0", tmp_path, "linux") is None


@pytest.mark.parametrize(("vid", "is_warned"), [(0x0403, True), (0x1A86, False)])
def test_windows_stores_the_latency_in_the_device_manager(vid: int, is_warned: bool) -> None:
    ports = [UsbPort("COM7", vid, 0x6001, "A1")]
    advice = latency_advice("COM7", system="win32", ports=lambda: ports)
    assert advice == (warning("port.latency_windows", port="COM7") if is_warned else None)
