"""A recording begun after watching for a while: its length, rates and losses are its own."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QInputDialog

from app.engines.protocols import RecordingRequest
from app.engines.recording import PausableRecorder, recorder_maker
from app.engines.replay.engine import open_replay
from app.viewmodels.library import quality_text
from app.viewmodels.recording import duration_text
from app.viewmodels.recording_report import (
    HandNow,
    HandReport,
    MissingWatch,
    RecordingReport,
    missing_now,
    missing_text,
    rename,
    report_text,
)
from app.viewmodels.states import BAD, GOOD
from app.window.recordings import check_job
from resources import folder
from tests.gui.gui_fakes import (
    ScriptedEngine,
    frame_and_blobs,
    models,
    scripted_setup,
    simulation,
    with_camera,
    with_live,
)
from tests.notices import raises
from tracker.base.clock import ClockAnchor, seconds
from tracker.base.errors import FileError
from tracker.engine.hands import Hands, Sided
from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.live.inbox import DetectedFrame
from tracker.live.runner import LiveTracker
from tracker.messages import BlobFrame, Estimate, Status, StereoFrame, Tracking
from tracker.session.description import SessionInfo, of_hands
from tracker.session.overview import Quality, quality, session_summary
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.vision.detector import Detector

ENGINE_START = ClockAnchor(1_760_000_000_000_000_000, 7_000_000_000)
WATCHED = 100.0  # s from the engine's start to Record
SEEN = 1.0  # s of them, the last, in which devices gave something
LENGTH = 1.2  # s, of the recording
LOST_BEFORE, LOST_IN_IT = 40, 3  # packets
LEFT = (("hands", "reference-left"), ("gloves", "vist-small-left"))


class Nothing:
    """A device without data: the test feeds messages."""

    def poll(self, timeout):
        return []

    def read(self, timeout):
        return None

    failure = None

    def drain_events(self):
        return []

    def close(self) -> None:
        pass


class Clock:
    def __init__(self) -> None:
        self.now = seconds(ENGINE_START.monotonic_ns)

    def __call__(self) -> float:
        return self.now


def session_info() -> SessionInfo:
    hand, glove, _ = models()
    return SessionInfo(
        hand=hand,
        glove=glove,
        hand_text=(folder("hands") / "reference-right.toml").read_text("utf-8"),
        glove_text=(folder("gloves") / "vist-small.toml").read_text("utf-8"),
        anchor=ENGINE_START,
        rig=simulation().rig,
    )


def on_the_clock(message):
    """The simulation's message as if its first second were the last one before Record."""
    by = seconds(ENGINE_START.monotonic_ns) + WATCHED - SEEN
    return replace(message, t=message.t + by, t_arrival=message.t_arrival + by)


def schedule():
    """Packets, and image pairs with their blobs, in the order of arrival; some packets are lost."""
    sim = simulation()
    lost = {*range(30, 30 + LOST_BEFORE), *range(140, 140 + LOST_IN_IT)}
    samples = [s for s in sim.imu_samples() if s.seq not in lost]
    pairs = [pair(*exposure) for exposure in sim.exposures()]
    found = sorted([*samples, *pairs], key=arrival)
    return [m for m in found if arrival(m) < SEEN + LENGTH]


def pair(index: int, t: float, t_arrival: float) -> DetectedFrame:
    """Images are rendered from just before the recording on."""
    if SEEN - 0.05 < t_arrival < SEEN + LENGTH:
        return DetectedFrame(*frame_and_blobs(index))
    blobs = simulation().scene.blobs(t, t_arrival, index)
    return DetectedFrame(StereoFrame(t, t_arrival, None, None), blobs)


def arrival(item) -> float:
    return item.frame.t_arrival if isinstance(item, DetectedFrame) else item.t_arrival


