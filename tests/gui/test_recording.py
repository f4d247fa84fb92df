"""Record, pause, note, stop; and the files left by a closing window."""

import dataclasses
import threading
from datetime import datetime

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QInputDialog

from app.engines.protocols import RecordingRequest
from app.engines.recording import Recording
from app.storage.settings import SettingsStore
from app.viewmodels.recording import (
    LOW_BYTES,
    STOP_BYTES,
    RateMeter,
    RecordingPlan,
    disk,
    duration_text,
    losses_text,
    recording_path,
    size_text,
)
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.notices import shows
from tracker.base.clock import monotonic
from tracker.base.errors import FileError
from tracker.messages import Event
from tracker.session.notes import latest_versions


@pytest.fixture
def recorders():
    return []


@pytest.fixture
def recording(window, engine, recorders, qtbot):
    window.host.adopt(scripted_setup(engine, recorders))
    window.recording.participant.setText("P 01/a")
    window.commands.actions["record"].trigger()
    return window


def test_record_command_creates_a_named_file_and_a_second_press_ends_it(recording, recorders):
    assert recording.host.recording.request is not None
    assert recorders[0].path.name.startswith("P-01-a_")
    assert recording.recording.record_button.text() == "Stop"
    recording.commands.actions["record"].trigger()
    assert recording.host.recording.request is None
    assert recorders[0].closed
    assert recording.recording.record_button.text() == "Record"


def test_a_note_is_written_to_the_file(recording, recorders, qtbot):
    QTest.keyClicks(recording.recording.note_text, "gripped the cup\r")
    assert [m.text for m in recorders[0].messages if isinstance(m, Event)] == ["gripped the cup"]
    qtbot.waitUntil(lambda: recording.log.model.entries("note", "gripped") != [])


def test_the_panel_shows_written_and_lost_messages(recording, engine, qtbot):
    recording.run_command("show_recording")
    for _ in range(7):
        engine.recorder.write(engine.latest_estimate())
    shown = recording.recording.messages_label
    qtbot.waitUntil(lambda: shown.text().startswith("7  ("))
    assert recording.recording.losses_label.text() == "0 packets, 0 images not recorded"


def test_closing_the_window_while_recording_closes_the_file(recording, engine, recorders):
    recording.close()
    assert recorders[0].closed
    assert engine.stopped == 1


def test_a_recording_on_a_full_disk_ends_and_the_next_one_may_begin(recording, engine, recorders):
    def full(*_message, **_how):
        raise FileError("The disk is full.")

    recorders[0].write = full
    with pytest.raises(FileError):
        engine.recorder.write(engine.latest_estimate())
    recording.host.snapshot()
    assert recording.host.recording.request is None and recorders[0].closed
    assert recording.recording.record_button.text() == "Record"
    recording.recording.task.setText("again")
    recording.commands.actions["record"].trigger()
    assert recording.host.recording.request is not None and len(recorders) == 2


def test_pause_suspends_streams_and_keeps_notes(engine, tmp_path, recorders):
    setup = scripted_setup(engine, recorders)
    recorder = setup.live.make_recorder(RecordingRequest(tmp_path / "a.mcap", "", ""))
    recorder.write(engine.latest_estimate())
    recorder.paused = True
    recorder.write(engine.latest_estimate())
    recorder.write(Event(0.0, "note", "while paused"))
    recorder.paused = False
    recorder.write(engine.latest_estimate())
    kinds = [type(m).__name__ for m in recorders[0].messages]
    assert kinds == ["Estimate", "Event", "Estimate"]


def test_after_a_pause_the_file_contains_the_engines_state(recording, engine):
    recording.host.recording.pause(True)
    assert engine.kept_states == 0
    recording.host.recording.pause(False)
    assert engine.kept_states == 1


