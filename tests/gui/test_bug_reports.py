"""Crashes, bug reports, the About box, failing panels and drivers."""

import json
import subprocess
import sys
import threading
import zipfile
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QDialogButtonBox, QPlainTextEdit, QPushButton

from app.platform.bug_report import Choice, Material, contents, cut_tail, write_bundle
from app.platform.crash import CrashWatch
from app.platform.licences import parts
from app.storage.settings import AppSettings
from app.window.bug_reports import BugReportDialog
from app.window.dialogs import AboutDialog
from app.window.main_window import MainWindow
from tracker import __version__
from tracker.base.notices import failure
from tracker.messages import Event, ImuSample, StereoFrame
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder

pytestmark = pytest.mark.long

CRASHING = """
import faulthandler, sys
from pathlib import Path
from PySide6.QtCore import QCoreApplication
from app.platform.crash import CrashWatch
app = QCoreApplication([])
watch = CrashWatch(Path(sys.argv[1]))
faulthandler._sigsegv()
"""


@pytest.fixture
def crashed(tmp_path):
    """The log folder of a run that ended with a segmentation fault."""
    folder = tmp_path / "logs"
    run = subprocess.run([sys.executable, "-c", CRASHING, str(folder)], check=False)
    assert run.returncode != 0
    return folder


@pytest.fixture
def watch(tmp_path):
    watch = CrashWatch(tmp_path / "logs")
    yield watch
    watch.end()


def press(qtbot, dialog, role=QDialogButtonBox.ButtonRole.AcceptRole) -> None:
    box = dialog.findChild(QDialogButtonBox)
    [button] = [b for b in box.buttons() if box.buttonRole(b) == role]
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


# --- crashes


def test_the_next_start_after_a_hard_crash_offers_a_bug_report(crashed, store, qtbot, no_leaks):
    watch = CrashWatch(crashed)
    window = MainWindow(store, watch)
    qtbot.addWidget(window)
    window.show()
    try:
        assert "Segmentation fault" in watch.found.read_text()
        assert __version__ in watch.found.read_text()
        assert "ended unexpectedly" in window.banner.text()
        assert window.banner.isVisible() and window.banner.buttons[0].isVisible()
        qtbot.mouseClick(window.banner.buttons[0], Qt.MouseButton.LeftButton)
        assert window.findChild(BugReportDialog) is not None
        assert not window.banner.isVisible()
    finally:
        window.close()
        watch.end()
    again = CrashWatch(crashed)
    assert again.found is None  # reported once
    again.end()


def test_a_normal_exit_leaves_nothing(tmp_path):
    watch = CrashWatch(tmp_path)
    assert [p.name.split("-")[0] for p in tmp_path.iterdir()] == ["running"]
    watch.end()
    assert list(tmp_path.iterdir()) == []


def test_a_running_process_is_not_a_crash(tmp_path):
    first = CrashWatch(tmp_path)
    try:
        assert CrashWatch._rename_old_logs(first) is None
    finally:
        first.end()


def test_an_unhandled_exception_is_logged_once_and_offered(watch, store, qtbot, no_leaks, capsys):
    window = MainWindow(store, watch)
    qtbot.addWidget(window)
    window.show()
    for _ in range(3):  # like a timer
        try:
            raise ValueError("three fingers are too few")
        except ValueError as error:
            sys.excepthook(type(error), error, error.__traceback__)
    assert "three fingers are too few" in window.banner.text()
    assert window.banner.buttons[0].isVisible()
    text = watch._path.read_text()
    assert text.count("ValueError: three fingers are too few") == 1
    window.close()
    watch.end()
    assert [p.name[:6] for p in watch.folder.iterdir()] == ["crash-"]


def test_an_exception_in_a_thread_is_reported(watch, qtbot):
    notified = []
    watch.happened.connect(notified.append)

    def work() -> None:
        raise ZeroDivisionError("in a thread")

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    qtbot.waitUntil(lambda: notified != [])
    assert "in a thread" in notified[0]


def test_a_failing_panel_is_disabled_and_the_others_continue(live, qtbot, monkeypatch):
    calls = []

    def broken(view) -> None:
        calls.append(view)
        raise RuntimeError("no such curve")

    monkeypatch.setattr(live.hand, "refresh", broken)
    qtbot.waitUntil(lambda: "no such curve" in live.banner.text())
    cameras = []
    monkeypatch.setattr(live.cameras, "refresh", cameras.append)
    qtbot.waitUntil(lambda: len(cameras) > 5)
    assert len(calls) <= 2


def test_a_dead_worker_is_reported_and_the_window_continues(live, engine, qtbot):
    failed = failure("thread.failed", thread="vision", type="ValueError", why="empty")
    engine.events.append(Event.of(1.0, "error", failed))
    qtbot.waitUntil(lambda: "vision thread failed" in live.banner.text())
    assert live.host.running


# --- bug reports


@pytest.fixture(scope="session")
def session_file(tmp_path_factory):
    """12 s with two images, a participant and a note."""
    folder = tmp_path_factory.mktemp("bug")
    plain = folder / "plain.mcap"
    options = SimulateOptions(seed=1, duration=12.0, fps=5, images=False)
    simulate(plain, options)
    path = folder / "Mustermann_pinch.mcap"
    with SessionReader(plain) as reader:
        info = replace(reader.info, rig=reader.rig(), participant="Mustermann", notes="left-handed")
        with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
            for message in reader.messages():
                recorder.write(message)
            recorder.write(Event(message.t, "note", "Mustermann sneezed"))
    return path


