"""The link with a simulated glove, over a real pseudo-terminal."""

from __future__ import annotations

import select
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tracker.messages import Event, ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.sensors.link_params import LinkState
from tracker.sensors.protocol import Haptic
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove, link_to

N = 3


def wave() -> Iterator[ImuSample]:
    """A known signal, 100 a second."""
    k = 0
    while True:
        t = 0.01 * k
        accel = np.full((N, 3), 9.8) + 0.1 * np.arange(N)[:, None]
        gyro = np.full((N, 3), np.sin(2 * np.pi * 0.5 * t))
        yield ImuSample(t, t, t, k, accel, gyro, np.ones(N, bool))
        k += 1


class Bench:
    """A simulated glove with a connected link."""

    def __init__(self, folder: Path, params: GloveDeviceParams | None = None, n: int = N) -> None:
        self.t_0 = time.monotonic()
        self.device = SimulatedGlove(wave(), N, self.t_0, params)
        self.folder = folder
        path = link_to(folder, self.device)
        self.link = GloveLink(serial_port(str(path)), n)
        self.samples: list[ImuSample] = []
        self.events: list[Event] = []

    def until(self, condition: Callable[[], bool], most: float = 10.0) -> None:
        deadline = time.monotonic() + most
        while not condition():
            assert time.monotonic() < deadline, [e.code for e in self.events]
            for item in self.link.poll(0.02):
                (self.events if isinstance(item, Event) else self.samples).append(item)  # type: ignore[arg-type]

    def reported(self, code: str) -> bool:
        return code in [e.code for e in self.events]

    def close(self) -> None:
        self.link.close()
        self.device.stop()


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[Bench]:
    bench = Bench(tmp_path)
    yield bench
    bench.close()


def test_samples_arrive_with_correct_units_and_times(bench: Bench) -> None:
    bench.until(lambda: len(bench.samples) > 150)
    link = bench.link
    assert link.hello is not None and link.hello.imu_count == N
    assert link.figures.lost == 0 and link.decoder.counters.errors == 0
    last = bench.samples[-1]
    assert last.accel[:, 0] == pytest.approx(9.8 + 0.1 * np.arange(N), abs=16 * 9.81 / 32768)
    # a sample's device time is exact; the latency of the line remains
    true = np.array([(s.t_device - 4.0) / (1 + 60e-6) for s in bench.samples[50:]]) + bench.t_0
    lateness = np.array([s.t for s in bench.samples[50:]]) - true
    assert np.median(lateness) < 0.02 and np.ptp(lateness) < 0.02
    # never earlier; equal where a busy computer reads the first two packets at once
    assert np.all(np.diff([s.t for s in bench.samples]) >= 0)


def test_lost_and_damaged_packets_are_counted_and_never_used(bench: Bench) -> None:
    bench.device.faults.drop, bench.device.faults.corrupt = 0.1, 0.1
    bench.until(lambda: len(bench.samples) > 250)
    assert bench.link.figures.lost >= 20
    assert bench.link.decoder.counters.errors >= 10
    assert all(np.allclose(s.accel[0], 9.8, atol=0.01) for s in bench.samples)
    missing = np.diff([s.seq for s in bench.samples]) - 1
    assert missing.sum() == bench.link.figures.lost


def test_repeated_packets_are_used_once_and_counted(bench: Bench) -> None:
    bench.until(lambda: len(bench.samples) > 20)
    feed, before = bench.link.decoder.feed, bench.link.figures.packets
    bench.link.decoder.feed = lambda data: [f for frame in feed(data) for f in (frame, frame)]  # type: ignore[method-assign]
    bench.until(lambda: len(bench.samples) > 70)
    figures = bench.link.figures
    assert figures.repeated == figures.packets - before >= 40
    assert figures.values()["glove_repeated"] == figures.repeated
    assert np.all(np.diff([s.seq for s in bench.samples]) >= 1)


def test_a_restart_while_streaming(bench: Bench) -> None:
    bench.until(lambda: len(bench.samples) > 20)
    bench.device.reset()
    n = len(bench.samples)
    bench.until(lambda: bench.reported("glove.restarted") and len(bench.samples) > n + 50)
    assert bench.link.figures.resets >= 1  # HELLO may arrive twice before START is received
    assert np.all(np.diff([s.t for s in bench.samples[n + 20 :]]) > 0)


def test_unplugged_and_back_under_another_path(bench: Bench) -> None:
    bench.until(lambda: len(bench.samples) > 20)
    bench.device.unplug()
    bench.until(lambda: bench.reported("glove.unplugged"))
    assert bench.link.state == LinkState.UNPLUGGED
    n = len(bench.samples)
    bench.device.plug()
    link_to(bench.folder, bench.device)
    bench.until(lambda: len(bench.samples) > n + 30)
    assert bench.link.state == LinkState.STREAMING and bench.reported("glove.sends_again")


