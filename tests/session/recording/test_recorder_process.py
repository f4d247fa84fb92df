"""Recording in another process: the same file, the same messages, and no blocking."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from mcap.reader import make_reader

from tests.session.conftest import MessageMaker, at
from tests.session.recording.spoilers import (
    BrokenSync,
    FullDisk,
    SlowDisk,
    SlowEncoder,
    SmallFiles,
)
from tracker.base.errors import FileError
from tracker.live.recording import RecordingThread
from tracker.messages import EngineState, ImuSample, StereoFrame
from tracker.session.reader import SessionReader
from tracker.session.recover import needs_recovery, recover
from tracker.session.verify import is_ok, verify
from tracker.session.writer import RecorderParams, SessionRecorder

PNG = RecorderParams(images="png", sync=False)


def contents(path: Path) -> list[tuple[object, ...]]:
    """Every message by the reader of the format's own authors, in the order of log times."""
    with path.open("rb") as file:
        found = [
            (m.log_time, c.topic, m.publish_time, m.sequence, m.data)
            for _, c, m in make_reader(file, validate_crcs=True).iter_messages()
        ]
    return sorted(found)


def attachments(path: Path) -> list[tuple[str, int, bytes]]:
    with path.open("rb") as file:
        found = make_reader(file).iter_attachments()
        return sorted((a.name, a.log_time, a.data) for a in found)


def play(recorder, messages, together: int = 20) -> None:
    """Write and close as the disk thread does, but wait while an image has no slot."""
    for i, message in enumerate(messages):
        while not recorder.write(message):
            recorder.flush()
            time.sleep(0.002)
        if i % together == 0:
            recorder.flush()
    recorder.close()


def test_the_file_equals_that_of_a_recorder_in_the_same_process(
    tmp_path, recorders, session_info, maker
) -> None:
    state = EngineState(at(3), "chain", (np.arange(6.0), [2.5]))
    messages = [state, *maker.stream(600)]
    here, there = tmp_path / "here.mcap", tmp_path / "there.mcap"
    play(SessionRecorder(here, session_info, PNG), messages)
    play(recorders().record(there, session_info, PNG), messages)
    assert contents(there) == contents(here)
    assert attachments(there) == attachments(here)
    assert is_ok(verify(there))
    with SessionReader(there) as reader:
        [found] = reader.engine_states()
    assert (found.engine, found.t) == ("chain", state.t)
    assert np.array_equal(found.state[0], np.arange(6.0)) and found.state[1] == [2.5]


def test_successive_recordings_use_the_same_process(
    tmp_path, recorders, session_info, maker
) -> None:
    processes, pids = recorders(), set()
    for n in range(4):
        recorder = processes.record(tmp_path / f"{n}.mcap", session_info)
        pids.add(recorder.pid)
        play(recorder, [maker.imu(10.0 * k, k) for k in range(n)])  # the first is empty
    assert len(pids) == 1
    for n in range(4):
        with SessionReader(tmp_path / f"{n}.mcap") as reader:
            assert reader.source.contents.finished
            assert len(list(reader.messages((ImuSample,)))) == n


def test_two_simultaneous_recordings_use_a_process_each(
    tmp_path, recorders, session_info, maker
) -> None:
    processes = recorders()
    a, b = (processes.record(tmp_path / f"{n}.mcap", session_info) for n in "ab")
    assert a.pid != b.pid
    for recorder in (a, b):
        play(recorder, [maker.imu(0.0, 0), maker.image(1.0, 0)])
    assert is_ok(verify(tmp_path / "a.mcap")) and is_ok(verify(tmp_path / "b.mcap"))


def test_an_idle_process_begins_at_once(tmp_path, recorders, session_info) -> None:
    processes = recorders()
    processes.record(tmp_path / "a.mcap", session_info).close()
    times = []
    for n in range(5):
        started = time.monotonic()
        recorder = processes.record(tmp_path / f"b{n}.mcap", session_info)
        times.append(time.monotonic() - started)
        recorder.close()
    assert min(times) < 0.1  # the first includes the start of Python


LOADED = """
import multiprocessing, sys
from tracker.base.callbacks import ignore
from tracker.session.recording.child import serve

here, there = multiprocessing.Pipe()
here.close()
assert "tracker.session.export.urdf" not in sys.modules
serve(there, ignore)
assert "tracker.session.export.urdf" in sys.modules
"""


def test_the_first_file_needs_no_further_imports() -> None:
    """With scipy, two seconds were missing from the recording on a loaded computer."""
    done = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_errors_are_those_of_a_recorder_in_the_same_process(
    tmp_path, recorders, session_info
) -> None:
    processes, taken = recorders(), tmp_path / "a.mcap"
    taken.write_bytes(b"mine")
    for path in (taken, tmp_path / "no" / "a.mcap"):
        with pytest.raises(FileError) as here:
            SessionRecorder(path, session_info)
        with pytest.raises(FileError) as there:
            processes.record(path, session_info)
        assert str(there.value) == str(here.value)
    assert taken.read_bytes() == b"mine"
    processes.record(tmp_path / "b.mcap", session_info).close()


