"""SIGKILL of either process: at most half a second is lost, and no shared memory is left."""

from __future__ import annotations

import multiprocessing
import os
import random
import signal
import time
from ctypes import c_long
from pathlib import Path

import psutil
import pytest

from tests.notices import raises
from tests.session.conftest import ANCHOR, RESOURCES, MessageMaker
from tests.session.recording.conftest import left_since, shared_names
from tracker.live.recording import RecordingThread
from tracker.messages import ImuSample
from tracker.session.description import SessionInfo, describe
from tracker.session.reader import SessionReader
from tracker.session.recording.process import RecorderProcesses
from tracker.session.recover import needs_recovery, recover
from tracker.session.verify import is_ok, verify
from tracker.vision.rig import ideal_rig

PERIOD = 0.01  # s from packet to packet, in real time
MOST_LOST = 0.5  # s

pytestmark = [
    pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="a signal of POSIX"),
    pytest.mark.long,
]


def info() -> SessionInfo:
    return describe(
        (RESOURCES / "hands" / "reference-right.toml").read_text(),
        (RESOURCES / "gloves" / "vist-small.toml").read_text(),
        ANCHOR,
        rig=ideal_rig(64, 48),
    )


def stream(thread: RecordingThread, maker: MessageMaker, last_put, until: float = 1e9) -> None:
    """A live run; ``last_put`` is the last packet put. Packets' times are those that pass."""
    begun, k = time.monotonic(), 0
    while k * PERIOD < until:
        time.sleep(max(0.0, begun + k * PERIOD - time.monotonic()))
        thread.put(maker.imu(1e3 * PERIOD * k, k))
        thread.put(maker.estimate(1e3 * PERIOD * k))
        if k % 3 == 0:
            thread.put(maker.image(1e3 * PERIOD * k, k))
        last_put.value = k
        k += 1


def packets(path: Path) -> list[int]:
    with SessionReader(path) as reader:
        return [m.seq for m in reader.messages((ImuSample,))]


def lost_s(path: Path, last: int) -> float:
    """Packets of the file; none is missing in between."""
    found = packets(path)
    assert found == list(range(len(found)))
    return (last + 1 - len(found)) * PERIOD


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_killed_recorder_is_reported_and_the_next_one_records_at_once(
    tmp_path, recorders, seed
) -> None:
    path, reports, last_put = tmp_path / "a.mcap", [], c_long(-1)
    processes, maker = recorders(), MessageMaker(info())
    recorder = processes.record(path, maker.info)
    thread = RecordingThread(recorder, lambda *report: reports.append(report))
    stream(thread, maker, last_put, 0.7 + random.Random(seed).uniform(0, 0.5))
    os.kill(recorder.pid, signal.SIGKILL)
    last = last_put.value
    deadline = time.monotonic() + 10
    while not reports and time.monotonic() < deadline:
        thread.put(maker.imu(1e4, 9999))
        time.sleep(0.01)
    thread.finish()
    [(kind, ended)] = reports
    assert (kind, ended.code) == ("error", "recording.ended") and "signal 9" in str(ended)
    assert str(path) in str(ended)
    assert needs_recovery(path)
    assert lost_s(recover(path).path, last) <= MOST_LOST

    again = processes.record(tmp_path / "b.mcap", maker.info)
    assert again.pid != recorder.pid
    for k in range(20):
        again.write(maker.imu(10.0 * k, k))
    again.close()
    assert is_ok(verify(tmp_path / "b.mcap"))


def test_a_recorder_killed_while_idle_is_replaced(tmp_path, recorders) -> None:
    processes, about = recorders(), info()
    first = processes.record(tmp_path / "a.mcap", about)
    first.close()
    os.kill(first.pid, signal.SIGKILL)
    deadline = time.monotonic() + 5
    while psutil.pid_exists(first.pid) and time.monotonic() < deadline:
        multiprocessing.active_children()  # reaps it
        time.sleep(0.01)
    second = processes.record(tmp_path / "b.mcap", about)
    second.close()
    assert second.pid != first.pid


def victim(path: Path, last_put: c_long, pid: c_long) -> None:
    """A window that records endlessly, and ends when its terminal does (the test runner may have
    changed that, as nohup does)."""
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    maker = MessageMaker(info())
    recorder = RecorderProcesses().record(path, maker.info)
    pid.value = recorder.pid
    stream(RecordingThread(recorder, lambda *_: None), maker, last_put)