def test_the_time_recorded_counts_from_the_record_command_to_the_stop(engine, tmp_path, qapp):
    now = [100.0]
    recording = Recording(clock=lambda: now[0])
    recording.set_engine(scripted_setup(engine).live)
    assert recording.elapsed == 0.0
    assert recording.begin(RecordingRequest(tmp_path / "a.mcap", "", ""))
    now[0] += 7.5
    recording.pause(True)
    now[0] += 2.5
    assert recording.elapsed == 10.0
    recording.end()
    assert recording.elapsed == 0.0 and recording.request is None


def test_an_engine_stops_while_the_disk_is_behind_and_the_file_is_reported_when_complete(
    recording, engine, recorders, monkeypatch, tmp_path
):
    host, finished, failures = recording.host, [], []
    host.recording.finished.connect(finished.append)
    host.recording.failed.connect(failures.append)
    behind = engine.recorder
    monkeypatch.setattr(engine, "set_recorder", lambda recorder: None)  # closing it takes long
    recorders[0].close = lambda: (_ for _ in ()).throw(FileError("The disk is full."))
    host.shut_down()
    assert host.setup is None and host.recording.closing and finished == []
    with pytest.raises(FileError):
        behind.close()  # in the disk's own thread
    assert host.snapshot() is None
    assert [path.name[:6] for path in finished] == ["P-01-a"] and not host.recording.closing
    assert failures == ["The recording could not be finished: The disk is full."]


def test_closing_the_window_waits_for_the_disk(recording, engine, recorders, monkeypatch):
    behind = engine.recorder
    monkeypatch.setattr(engine, "set_recorder", lambda recorder: None)
    disk_thread = threading.Timer(0.5, behind.close)
    disk_thread.start()
    recording.close()
    assert recorders[0].closed
    disk_thread.join()


def test_a_slow_disk_is_not_waited_for(engine, tmp_path, qapp, monkeypatch):
    recording, finished, failures = Recording(), [], []
    recording.finished.connect(finished.append)
    recording.failed.connect(failures.append)
    path = tmp_path / "a.mcap"
    recording.set_engine(scripted_setup(engine).live)
    assert recording.begin(RecordingRequest(path, "", ""))
    behind = engine.recorder
    monkeypatch.setattr(engine, "set_recorder", lambda recorder: None)
    recording.end()
    assert recording.request is None and recording.closing and finished == []
    assert not recording.begin(RecordingRequest(tmp_path / "b.mcap", "", ""))
    assert "a.mcap is still being written" in failures[0]
    behind.close()
    recording.poll()
    assert finished == [path] and not recording.closing
    assert recording.begin(RecordingRequest(tmp_path / "b.mcap", "", ""))


def test_typed_values_are_restored_at_the_next_start(store, tmp_path):
    plan = RecordingPlan(store)
    plan.participant, plan.task = " P01 ", "pinch"
    plan.set_folder(tmp_path / "new")
    request = plan.request()
    assert (request.participant, request.task) == ("P01", "pinch")
    assert request.path.parent == tmp_path / "new" and request.path.name.startswith("P01_pinch_")
    again = RecordingPlan(SettingsStore(store.path))
    assert (again.participant, again.task, again.folder) == ("P01", "pinch", tmp_path / "new")


def test_an_impossible_folder_is_reported_and_nothing_is_recorded(window, engine, tmp_path):
    window.host.adopt(scripted_setup(engine))
    blocker = tmp_path / "file"
    blocker.write_text("")
    window.recording.set_folder(blocker / "inside")
    window.recording.toggle()
    assert window.host.recording.request is None
    assert shows(window.banner.text(), "window.recording_folder")


def test_start_after_stop_builds_a_new_engine(window, qtbot):
    made = []

    def factory(progress):
        made.append(ScriptedEngine())
        return scripted_setup(made[-1])

    window.host.open("first", factory)
    qtbot.waitUntil(lambda: window.host.running)
    window.host.stop()
    window.host.start()
    qtbot.waitUntil(lambda: len(made) == 2 and window.host.running)
    assert made[0].stopped == 1 and made[1].started == 1