def until_it_fails(recorder, maker: MessageMaker) -> FileError:
    """The error that ends writing; afterwards the recorder is closed as after any other."""
    try:
        for k in range(3000):
            recorder.write(maker.imu(10.0 * k, k))
            recorder.flush()
            if k % 100 == 0:
                time.sleep(0.01)
        recorder.close()
    except FileError as error:
        recorder.close()
        return error
    raise AssertionError("nothing failed")


@pytest.mark.long
@pytest.mark.parametrize(
    ("spoiler", "words"),
    [
        (FullDisk(200_000), "cannot be written: the disk is full."),
        (SmallFiles(200_000), "cannot be written: the disk allows no file this large."),
        (BrokenSync(4), "cannot be written: the disk failed or was taken away."),
    ],
)
def test_a_failing_disk_is_reported_alike_and_leaves_complete_chunks(
    tmp_path, recorders, session_info, maker, spoiler, words
) -> None:
    path = tmp_path / "a.mcap"
    recorder = recorders(spoiler).record(path, session_info)
    error = until_it_fails(recorder, maker)
    assert str(error) == f"{path} {words}"
    assert needs_recovery(path)
    saved = recover(path)
    assert saved.messages > 100
    assert all(d.what.code == "check.breaks_off" for d in saved.damage)


def test_after_a_full_disk_the_same_process_records_elsewhere(
    tmp_path, recorders, session_info, maker
) -> None:
    processes = recorders(SmallFiles(200_000))
    first = processes.record(tmp_path / "a.mcap", session_info)
    until_it_fails(first, maker)
    second = processes.record(tmp_path / "b.mcap", session_info)
    assert second.pid == first.pid
    play(second, [maker.imu(10.0 * k, k) for k in range(50)])
    assert is_ok(verify(tmp_path / "b.mcap"))


@pytest.mark.long
def test_a_slow_disk_loses_nothing(tmp_path, recorders, session_info, maker) -> None:
    """Each sync takes 1 s, and there are over a hundred chunks: two minutes in total."""
    path, messages = tmp_path / "a.mcap", list(maker.stream(2000))
    params = RecorderParams(images="png", chunk_bytes=16 * 1024)
    recorder = recorders(SlowDisk(1.0)).record(path, session_info, params)
    started = time.monotonic()
    play(recorder, messages)
    assert time.monotonic() - started < 60.0
    with SessionReader(path) as reader:
        kinds = [type(m).__name__ for m in reader.messages()]
        assert len(reader.source.contents.spans) > 100
    assert (kinds.count("ImuSample"), kinds.count("StereoFrame")) == (200, 100)


def test_a_slow_encoder_loses_images_which_are_counted_but_no_packets(
    tmp_path, recorders, session_info, maker
) -> None:
    """Two threads at 0.1 s per image: ten pairs per second, of a hundred at once."""
    path, reports = tmp_path / "a.mcap", []
    recorder = recorders(SlowEncoder(0.1)).record(path, session_info)
    thread = RecordingThread(recorder, lambda *report: reports.append(report))
    for k in range(100):
        thread.put(maker.imu(10.0 * k, k))
        thread.put(maker.image(10.0 * k, k))
        time.sleep(0.002)
    thread.finish()  # while images are still being compressed
    assert [kind for kind, _ in reports] == ["recording"] and 0 < thread.thinned < 100
    with SessionReader(path) as reader:
        assert reader.source.contents.finished
        found = list(reader.messages((ImuSample, StereoFrame)))
    assert [m.seq for m in found if isinstance(m, ImuSample)] == list(range(100))
    images = [m.index for m in found if isinstance(m, StereoFrame)]
    assert images == sorted(images) and len(images) == 100 - thread.thinned


def test_sending_never_blocks_on_a_stalled_process(
    tmp_path, recorders, session_info, maker
) -> None:
    recorder = recorders(SlowEncoder(0.5)).record(tmp_path / "a.mcap", session_info)
    thread = RecordingThread(recorder, lambda *_: None)
    sample, image = maker.imu(0.0, 0), maker.image(0.0, 0)
    longest = 0.0
    for _ in range(300):
        started = time.thread_time()
        thread.put(sample)
        thread.put(image)
        longest = max(longest, time.thread_time() - started)
    thread.finish()
    assert longest < 0.02
    assert thread.thinned > 200


def test_images_of_another_size_and_of_one_camera_are_recorded(
    tmp_path, recorders, session_info, maker
) -> None:
    path, rng = tmp_path / "a.mcap", np.random.default_rng(3)
    recorder = recorders().record(path, session_info, PNG)
    sent = []
    for k, (h, w) in enumerate([(48, 64), (96, 128), (24, 32), (96, 130)]):
        image = rng.integers(0, 256, (h, 2 * w, 3), dtype=np.uint8)
        left, right = image[:, :w], image[:, w:]  # views, as of a camera side by side
        sent.append(StereoFrame(at(k), at(k + 1), left, right if k != 2 else None, index=k))
    play(recorder, sent)
    with SessionReader(path) as reader:
        found = list(reader.messages((StereoFrame,)))
    assert [m.index for m in found] == [0, 1, 2, 3]
    for a, b in zip(sent, found, strict=True):
        assert np.array_equal(a.left, b.left)
        assert (a.right is None) == (b.right is None)
        assert a.right is None or np.array_equal(a.right, b.right)