@pytest.fixture(scope="module")
def take(tmp_path_factory) -> Path:
    """A recording of `LENGTH` s, begun `WATCHED` s after the engine."""
    path = tmp_path_factory.mktemp("takes") / "take.mcap"
    hand, glove, profile = models()
    rig, clock = simulation().rig, Clock()
    tracker = LiveTracker(
        Hands({"right": lambda: Pipeline(hand, glove, rig)}),
        profile,
        lambda p: Detector(p, fx=rig.fx),
        {"right": Nothing()},
        Nothing(),
        clock=clock,
    )
    record = recorder_maker(tracker, session_info(), SessionRecorder, clock)
    recording = False
    for item in schedule():
        if arrival(item) >= SEEN and not recording:
            clock.now = seconds(ENGINE_START.monotonic_ns) + WATCHED
            tracker.set_recorder(record(RecordingRequest(path, "P01", "pinch")))
            recording = True
        clock.now = max(clock.now, arrival(item) + WATCHED - SEEN + 7.0)
        if isinstance(item, DetectedFrame):
            frame, blobs = on_the_clock(item.frame), on_the_clock(item.blobs)
            tracker._journal.record(frame)
            tracker._loop.feed(DetectedFrame(frame, blobs))
        else:
            tracker._loop.feed(Sided(on_the_clock(item), "right"))
    tracker.stop()
    return path


@pytest.mark.long
def test_a_take_is_as_long_as_it_was_recorded_for(take):
    found = session_summary(take)
    assert found["duration_s"] == pytest.approx(LENGTH, abs=0.1)
    imu = next(v for k, v in found["topics"].items() if "/imu/" in k)
    assert imu["rate_hz"] == pytest.approx(100.0, rel=0.08)  # a packet may fall at either end
    with SessionReader(take) as reader:
        first, _ = reader.source.contents.spans.bounds()
        begun = ENGINE_START.wall_ns + round(WATCHED * 1e9)
        assert first == begun == reader.anchor.wall_ns
        assert reader.span_ns[0] - first < 0.1e9
    assert is_ok(verify(take))


def test_losses_before_the_recording_are_not_charged_to_it(take):
    with SessionReader(take) as reader:
        counts = [m.values["imu_lost"] for m in reader.messages((Status,))]
        assert counts[0] == 0.0 and counts[-1] == LOST_IN_IT
        assert quality(reader).packets_lost == LOST_IN_IT


def test_the_share_that_was_tracked_is_that_of_the_time(take, tmp_path):
    """Lost for each third of three estimates' worth of time: no instants are looked at."""
    path, count = tmp_path / "lost.mcap", 0
    with SessionReader(take) as reader:
        with SessionRecorder(path, reader.info, RecorderParams(sync=False)) as recorder:
            for m in reader.messages():
                if isinstance(m, Estimate):
                    count += 1
                    if count % 30 < 10:
                        m = replace(m, tracking=Tracking.SEARCHING)
                recorder.write(m)
        instants = count
    with SessionReader(path) as reader:
        assert quality(reader).tracked == pytest.approx(2 / 3, abs=20 / instants)


def test_time_without_data_is_reported_next_to_lost_packets():
    hand = HandReport("right", tracked=0.8, glove_silent=5.04)
    report = RecordingReport(Path("a.mcap"), "", 20.0, 0, camera_silent=2.0, hands=(hand,))
    assert report_text(report) == (
        "a is complete: 0:20, no packets lost, no image for 2.0 s, "
        "nothing from the glove for 5.0 s, tracked 80 % of the time."
    )


def test_both_hands_are_reported():
    hands = (HandReport("left", 0.61, 8.0), HandReport("right", 0.97))
    report = RecordingReport(Path("a.mcap"), "", 20.0, 3, hands=hands)
    assert report_text(report) == (
        "a is complete: 0:20, 3 packets lost; "
        "left hand: nothing from the glove for 8.0 s, tracked 61 % of the time; "
        "right hand: tracked 97 % of the time."
    )