def test_names_never_equal_an_existing_file(tmp_path):
    now = datetime(2026, 3, 1, 12, 0, 0)
    first = recording_path(tmp_path, "P1", "", now)
    assert first.name == "P1_2026-03-01_12-00-00.mcap"
    first.write_text("")
    second = recording_path(tmp_path, "P1", "", now)
    second.write_text("")
    third = recording_path(tmp_path, "P1", "", now)
    assert len({first, second, third}) == 3


@pytest.mark.parametrize(
    ("free", "warns", "full"),
    [(LOW_BYTES + 1, False, False), (LOW_BYTES - 1, True, False), (STOP_BYTES - 1, True, True)],
)
def test_disk_warns_under_five_and_stops_under_one_gigabyte(free, warns, full):
    space = disk(free, 1e6)
    assert (bool(space.warning), space.full) == (warns, full)


def test_the_remaining_recording_time_is_shown():
    assert "1:06:40" in disk(STOP_BYTES + 4_000_000_000, 1e6).text


def test_figures_have_readable_units():
    assert duration_text(59.9) == "0:59"
    assert duration_text(3725) == "1:02:05"
    assert size_text(999) == "999 B"
    assert size_text(1_500_000) == "1.5 MB"


def test_losses_are_named_by_their_kind():
    values = {"imu_lost": 3.0, "pictures_thinned": 2.0}
    assert losses_text(values) == "3 packets, 2 images not recorded"
    assert "4 messages" in losses_text({**values, "imu_overflow": 4.0})


def test_rate_meter_measures_growth():
    meter = RateMeter()
    assert meter.add(0.0, 0) == 0.0
    assert meter.add(2.0, 3000) == pytest.approx(1500.0)


def notes_in(recorder):
    return [m for m in recorder.messages if isinstance(m, Event) and m.kind == "note"]


def test_a_note_has_the_time_of_its_key_press_not_of_its_last_word(recording, recorders):
    before = monotonic()
    recording.run_command("note")
    pressed = monotonic()
    QTest.qWait(150)
    dialog = recording.findChild(QInputDialog)
    dialog.setTextValue("let go")
    dialog.accept()
    recording.recording.note_text.setFocus()
    QTest.keyClick(recording.recording.note_text, "a")
    typed = monotonic()
    QTest.qWait(150)
    QTest.keyClicks(recording.recording.note_text, "nd again")
    QTest.keyClick(recording.recording.note_text, Qt.Key.Key_Return)
    first, second = notes_in(recorders[0])
    assert (first.text, second.text) == ("let go", "and again")
    assert before <= first.t <= pressed
    assert pressed < second.t <= typed


def test_notes_can_be_edited_and_deleted_until_the_recording_ends(recording, recorders):
    listed = recording.recording.notes
    for text in ("gripped", "let fall", "sneezed"):
        recording.host.notes.add(text)
    assert listed.rowCount() == 3 and not listed.isHidden()
    listed.item(1, 1).setText("dropped")
    listed.setCurrentCell(2, 1)
    QTest.keyClick(listed, Qt.Key.Key_Delete)
    assert [listed.item(i, 1).text() for i in range(listed.rowCount())] == ["gripped", "dropped"]
    events = notes_in(recorders[0])
    assert len(events) == 5  # a file is only appended to
    held = latest_versions(events)
    assert [e.text for e in held] == ["gripped", "dropped"]
    assert held[1].t == events[1].t
    recording.run_command("record")
    assert listed.rowCount() == 0


