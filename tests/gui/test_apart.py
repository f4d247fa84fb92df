"""Tracking in a process of its own: the demo in a real process, and its two ends in one process."""

import logging
import os
import select
import signal
import socket
import threading
import time
from dataclasses import replace

import numpy as np
import pytest

import glovetrack
from app.engines.apart.demo import DemoSource
from app.engines.demo_camera import DemoChoice
from app.engines.protocols import RecordingRequest
from app.jobs.calibration_commands import CalibrationCommands
from app.platform.tasks import JobProgress
from app.window.sources import Reserve
from app.wizards.guided.dialog import GuidedCommands
from tests.gui.apart_engine import Scripted, Subscribed, connect, eventually
from tests.gui.gui_fakes import models, scripted_setup
from tracker.base.errors import ConfigError, DeviceError
from tracker.base.notices import failure, notice
from tracker.base.shared_memory import NoSharedMemory
from tracker.messages import Event, Tracking
from tracker.offline.options import TrackOptions
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.latency import latencies_of
from tracker.session.recover import needs_recovery
from tracker.streaming.registry import StreamSettings, with_streams

__all__ = ["connect"]  # a fixture

LONG = 120_000  # ms, on a loaded computer
CHOICE = DemoChoice(fps=10.0, scene="plain", camera_errors="none")


def is_tracked(window) -> bool:
    view = window.host.snapshot()
    return view is not None and view.estimate is not None and view.estimate.tracking == 1


def has_delays(host) -> bool:
    """Whether the engine has been sent the delays of the window and of the streams."""
    values = host.setup.tracked.status().values
    return {"latency_screen_ms", "latency_stream_ms"} <= values.keys()