@pytest.fixture(scope="module")
def both_taken(tmp_path_factory) -> Path:
    """4 s of both hands: the left one is tracked for a quarter, its glove silent from half on."""
    path = tmp_path_factory.mktemp("both") / "both.mcap"
    one = session_info()
    texts = {kind: (folder(kind) / f"{name}.toml").read_text("utf-8") for kind, name in LEFT}
    hand, glove = library.load("vist-small-left", "reference-left")
    other = replace(
        one, hand=hand, glove=glove, hand_text=texts["hands"], glove_text=texts["gloves"]
    )
    info, start = of_hands([one, other]), seconds(ENGINE_START.monotonic_ns)
    sample = next(simulation().imu_samples())
    with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
        for k in range(401):
            t = start + 0.01 * k
            recorder.write(replace(sample, t=t, t_arrival=t, seq=k), side="right")
            if k < 200:
                recorder.write(replace(sample, t=t, t_arrival=t, seq=k), side="left")
            if k % 100 == 0:
                was = Tracking.TRACKING if k < 100 else Tracking.LOST
                lost = {"right": 3.0 * (k == 400), "left": float(k // 200)}
                recorder.write(Status(t, was, {"imu_lost": lost["left"]}), side="left")
                here = Status(t, Tracking.TRACKING, {"imu_lost": lost["right"]})
                recorder.write(here, side="right")
    return path


@pytest.mark.long
def test_a_recording_of_both_hands_reports_each_and_all_lost_packets(both_taken):
    report = check_job(both_taken)(lambda *_: None)
    left, right = report.hands
    assert (left.side, right.side) == ("left", "right")
    assert left.tracked == pytest.approx(0.25, abs=0.01)
    assert right.tracked == pytest.approx(1.0, abs=0.01)
    assert left.glove_silent == pytest.approx(2.0, abs=0.05) and right.glove_silent == 0.0
    assert report.packets_lost == 3 + 2
    with SessionReader(both_taken) as reader:
        text, look = quality_text(quality(reader))
    assert text == "tracked left 25, right 100 %, 5 packets lost" and look == BAD


@pytest.fixture(scope="module")
def old_take(take, tmp_path_factory) -> Path:
    """The same as older versions recorded it: described at the engine's start, losses its own."""
    path = tmp_path_factory.mktemp("old") / "old.mcap"
    with SessionReader(take) as reader:
        info = replace(reader.info, anchor=ENGINE_START)
        with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
            for m in reader.messages():
                if isinstance(m, Status):
                    lost = m.values["imu_lost"] + LOST_BEFORE
                    m = replace(m, values={**m.values, "imu_lost": lost})
                recorder.write(m)
    return path


def test_an_old_recording_with_a_gap_begins_at_its_first_sensor_message(old_take, take):
    with SessionReader(old_take) as old, SessionReader(take) as new:
        assert old.span_ns[0] - old.source.contents.spans.bounds()[0] > 0.99 * WATCHED * 1e9
        assert old.span_ns[0] == new.span_ns[0]
        assert quality(old) == quality(new)
    assert session_summary(old_take)["duration_s"] == pytest.approx(LENGTH, abs=0.1)


@pytest.mark.parametrize("which", ["take", "old_take"])
def test_the_first_thing_a_replay_shows_is_an_image(which, request, qtbot):
    setup = open_replay(request.getfixturevalue(which), lambda *_: None)
    setup.player.play(False)
    setup.engine.start()
    try:
        qtbot.waitUntil(lambda: setup.tracked.latest_frame() is not None)
        image, blobs, _ = setup.tracked.latest_frame()
        assert image.left is not None and image.right is not None
        assert image.t == blobs.t
        assert setup.player.duration == pytest.approx(LENGTH, abs=0.1)
        assert setup.player.position < 0.1
    finally:
        setup.close()


def test_opening_anything_leaves_the_panels_and_raises_what_a_replay_needs(window, take, qtbot):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    for name, shown in (("sensors", False), ("colours", False), ("calibration", True)):
        window.docks[name].setVisible(shown)
    window.show_panel("log")
    window.host.adopt(scripted_setup(ScriptedEngine()))
    assert not window.docks["sensors"].isVisible() and not window.docks["colours"].isVisible()
    bar = window.library.transport
    qtbot.waitUntil(lambda: not window.log.visibleRegion().isEmpty())
    assert bar.visibleRegion().isEmpty()
    window.host.adopt(open_replay(take, lambda *_: None))
    qtbot.waitUntil(lambda: bar.visibleRegion().boundingRect() == bar.rect())
    assert not window.docks["sensors"].isVisible() and not window.docks["colours"].isVisible()


def test_a_replay_opened_first_has_its_transport_in_view_on_a_small_screen(window, take, qtbot):
    bar = window.library.transport
    window.host.adopt(open_replay(take, lambda *_: None))
    qtbot.waitUntil(lambda: bar.visibleRegion().boundingRect() == bar.rect())
    qtbot.waitUntil(lambda: window.host.snapshot().frame is not None)


class Copying:
    """A recorder whose file is that of ``take``, once it is closed."""

    def __init__(self, path: Path, take: Path) -> None:
        self._path, self._take = path, take

    def write(self, message, overloaded: bool = False, side: str = "") -> bool:
        return True

    def flush(self) -> None:
        pass

    def close(self) -> None:
        shutil.copy(self._take, self._path)


@pytest.fixture
def recorded(window, take, qtbot):
    """The window after a recording, which has been checked."""
    setup = with_live(
        scripted_setup(ScriptedEngine()),
        make_recorder=lambda r: PausableRecorder(Copying(r.path, take)),
    )
    window.host.adopt(setup)
    window.recording.participant.setText("P07")
    window.run_command("record")
    window.run_command("record")
    qtbot.waitUntil(lambda: "is complete" in window.banner.text())
    return window


def button(window, word: str):
    return next(b for b in window.banner.buttons if b.text().startswith(word))


def test_after_stop_one_line_summarises_the_recording(recorded, take):
    with SessionReader(take) as reader:
        tracked = quality(reader).tracked
    text = recorded.banner.text()
    assert text.startswith("P07_")
    assert (
        f"0:0{int(LENGTH)}, {LOST_IN_IT} packets lost, tracked {100 * tracked:.0f} % of the time."
        in text
    )


def test_a_full_disk_is_named_beside_how_the_recording_is(recorded, qtbot, monkeypatch):
    recorded.run_command("record")
    monkeypatch.setattr("app.panels.recording.free_bytes", lambda _folder: 10_000_000)
    recorded.recording.refresh(None)
    assert recorded.host.recording.request is None
    qtbot.waitUntil(lambda: "disk is nearly full" in recorded.banner.text())
    assert "is complete" in recorded.banner.text()


@pytest.mark.long
def test_it_is_renamed_and_shown_from_there(recorded, qtbot):
    [path] = recorded.plan.folder.glob("*.mcap")
    button(recorded, "Rename").click()
    recorded.findChild(QInputDialog).reject()
    assert recorded.messages.isVisible(), "who thinks better of it may still show it"
    qtbot.waitUntil(lambda: recorded.findChild(QInputDialog) is None)
    button(recorded, "Rename").click()
    dialog = recorded.findChild(QInputDialog)
    dialog.setTextValue("pinch of salt")
    dialog.accept()
    [path] = recorded.plan.folder.glob("*.mcap")
    assert path.name == "pinch-of-salt.mcap"
    assert recorded.banner.text().startswith("pinch-of-salt is complete")
    assert recorded.store.value.recent == [str(path)]
    button(recorded, "Show").click()
    qtbot.waitUntil(lambda: recorded.host.setup.player is not None)
    assert recorded.host.setup.player.path == path
    assert not recorded.messages.isVisible()


def test_a_name_that_is_taken_leaves_both_files(tmp_path):
    first, second = tmp_path / "a.mcap", tmp_path / "b.mcap"
    first.write_text("1")
    second.write_text("2")
    with raises(FileError, "rename.exists"):
        rename(first, "b")
    with raises(FileError, "rename.no_name"):
        rename(first, " / ")
    assert (first.read_text(), second.read_text()) == ("1", "2")
    assert rename(first, "c.mcap").read_text() == "1"


@pytest.mark.long
def test_a_file_cut_off_is_not_called_whole(take, tmp_path):
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(take.read_bytes()[: take.stat().st_size * 2 // 3])
    report = check_job(cut)(lambda *_: None)
    assert report.problem and 0 < report.duration < LENGTH
    length = duration_text(report.duration)
    assert report_text(report) == (
        f"cut was interrupted after {length}. Its contents can be recovered."
    )


@pytest.mark.long
def test_a_recording_that_its_disk_cut_off_is_recovered_from_its_message(
    recorded, take, tmp_path, qtbot
):
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(take.read_bytes()[: take.stat().st_size * 2 // 3])
    recorded.host.recording.finished.emit(cut)
    qtbot.waitUntil(lambda: "cut was interrupted" in recorded.banner.text())
    button(recorded, "Recover").click()
    whole = tmp_path / "cut_recovered.mcap"
    qtbot.waitUntil(lambda: whole.name in recorded.banner.text())
    assert is_ok(verify(whole))


@pytest.mark.long
def test_missing_data_are_reported_during_a_recording_which_continues(qtbot, window, engine):
    """Not while the devices have only just been opened: then nothing has come yet."""
    camera = SimpleNamespace(fps=60.0)
    window.host.adopt(with_camera(scripted_setup(engine), device=camera))
    silent, samples = 2, engine.recent_imu()
    name = models()[1].imu_names[silent].replace("_", " ")
    valid = samples[0].valid.copy()
    valid[silent] = False
    engine.recent_imu = lambda: [replace(s, valid=valid.copy()) for s in samples]
    window.run_command("record")
    assert window.host.recording.request is not None
    assert window.banner.text() == ""
    qtbot.waitUntil(lambda: "30 of 60 images per second" in window.banner.text())
    assert f"no data from the IMU {name}" in window.banner.text()
    engine.recent_imu = lambda: samples  # one of the two has come
    qtbot.waitUntil(lambda: "IMU" not in window.banner.text())
    assert "of 60 images" in window.banner.text()
    camera.fps = 30.0
    qtbot.waitUntil(lambda: not window.messages.isVisibleTo(window))
    window.run_command("record")


def replace_status(hand: HandNow, values: dict[str, float]) -> HandNow:
    return hand._replace(status=replace(hand.status, values=values))


def test_only_missing_data_are_reported():
    names = models()[1].imu_names
    samples = list(simulation().imu_samples())[:100]
    now = samples[-1].t_arrival
    fine = Status(now, Tracking.TRACKING, {"frame_rate_hz": 29.0})
    right = HandNow("right", fine, samples, names)
    assert missing_now([right], 30.0) == {} and missing_text({}) == ""
    assert missing_now([right], 0.0) == {}
    blind = replace_status(right, {})
    assert list(missing_now([blind], 30.0)) == ["camera"]
    assert missing_now([blind], None) == {}, "there is no camera to miss"
    assert missing_now([HandNow("right", fine, [], names, has_glove=False)], 30.0) == {}
    gone = Status(now + 5.0, Tracking.TRACKING, {})
    text = missing_text(missing_now([HandNow("right", gone, samples, names)], 30.0))
    assert text == (
        "This recording is incomplete: no images from the camera; no data from the glove."
    )
    text = missing_text(missing_now([right, HandNow("left", fine, [], names)], 30.0))
    assert text == "This recording is incomplete: left hand: no data from the glove."


def test_what_is_missing_only_briefly_is_not_reported():
    watch, gone = MissingWatch(), {"glove": "no data from the glove"}
    assert watch.look({}) == {}
    assert [watch.look(now) for now in (gone, {}, gone)] == [{}, {}, {}]
    assert watch.look(gone) == gone
    assert [watch.look(now) for now in ({}, {}, gone, {}, {})] == [gone] * 5
    assert watch.look({}) == {}
    assert MissingWatch().look(gone) == gone, "from the start it is reported at once"


@pytest.mark.long
def test_a_glove_unplugged_during_a_recording_is_named_until_it_is_back(qtbot, window, engine):
    """Also after another message, and not again once the user has dismissed it."""
    window.host.adopt(scripted_setup(engine))
    samples = engine.recent_imu()
    qtbot.wait(2100)  # the devices have been open for a while
    window.run_command("record")
    qtbot.wait(1200)
    assert not window.messages.isVisible()
    engine.recent_imu = list
    text = "This recording is incomplete: no data from the glove."
    qtbot.waitUntil(lambda: window.banner.text() == text)
    engine.recent_imu = lambda: samples
    qtbot.waitUntil(lambda: not window.messages.isVisible())
    engine.recent_imu = list
    qtbot.waitUntil(lambda: window.messages.isVisible())
    window.messages.show_message("Something else.", good=True)
    window.messages.hide()
    qtbot.waitUntil(lambda: window.banner.text() == text)
    window.banner.dismissed.emit()
    qtbot.wait(1200)
    assert not window.messages.isVisible()
    window.run_command("record")


def test_good_news_disappears_and_problems_stay(qtbot, window, monkeypatch):
    monkeypatch.setattr("app.window.message_bar.READ_MS", 100)
    monkeypatch.setattr("app.window.message_bar.CHOOSE_MS", 100)
    window.messages.show_message("Saved.", good=True)
    assert window.messages.isVisible()
    qtbot.waitUntil(lambda: not window.messages.isVisible())
    window.messages.show_message(
        "P01 is complete.", ("Show it", lambda: None), good=True, stays=True
    )
    qtbot.waitUntil(lambda: not window.messages.isVisible())
    window.messages.show_message("Saved.", good=True)
    window.messages.show_message("The disk is full.")
    qtbot.wait(300)
    assert window.banner.text() == "The disk is full." and window.messages.isVisible()
    window.messages.show_message("Plugged in now: the glove.", good=True, about="devices")
    qtbot.wait(300)
    assert window.messages.isVisible(), "it ends when it is no longer true"


def test_images_that_were_never_searched_are_shown_all_the_same(take, tmp_path, qtbot):
    path = tmp_path / "unsearched.mcap"
    unsynced = RecorderParams(sync=False)
    with (
        SessionReader(take) as reader,
        SessionRecorder(path, reader.info, unsynced) as recorder,
    ):
        for m in reader.messages():
            if not isinstance(m, BlobFrame):
                recorder.write(m)
    setup = open_replay(path, lambda *_: None)
    setup.engine.start()
    try:
        qtbot.waitUntil(lambda: setup.tracked.latest_frame() is not None)
        image, blobs, _ = setup.tracked.latest_frame()
        assert image.left is not None and blobs.left is None
    finally:
        setup.close()


def dropped(window, *names: str) -> bool:
    """Whether the window takes these files, dragged onto it and let go."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(name) for name in names])
    left, keys = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    copy = Qt.DropAction.CopyAction
    enter = QDragEnterEvent(QPoint(50, 50), copy, data, left, keys)
    QApplication.sendEvent(window, enter)
    drop = QDropEvent(QPointF(50, 50), copy, data, left, keys)
    QApplication.sendEvent(window, drop)
    return enter.isAccepted() and drop.isAccepted()


def test_a_session_dragged_onto_the_window_is_opened(window, take, qtbot):
    assert not dropped(window, "holiday.jpg")
    assert window.host.setup is None and not window.host.opening
    assert dropped(window, str(take))
    qtbot.waitUntil(lambda: window.host.running)
    assert window.host.setup.player.path == take


def test_a_take_of_a_glove_alone_is_not_called_untracked(tmp_path):
    hands = (HandReport("right", 0.0),)
    both = RecordingReport(tmp_path / "a.mcap", "", 6.0, 0, by_imus=True, hands=hands)
    assert report_text(both) == "a is complete: 0:06, no packets lost, IMUs only."
    assert quality_text(Quality(0.0, 0, by_imus=True)) == (
        "IMUs only, no packets lost",
        GOOD,
    )