def test_a_deleted_note_is_restored_by_undo(recording, recorders):
    listed = recording.recording.notes
    for text in ("gripped", "sneezed"):
        recording.host.notes.add(text)
    listed.setCurrentCell(0, 1)
    QTest.keyClick(listed, Qt.Key.Key_Delete)
    assert recording.banner.text() == "The note “gripped” was deleted."
    undo = recording.banner.buttons[0]
    assert undo.text() == "Undo"
    undo.click()
    assert [listed.item(i, 1).text() for i in range(listed.rowCount())] == ["gripped", "sneezed"]
    events = notes_in(recorders[0])
    held = latest_versions(events)
    assert [(e.text, e.t) for e in held] == [(e.text, e.t) for e in events[:2]]
    listed.setCurrentCell(0, 1)
    QTest.keyClick(listed, Qt.Key.Key_Delete)
    recording.run_command("record")
    recording.banner._work[0]()  # its recording has ended
    assert [e.text for e in latest_versions(notes_in(recorders[0]))] == ["sneezed"]


NOW = datetime(2026, 3, 1, 12, 0, 5)


@pytest.mark.parametrize(
    ("template", "participant", "task", "name"),
    [
        ("{participant}_{task}_{n:03}", "P 01", "pinch", "P-01_pinch_001"),
        ("{participant}_{task}_{n:03}", "", "", "001"),
        ("{participant}_{task}_{date}_{time}", "P1", "", "P1_2026-03-01_12-00-05"),
        ("take{n}-{task}", "P1", "a/b", "take1-a-b"),
    ],
)
def test_recordings_are_named_by_a_template(tmp_path, template, participant, task, name):
    assert recording_path(tmp_path, participant, task, NOW, template).name == f"{name}.mcap"


def test_the_counter_continues_from_the_highest_existing_number(tmp_path):
    for taken in ("P1_001", "P1_009", "P2_044", "P1_009_2", "other"):
        (tmp_path / f"{taken}.mcap").write_text("")
    assert recording_path(tmp_path, "P1", "", NOW, "{participant}_{n:03}").name == "P1_010.mcap"
    assert recording_path(tmp_path, "P2", "", NOW, "{participant}_{n}").name == "P2_45.mcap"


def test_an_invalid_template_is_rejected_and_the_last_one_used(window, store):
    field = window.recording.name_template
    for wrong, word in (("{who}_{n}", "{who}"), ("{participant", "incomplete")):
        field.setText(wrong)
        field.editingFinished.emit()
        assert word in window.banner.text()
        assert field.text() == "{participant}_{task}_{date}_{time}"
    field.setText("{participant}-{n:02}")
    field.editingFinished.emit()
    window.recording.participant.setText("P3")
    assert window.plan.request().path.name == "P3-01.mcap"
    assert SettingsStore(store.path).value.recording_name == "{participant}-{n:02}"


def test_other_data_of_a_note_survive_an_edit(recording, recorders):
    recording.host.notes.add("go", 12.5, {"lsl": {"stamp": 3.25}})
    recording.host.notes.change(0, "go left")
    first, second = notes_in(recorders[0])
    assert first.t == second.t == 12.5 and second.text == "go left"
    assert first.data["lsl"] == second.data["lsl"] == {"stamp": 3.25}


def test_a_replay_offers_no_recording_and_no_countdown(window, engine, store):
    store.update(countdown=3)
    setup = scripted_setup(engine)
    window.host.adopt(dataclasses.replace(setup, live=None))
    assert window.host.running
    assert not window.recording.record_button.isEnabled()
    assert not window.recording.note_text.isEnabled()
    window.record_key.press()
    assert window.record_key.left == 0


@pytest.mark.long
@pytest.mark.styled
def test_messages_leave_the_record_button_visible(live, qtbot):
    live.show_panel("recording")
    live.messages.show_message("The name holds a word that is none.")
    button = live.recording.record_button

    def is_free() -> bool:
        place = QRect(button.mapTo(live, QPoint(0, 0)), button.size())
        return not place.intersects(live.messages.geometry())

    qtbot.waitUntil(is_free)
    assert not button.visibleRegion().isEmpty()