def test_unplugged_between_waiting_and_reading_and_back(bench: Bench, monkeypatch) -> None:
    bench.until(lambda: len(bench.samples) > 20)
    wait = select.select

    def unplugged(*args: Any) -> Any:
        out = wait(*args)
        bench.device.unplug()
        return out

    with monkeypatch.context() as here:
        here.setattr(select, "select", unplugged)
        bench.events += [item for item in bench.link.poll(1.0) if isinstance(item, Event)]
    assert bench.reported("glove.unplugged") and bench.link.state == LinkState.UNPLUGGED
    bench.device.plug()
    link_to(bench.folder, bench.device)
    n = len(bench.samples)
    bench.until(lambda: len(bench.samples) > n + 20)


def test_missing_data_is_reported_until_it_resumes(bench: Bench) -> None:
    bench.until(lambda: len(bench.samples) > 20)
    bench.device.faults.silent = True
    bench.until(lambda: bench.reported("glove.silent"))
    assert bench.link.state == LinkState.SILENT
    bench.device.faults.silent = False
    n = len(bench.samples)
    bench.until(lambda: bench.reported("glove.sends_again") and len(bench.samples) > n + 10)
    assert bench.link.state == LinkState.STREAMING
    assert bench.link.figures.lost > 20, "what was not sent is counted as lost"


def test_a_port_that_is_not_there(tmp_path: Path) -> None:
    link = GloveLink(serial_port(str(tmp_path / "nothing")), N)
    events = [item for _ in range(3) for item in link.poll(0.01)]
    assert [e.code for e in events if isinstance(e, Event)] == ["glove.port_not_opened"]
    link.close()


def test_the_wrong_glove_file_is_named(tmp_path: Path) -> None:
    bench = Bench(tmp_path, n=7)
    bench.until(lambda: bench.reported("glove.imu_count"))
    assert not bench.samples
    bench.close()


def test_bunched_bytes_keep_their_times(tmp_path: Path) -> None:
    bench = Bench(tmp_path, GloveDeviceParams(bunch=0.016))
    bench.until(lambda: len(bench.samples) > 200)
    steps = np.diff([s.t for s in bench.samples[100:]])
    assert np.abs(steps - 0.01).max() < 0.004
    bench.close()


@pytest.mark.long
def test_motors_may_be_driven_from_another_thread_while_unplugging() -> None:
    """Frames are never interleaved, and a write to a missing port means an unplugged glove."""

    class Fragile:
        timeout: float | None = 0.0
        in_waiting = 0

        def __init__(self) -> None:
            self.writers, self.mixed, self.data, self.left = 0, False, b"", 400

        def read(self, size: int) -> bytes:
            return b""

        def write(self, data: bytes) -> int:
            self.writers += 1
            self.mixed |= self.writers > 1
            time.sleep(1e-4)
            self.writers -= 1
            self.left -= 1
            if self.left < 0:
                raise OSError(5, "Input/output error")
            self.data += data
            return len(data)

        def close(self) -> None: ...

    port = Fragile()
    link = GloveLink(lambda: port, 2)
    link.poll(0.0)

    def drive() -> None:
        while port.left >= 0:  # a thread that waits too long skips its command
            link.vibrate(port.left % 5, 200, 80)

    threads = [threading.Thread(target=drive) for _ in range(2)]
    for thread in threads:
        thread.start()
    codes = []
    while any(t.is_alive() for t in threads):
        codes += [e.code for e in link.poll(0.001) if not isinstance(e, ImuSample)]
    codes += [e.code for e in link.poll(0.0) if not isinstance(e, ImuSample)]
    assert not port.mixed
    assert "glove.unplugged" in codes
    haptics = [f for f in FrameDecoder().feed(port.data) if isinstance(f, Haptic)]
    assert len(haptics) > 390 and {h.amplitude for h in haptics} == {200}


def test_a_port_is_not_closed_while_it_is_read() -> None:
    """A motor command may find it closed; reading a closed port raises no OSError."""

    class Gone:
        timeout: float | None = 0.0
        in_waiting = 0

        def __init__(self) -> None:
            self.reading, self.written = threading.Event(), threading.Event()
            self.closed_amid: list[bool] = []

        def read(self, size: int) -> bytes:
            self.reading.set()
            assert self.written.wait(10)
            self.reading.clear()
            return b""

        def write(self, data: bytes) -> int:
            if self.reading.is_set():
                raise OSError(5, "Input/output error")
            return len(data)

        def close(self) -> None:
            self.closed_amid.append(self.reading.is_set())

    port = Gone()
    link = GloveLink(lambda: port, 2)

    def write() -> None:
        assert port.reading.wait(10)
        link.vibrate(1, 200, 80)
        port.written.set()

    thread = threading.Thread(target=write)
    thread.start()
    codes = [item.code for item in link.poll(0.0) if isinstance(item, Event)]
    thread.join()
    assert port.closed_amid == [False] and codes[0] == "glove.unplugged"
    assert link.state == LinkState.UNPLUGGED