def test_the_excerpt_is_the_last_seconds_without_names(session_file, tmp_path):
    cut_tail(session_file, tmp_path / "cut.mcap", 10.0, images=False, personal=False)
    with SessionReader(tmp_path / "cut.mcap") as cut, SessionReader(session_file) as whole:
        assert cut.duration == pytest.approx(10.0, abs=0.5)
        assert cut.span_ns[1] >= whole.span_ns[1] - 500_000_000
        kinds = {type(m) for m in cut.messages()}
        assert ImuSample in kinds and StereoFrame not in kinds
        assert (cut.info.participant, cut.info.notes) == ("", "")
    assert b"Mustermann" not in (tmp_path / "cut.mcap").read_bytes()
    cut_tail(session_file, tmp_path / "own.mcap", 10.0, images=False, personal=True)
    with SessionReader(tmp_path / "own.mcap") as own:
        assert own.info.participant == "Mustermann"


@pytest.mark.parametrize("personal", [False, True])
def test_a_bundle_contains_names_only_if_selected(session_file, tmp_path, personal):
    logs = tmp_path / "logs"
    logs.mkdir()
    (logs / "glovetrack.log").write_text("recorded Mustermann_pinch.mcap\n")
    settings = AppSettings(
        participant="Mustermann", task="pinch", sessions_folder="/data/Mustermann"
    )
    material = Material(
        log="Recording Mustermann_pinch.mcap",
        settings=settings,
        status={"values": {"imu_rate_hz": 100.0}},
        machine={"glovetrack": __version__},
        log_folder=logs,
        session_file=session_file,
        names=("Mustermann", "pinch"),
    )
    path = tmp_path / "bug.zip"
    assert write_bundle(path, material, Choice(screenshot=False, personal=personal)) == []
    with zipfile.ZipFile(path) as bundle:
        names = set(bundle.namelist())
        everything = b"".join(bundle.read(n) for n in names if n != "session.mcap")
        readme = bundle.read("README.txt").decode()
    assert names == {
        "README.txt",
        "log.txt",
        "settings.json",
        "status.json",
        "versions.txt",
        "logs/glovetrack.log",
        "session.mcap",
    }
    assert (b"Mustermann" in everything) is personal
    assert all(line in readme for line in contents(Choice(screenshot=False, personal=personal)))


@pytest.mark.styled
def test_a_report_is_saved_by_clicks_and_confirmed(live, qtbot, tmp_path):
    live.recording.participant.setText("Mustermann")
    live.store.update(participant="Mustermann")
    live.run_command("show_log")
    [button] = [b for b in live.log.findChildren(QPushButton) if "Bug" in b.text()]
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    dialog = live.findChild(BugReportDialog)
    assert "without participant" in dialog.inside.text()
    dialog.boxes["personal"].setChecked(True)
    assert "without participant" not in dialog.inside.text()
    dialog.boxes["personal"].setChecked(False)
    path = tmp_path / "bug.zip"
    dialog.path.setText(str(path))
    press(qtbot, dialog)
    qtbot.waitUntil(lambda: "bug.zip" in live.banner.text())
    with zipfile.ZipFile(path) as bundle:
        names = bundle.namelist()
        status = json.loads(bundle.read("status.json"))
        image = QImage.fromData(bundle.read("window.png"))
        assert b"Mustermann" not in bundle.read("settings.json")
    assert status["values"]["imu_rate_hz"] == 100.0
    assert image.width() >= 1366
    assert "versions.txt" in names


def test_a_report_that_cannot_be_written_is_reported(live, qtbot, tmp_path):
    live.reports.save(tmp_path / "nowhere" / "bug.zip", Choice())
    qtbot.waitUntil(lambda: "nowhere" in live.banner.text())
    assert not (tmp_path / "nowhere").exists()


# --- the About box


def test_the_about_box_shows_version_and_licences(window, qtbot):
    window.run_command("about")
    box = window.findChild(AboutDialog)
    texts = [t.toPlainText() for t in box.findChildren(QPlainTextEdit)]
    labels = " ".join(label.text() for label in box.findChildren(type(window.banner._label)))
    assert __version__ in labels
    assert any("numpy" in t and "BSD" in t for t in texts)
    assert any("Apache License" in t for t in texts)
    box.close()


def test_every_part_has_a_licence_except_development_tools():
    found = {p.name.lower(): p for p in parts()}
    assert {"numpy", "mcap"} <= found.keys()
    assert "pytest" not in found and "glovetrack" not in found
    assert all(p.licence for p in found.values())


def test_a_file_opened_while_recording_needs_confirmation(live, qtbot, tmp_path):
    live.commands.actions["record"].trigger()
    live.sources.take_over(str(tmp_path / "other.mcap"))
    assert live.host.recording.request is not None
    assert "other.mcap cannot be opened" in live.banner.text()
    for key in ("demo", "hardware"):
        live.commands.actions[key].trigger()
        assert "cannot be opened during a recording" in live.banner.text()
    live.commands.actions["record"].trigger()
    live.sources.take_over("")
    assert live.host.setup is not None