@pytest.fixture
def receiver():
    """A port that a stream is sent to."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        yield receiver


@pytest.fixture
def demo(window, qtbot, receiver):
    """The window with the demo in a process of its own, and the hand found."""
    port = receiver.getsockname()[1]
    window.outputs.apart = True
    window.outputs.use(with_streams(StreamSettings(), f"udp:{port}", "", ""))
    window.sources.apart = True
    window.sources.open_demo(CHOICE)
    qtbot.waitUntil(lambda: window.host.running, timeout=LONG)
    qtbot.waitUntil(lambda: is_tracked(window), timeout=LONG)
    return window


@pytest.mark.long
@pytest.mark.timeout(400)
def test_a_recording_is_complete_although_the_process_crashes(
    demo, receiver, qtbot, tmp_path, caplog
):
    """A first recording is tracked again bit for bit. During a second one the process crashes:
    tracking starts again in the process that was waiting, the file is complete up to then, and the
    log shows where. A stream is received meanwhile."""
    host, done, errors = demo.host, [], []
    host.recording.finished.connect(done.append)
    host.error.connect(errors.append)
    qtbot.waitUntil(lambda: bool(select.select([receiver], [], [], 0)[0]), timeout=LONG)
    assert b"index_tip" in receiver.recv(65536)
    answers = []
    calibration, guided = CalibrationCommands(host), GuidedCommands(host, host.setup.side)
    calibration.learned.connect(answers.append)
    guided.known.connect(answers.append)
    assert host.recording.begin(RecordingRequest(tmp_path / "a.mcap", "", ""))
    assert calibration.ask() and guided.ask()
    qtbot.waitUntil(lambda: len(answers) == 2, timeout=LONG)
    assert guided.restore_snapshot(answers[1]) and calibration.freeze(True)
    qtbot.waitUntil(lambda: has_delays(host), timeout=LONG)  # the window is slow under load
    begun = host.setup.tracked.latest_estimate().t
    qtbot.waitUntil(lambda: host.setup.tracked.latest_estimate().t > begun + 1.5, timeout=LONG)
    host.recording.end()
    qtbot.waitUntil(lambda: len(done) == 1, timeout=LONG)
    late = latencies_of(tmp_path / "a.mcap")
    assert all(0.0 < late[what]["median_ms"] < 1e4 for what in ("screen", "stream")), late
    track(tmp_path / "a.mcap", tmp_path / "again.mcap", TrackOptions())
    found = compare(tmp_path / "a.mcap", tmp_path / "again.mcap")
    assert found["identical"], found

    engine, reserve = host.setup.engine, demo.sources.second.reserve
    demo.sources.second._settled.timeout.emit()
    waiting = reserve._started.process.pid
    assert host.recording.begin(RecordingRequest(tmp_path / "b.mcap", "", ""))
    qtbot.waitUntil(lambda: host.recording.written > 50, timeout=LONG)
    os.kill(engine._process.pid, signal.SIGSEGV)
    qtbot.waitUntil(lambda: len(done) == 2, timeout=LONG)
    qtbot.waitUntil(
        lambda: host.setup is not None and host.setup.engine is not engine and host.running,
        timeout=LONG,
    )
    assert host.setup.engine._process.pid == waiting and reserve._started is None
    assert any("starts again" in text for text in errors)
    assert "Segmentation fault" in caplog.text
    assert not engine._process._crash.exists()
    qtbot.waitUntil(lambda: not needs_recovery(tmp_path / "b.mcap"), timeout=LONG)
    recording = glovetrack.open(tmp_path / "b.mcap")
    assert len(recording.t) > 20
    qtbot.waitUntil(lambda: is_tracked(demo), timeout=LONG)


@pytest.mark.long
def test_a_waiting_process_is_replaced_after_its_end_and_ends_with_the_window():
    reserve, source = Reserve(), DemoSource(CHOICE)
    reserve.fill(source)
    first = reserve._started.process
    reserve.fill(source)
    assert reserve._started.process is first
    first.kill()
    first.join()
    reserve.fill(source)
    second = reserve._started
    assert second.process.pid != first.pid
    reserve.close()
    reserve.fill(source)
    second.process.join(LONG / 1000)
    assert not second.process.is_alive() and not second.crash.exists()
    assert reserve._started is None


@pytest.mark.long
def test_a_source_is_opened_although_the_waiting_process_has_ended(connect):
    """And where none was waiting."""
    reserve, source = Reserve(), Scripted(scripted_setup(Subscribed()))
    reserve.fill(source)
    reserve._started.pipe.close()
    for _ in range(2):
        process = reserve.open(source)
        assert process.wait_opened(JobProgress(lambda *_: None)).hands
        process.close()


# --- both ends in one process


def test_the_window_sees_what_the_engine_has(connect):
    engine = Subscribed()
    setup = connect(scripted_setup(engine))
    eventually(lambda: setup.tracked.latest_frame() is not None)
    image, blobs, result = setup.tracked.latest_frame()
    true_image, true_blobs, true_result = engine.latest_frame()
    np.testing.assert_array_equal(image.left, true_image.left)
    np.testing.assert_array_equal(image.right, true_image.right)
    np.testing.assert_array_equal(blobs.left.uv, true_blobs.left.uv)
    np.testing.assert_array_equal(result.match_left, true_result.match_left)
    assert setup.tracked.latest_frame(image.t) is not None
    assert setup.tracked.latest_frame(image.t + 1.0) is None
    assert len(setup.tracked.recent_imu()) == len(engine.recent_imu())
    assert setup.tracked.calibration().hand_length == engine.calibration().hand_length
    assert setup.tracked.status().values.items() >= engine.status().values.items()
    assert [event.text for event in setup.engine.drain_events()] == ["Glove found."]
    setup.close()


def test_without_room_for_images_the_rest_is_shown(connect, monkeypatch):
    def full(_size):
        raise NoSharedMemory(notice("system.shared_memory_full", needed_mb=5.5))

    monkeypatch.setattr("app.engines.apart.pixels.new_memory", full)
    engine = Subscribed()
    setup = connect(scripted_setup(engine))
    eventually(lambda: setup.tracked.calibration() is not None)
    assert setup.tracked.latest_frame() is None
    assert len(setup.tracked.recent_imu()) == len(engine.recent_imu())
    setup.close()


def test_colours_of_the_user_are_not_replaced_by_older_ones(connect):
    """Until the engine has taken the user's colours, it reports others that it has adapted."""
    mine, older, newer = (replace(models()[2], name=name) for name in ("mine", "older", "newer"))
    engine, asked, allowed = Subscribed(), threading.Event(), threading.Event()

    def set_profile(profile):
        engine.followed = older
        asked.set()
        assert allowed.wait(60.0)
        Subscribed.set_profile(engine, profile)

    engine.set_profile = set_profile
    setup = connect(scripted_setup(engine))
    setup.engine.set_profile(mine)
    assert asked.wait(60.0)
    seen = engine.looks
    eventually(lambda: engine.looks > seen + 3)
    assert setup.engine.profile == mine
    allowed.set()
    eventually(lambda: engine.profiles == [mine])
    engine.followed = newer
    eventually(lambda: setup.engine.profile == newer)
    setup.close()


def test_errors_are_those_of_the_engine(connect, caplog):
    engine = Subscribed()
    engine.set_engine = refuse
    setup = connect(scripted_setup(engine))
    with pytest.raises(ConfigError) as caught:
        setup.engine.set_engine("nonsense")
    assert caught.value.notice.code == "engine.no_wearer"
    with caplog.at_level(logging.CRITICAL), pytest.raises(Exception, match="division by zero"):
        setup.engine.set_engine("chain")
    engine.failure = failure("thread.failed", thread="engine", type="X", why="y")
    eventually(lambda: setup.live.engine.failure is not None)
    assert setup.live.engine.failure.code == "thread.failed"
    setup.close()


def refuse(name):
    if name == "chain":
        raise ZeroDivisionError("division by zero")  # not an error of ours
    raise ConfigError(notice("engine.no_wearer"))