@pytest.fixture
def window(tmp_path):
    """``window()`` starts one and returns (process, the recorder's pid, last packet sent)."""
    context, begun = multiprocessing.get_context("spawn"), []

    def begin(path: Path):
        last_put, pid = (context.Value(c_long, -1, lock=False) for _ in range(2))
        process = context.Process(target=victim, args=(path, last_put, pid))
        process.start()
        begun.append((process, pid))
        deadline = time.monotonic() + 60
        while last_put.value < 80 and time.monotonic() < deadline:
            time.sleep(0.01)
        assert process.is_alive() and pid.value > 0
        return process, pid.value, last_put

    yield begin
    for process, pid in begun:
        process.kill()
        process.join()
        if psutil.pid_exists(pid.value):
            os.kill(pid.value, signal.SIGKILL)


def has_ended(pid: int, timeout: float) -> bool:
    deadline = time.monotonic() + timeout
    while psutil.pid_exists(pid) and time.monotonic() < deadline:
        if psutil.Process(pid).status() == psutil.STATUS_ZOMBIE:
            return True  # its parent has ended, and only init may reap it
        time.sleep(0.02)
    return not psutil.pid_exists(pid)


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGHUP, signal.SIGINT])
def test_the_file_of_a_killed_window_is_finished(tmp_path, window, number) -> None:
    """Closing a terminal, or Ctrl+C in it, signals both processes at once."""
    path, before = tmp_path / "a.mcap", shared_names()
    process, pid, last_put = window(path)
    if number != signal.SIGKILL:
        os.kill(pid, number)
    os.kill(process.pid, signal.SIGKILL if number != signal.SIGHUP else number)
    process.join(20)
    assert has_ended(pid, 20.0)
    assert not needs_recovery(path)
    assert is_ok(verify(path))
    assert lost_s(path, last_put.value) <= MOST_LOST
    assert not left_since(before)


def test_the_file_of_both_killed_processes_can_be_recovered(tmp_path, window) -> None:
    path, before = tmp_path / "a.mcap", shared_names()
    process, pid, last_put = window(path)
    os.kill(pid, signal.SIGKILL)
    os.kill(process.pid, signal.SIGKILL)
    process.join(20)
    assert has_ended(pid, 20.0)
    assert needs_recovery(path)
    assert lost_s(recover(path).path, last_put.value) <= MOST_LOST
    assert not left_since(before)


def test_a_stopped_recorder_is_replaced_and_finishes_when_resumed(
    tmp_path, recorders, monkeypatch
) -> None:
    monkeypatch.setattr("tracker.session.recording.process.SEND_TIMEOUT", 1)
    path, reports, last_put = tmp_path / "a.mcap", [], c_long(-1)
    processes, maker = recorders(), MessageMaker(info())
    recorder = processes.record(path, maker.info)
    thread = RecordingThread(recorder, lambda *report: reports.append(report))
    stream(thread, maker, last_put, 0.5)
    os.kill(recorder.pid, signal.SIGSTOP)
    try:
        begun = time.monotonic()
        while not reports and time.monotonic() < begun + 30:
            thread.put(maker.estimate(1e4))
            time.sleep(0.0005)
        thread.finish()
        assert reports[0][1].code == "recording.ended"
        processes.record(tmp_path / "b.mcap", maker.info).close()
    finally:
        os.kill(recorder.pid, signal.SIGCONT)
    assert has_ended(recorder.pid, 20.0)
    assert not needs_recovery(path)
    assert packets(path) == list(range(last_put.value + 1))


def test_a_terminated_recorder_finishes_its_file(tmp_path, recorders) -> None:
    """As at the end of a login session, where every process gets SIGTERM."""
    path, about = tmp_path / "a.mcap", info()
    recorder, maker = recorders().record(path, about), MessageMaker(about)
    for k in range(50):
        recorder.write(maker.imu(10.0 * k, k))
    recorder.flush()
    time.sleep(0.2)
    os.kill(recorder.pid, signal.SIGTERM)
    assert has_ended(recorder.pid, 20.0)
    assert not needs_recovery(path) and packets(path) == list(range(50))
    with raises(Exception, "recording.process_ended"):
        recorder.close()