def test_a_source_that_cannot_be_opened_says_why(connect):
    with pytest.raises(DeviceError) as caught:
        connect(DeviceError(notice("window.no_rig")))
    assert caught.value.notice.code == "window.no_rig"


def test_a_device_that_hangs_does_not_hang_the_window(connect):
    engine, released = Subscribed(), threading.Event()
    engine.stop = lambda timeout=None: released.wait(120.0)
    setup = connect(scripted_setup(engine))
    begun = time.monotonic()
    setup.engine.stop(0.0)
    assert time.monotonic() - begun < 60.0  # it hangs for 120 s
    assert [e.notice.code for e in setup.engine.drain_events() if e.kind == "error"] == [
        "engine.process_silent"
    ]
    released.set()
    setup.close()


def test_estimates_arrive_at_once_for_those_who_follow(connect):
    engine = Subscribed()
    setup = connect(scripted_setup(engine))
    seen, arrived = [], []
    setup.live.hand.follow(lambda estimate, t: arrived.append(t))
    setup.live.hand.subscribe(seen.append)
    first = engine.latest_estimate()
    engine.publish(first, 1.5)
    later = replace(first, t=first.t + 0.01, tracking=Tracking.SEARCHING)
    engine.publish(later)  # without a packet
    eventually(lambda: len(seen) == 2)
    assert arrived == [1.5] and [e.t for e in seen] == [first.t, later.t]
    np.testing.assert_array_equal(seen[0].keypoints, first.keypoints)
    assert setup.tracked.latest_estimate().t == later.t
    setup.close()


def test_a_window_that_hangs_does_not_delay_the_engine(connect):
    """The window stops reading: the engine's thread continues, and the newest estimates arrive."""
    engine, hangs, goes_on = Subscribed(), threading.Event(), threading.Event()
    setup = connect(scripted_setup(engine))
    seen = []

    def hang(estimate):
        seen.append(estimate.t)
        hangs.set()
        assert goes_on.wait(60.0)

    setup.live.hand.subscribe(hang)
    first = engine.latest_estimate()
    engine.publish(first)
    assert hangs.wait(60.0)
    times = [first.t + 0.01 * k for k in range(1, 1001)]  # 5 MB, much more than a pipe takes
    for t in times:
        engine.publish(replace(first, t=t))
    assert len(seen) == 1
    goes_on.set()
    engine.publish(replace(first, t=times[-1] + 0.01))
    eventually(lambda: seen[-1] >= times[-50])
    assert len(seen) < 900 and seen == sorted(seen)
    setup.close()


def test_a_fault_in_what_follows_the_hand_stops_tracking_visibly(connect):
    engine = Subscribed()
    setup = connect(scripted_setup(engine))

    def follower(_estimate, _t):
        raise ValueError("a robot")

    setup.live.hand.follow(follower)
    engine.publish(engine.latest_estimate(), 1.0)
    eventually(lambda: setup.live.engine.failure is not None)
    assert setup.live.engine.failure.code == "thread.failed"
    assert setup.live.engine.failure.values["why"] == "a robot"
    setup.engine.stop()  # is answered
    assert engine.stopped
    setup.close()


def test_a_fault_of_a_device_that_is_asked_stops_tracking_visibly(connect):
    engine = Subscribed()
    setup = connect(scripted_setup(engine))
    engine.recent_imu = lambda: [][1]
    eventually(lambda: setup.live.engine.failure is not None)
    assert setup.live.engine.failure.values["type"] == "IndexError"
    setup.close()


def test_a_recording_reports_its_state(connect, tmp_path):
    made = []
    engine = Subscribed()
    setup = connect(scripted_setup(engine, made))
    file = setup.live.make_recorder(RecordingRequest(tmp_path / "a.mcap", "", ""))
    setup.live.engine.set_recorder(file)
    assert engine.recorder is not None
    setup.engine.note("here", 2.0, {})
    eventually(lambda: file.written == 1)
    file.paused = True
    eventually(lambda: engine.recorder.paused)
    setup.live.engine.set_recorder(None)
    eventually(lambda: file.closed)
    assert [m.text for m in made[0].messages] == ["here"] and not file.broken
    setup.close()


def test_an_end_of_the_process_is_a_failure_and_ends_the_file(connect, tmp_path):
    engine = Subscribed()
    setup = connect(scripted_setup(engine))
    file = setup.live.make_recorder(RecordingRequest(tmp_path / "a.mcap", "", ""))
    setup.engine._process.kill()
    eventually(lambda: setup.live.engine.failure is not None)
    assert setup.live.engine.failure.code == "engine.process_ended"
    eventually(lambda: file.closed)
    assert file.broken
    setup.live.engine.set_recorder(None)  # raises nothing
    setup.live.hand.record(Event(0.0, "note", "too late"))
    setup.engine.stop()
