"""The library by clicks: replay, range, export queue, tracking again, comparison, recovery."""

import csv
import shutil
import threading
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QDialogButtonBox

from app.jobs.export import CANCELLED, DONE, FAILED, WAITING, ExportQueue, ExportRequest
from app.panels.library.comparing import CompareDialog, track_job
from app.panels.library.export_dialog import ExportDialog
from app.panels.library.track_dialog import TrackDialog
from app.platform.tasks import JobProgress, TaskOwner
from app.viewmodels.compare import Comparison, summary
from app.viewmodels.library import session_row
from tests.made_once import made_once
from tests.notices import shows
from tracker.messages import Estimate
from tracker.offline.options import USUAL, TrackOptions
from tracker.session.compare import compare
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder


@pytest.fixture(scope="session")
def recorded(shared_folder, simulated_sessions):
    """A session like one of the demo: sensors, `chain`'s estimates, the truth."""
    simulated, tracked = simulated_sessions.simulated(), simulated_sessions.tracked()

    def make(folder: Path) -> None:
        with SessionReader(tracked) as reader:
            info = replace(reader.info, rig=reader.rig(), participant="P01")
            params = RecorderParams(sync=False)
            with SessionRecorder(folder / "whole.mcap", info, params) as recorder:
                for message in reader.messages():
                    recorder.write(message)
                with SessionReader(simulated) as source:
                    for true in source.truth():
                        recorder.write_truth(true)

    return made_once(shared_folder / "library", make) / "whole.mcap"


@pytest.fixture
def library(window, store, recorded, qtbot, tmp_path):
    """The library with one session, selected."""
    folder = tmp_path / "sessions"
    folder.mkdir()
    shutil.copy(recorded, folder / "P01_pinch.mcap")
    window.recording.set_folder(folder)
    window.library.rescan()
    qtbot.waitUntil(lambda: window.library.selected() is not None)
    return window.library


@pytest.fixture
def replayed(library, window, qtbot):
    """The session opened by its button, paused once the hand has been found."""
    qtbot.mouseClick(library.buttons["replay"], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.host.running)
    window.docks["library"].raise_()
    player = window.host.setup.player
    window.run_command("play")
    player.seek(1.5)
    qtbot.waitUntil(lambda: window.hand._scene is not None)
    qtbot.waitUntil(lambda: not window.tasks.tasks)
    return library


def press(qtbot, dialog, role=QDialogButtonBox.ButtonRole.AcceptRole) -> None:
    """Press the dialog's button of that role."""
    box = dialog.findChild(QDialogButtonBox)
    [button] = [b for b in box.buttons() if box.buttonRole(b) == role]
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def ended(library) -> bool:
    return not any(i.open for i in library.exports.items)


def test_a_row_shows_length_integrity_and_quality(library, qtbot):
    quality = library.table.item(0, 5)
    qtbot.waitUntil(lambda: "tracked" in quality.text())
    share = int(quality.text().split("tracked ")[1].split(" ")[0])
    with SessionReader(library.selected().path) as reader:
        states = [m.tracking == 1 for m in reader.messages((Estimate,))]
    assert share == pytest.approx(100 * sum(states) / len(states), abs=6)
    assert library.table.item(0, 2).text() == "0:03"
    assert "complete" in library.table.item(0, 4).text()
    assert not library.buttons["recover"].isEnabled()


@pytest.mark.long
def test_the_timeline_is_dragged_and_stepped(replayed, window, qtbot):
    line, player = replayed.transport.timeline, window.host.setup.player
    y = int(line.height() * 0.3)
    qtbot.mousePress(line, Qt.MouseButton.LeftButton, pos=QPoint(int(line.x_of(1.0)), y))
    qtbot.mouseRelease(line, Qt.MouseButton.LeftButton, pos=QPoint(int(line.x_of(1.0)), y))
    qtbot.waitUntil(lambda: player.position == pytest.approx(1.0, abs=0.08))
    qtbot.waitUntil(lambda: player.images_due == 0)
    before = window.host.snapshot().frame.index
    line.setFocus()
    qtbot.keyClick(line, Qt.Key.Key_Right)
    qtbot.waitUntil(lambda: window.host.snapshot().frame.index == before + 1)
    qtbot.keyClick(line, Qt.Key.Key_Left)
    qtbot.waitUntil(lambda: window.host.snapshot().frame.index == before)


def test_in_and_out_points_limit_replay_and_export(replayed, window, qtbot, tmp_path):
    player = window.host.setup.player
    for place, key in ((0.8, "in_point"), (1.8, "out_point")):
        player.seek(place)
        qtbot.waitUntil(lambda p=place: player.position == pytest.approx(p, abs=0.08))
        window.run_command(key)
    start, stop = player.range
    assert (start, stop) == (pytest.approx(0.8, abs=0.08), pytest.approx(1.8, abs=0.08))
    window.run_command("export")
    dialog = replayed.findChild(ExportDialog)
    assert dialog.range.isChecked()
    dialog.folder.setText(str(tmp_path))
    press(qtbot, dialog)
    qtbot.waitUntil(lambda: ended(replayed))
    [item] = replayed.exports.items
    assert item.look == DONE, item.problem
    with item.request.target.open() as file:
        rows = list(csv.DictReader(file))
    with SessionReader(item.request.source) as reader:
        begin = reader.anchor.wall(reader.anchor.monotonic(reader.span_ns[0])) / 1e9
    assert float(rows[0]["t"]) - begin == pytest.approx(start, abs=0.011)
    assert float(rows[-1]["t"]) - begin == pytest.approx(stop, abs=0.011)


def test_exports_are_queued_and_can_be_cancelled(qtbot, tmp_path, monkeypatch, no_leaks):
    go = threading.Event()

    def job_of(request):
        def job(progress):
            if request.form == "bad":
                raise OSError("the disk is away")
            while not go.wait(0.01):
                progress(0.5, "")

        return job

    monkeypatch.setattr("app.jobs.export.export_job", job_of)
    tasks = TaskOwner()
    queue = ExportQueue(tasks)
    names = ("csv", "bvh", "bad", "h5")
    first, second, bad, last = (
        queue.add(ExportRequest(tmp_path / "a.mcap", form, tmp_path / f"a.{form}"))
        for form in names
    )
    qtbot.waitUntil(lambda: first.share == 0.5)
    assert [i.look for i in (second, bad, last)] == [WAITING] * 3
    queue.cancel(last)
    queue.cancel(first)
    qtbot.waitUntil(lambda: second.share == 0.5)
    assert first.look == CANCELLED
    go.set()
    qtbot.waitUntil(lambda: not any(i.open for i in queue.items))
    assert [i.look for i in queue.items] == [CANCELLED, DONE, FAILED, CANCELLED]
    assert "the disk is away" in bad.problem
    queue.forget_ended()
    assert queue.items == []


@pytest.mark.long
def test_a_cancelled_export_leaves_no_file(recorded, tmp_path):
    from app.jobs.export import export_job
    from app.platform.tasks import Cancelled

    shares = []
    progress = JobProgress(lambda share, _text: shares.append(share))
    job = export_job(ExportRequest(recorded, "csv", tmp_path / "out.csv"))

    class Impatient(JobProgress):
        def __call__(self, fraction: float, text: str = "") -> None:
            super().__call__(fraction, text)
            if fraction > 0.3:
                self.cancel()

    with pytest.raises(Cancelled):
        job(Impatient(lambda *_: None))
    assert list(tmp_path.iterdir()) == []
    job(progress)
    assert (tmp_path / "out.csv").is_file()
    assert max(shares) > 0.8


@pytest.mark.long
@pytest.mark.timeout(120)
def test_a_new_tracking_is_shown_and_compared(replayed, window, qtbot):
    window.run_command("again")
    dialog = replayed.findChild(TrackDialog)
    dialog.engine.setCurrentIndex(dialog.engine.findData("vist"))
    press(qtbot, dialog)
    qtbot.waitUntil(lambda: replayed.findChild(CompareDialog) is not None, timeout=90_000)
    table = replayed.findChild(CompareDialog)
    assert "closer to the truth" in table.summary.text()
    first = [table.table.item(0, j).text() for j in range(4)]
    assert all(text.endswith("mm") for text in first[1:])
    table.close()
    source = replayed._opened_paths()[0]
    with SessionReader(source.with_name("P01_pinch_vist.mcap")) as reader:
        other = {round(m.t, 6): m for m in reader.messages((Estimate,))}
    player = window.host.setup.player
    player.seek(2.0)
    qtbot.waitUntil(lambda: player.position >= 2.0 and player.images_due == 0)
    view = window.host.snapshot()
    wanted = other[round(view.estimate.t, 6)]
    assert view.reference().p_GB == pytest.approx(wanted.segment_p, abs=1e-6)
    assert window.hand.controls.shown().reference
    qtbot.waitUntil(lambda: replayed.table.rowCount() == 2)


def test_a_truncated_session_is_recovered_by_its_button(library, window, qtbot):
    path = library.selected().path
    data = path.read_bytes()
    path.write_bytes(data[: len(data) * 2 // 3])
    library.rescan()
    recover = library.buttons["recover"]
    qtbot.waitUntil(recover.isEnabled)
    assert "interrupted" in library.table.item(0, 4).text()
    qtbot.mouseClick(recover, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: library.table.rowCount() == 2)
    made = path.with_name("P01_pinch_recovered.mcap")
    with SessionReader(made) as reader:
        assert reader.source.contents.finished
        assert reader.duration > 1.0
    assert path.read_bytes() == data[: len(data) * 2 // 3]


def test_the_file_being_recorded_is_not_reported_as_damaged(recorded):
    row = session_row(recorded, recording=recorded)
    assert row.integrity == "being recorded"
    assert not row.recoverable


@pytest.mark.long
def test_obsolete_settings_of_a_recording_are_reported_and_ignored(recorded, tmp_path):
    old = tmp_path / "old.mcap"
    with SessionReader(recorded) as reader:
        info = replace(reader.info, rig=reader.rig(), settings_text="[chain]\nwarp = 9\n")
        with SessionRecorder(old, info, RecorderParams(sync=False)) as recorder:
            for message in reader.messages():
                recorder.write(message)
    job = track_job(old, tmp_path / "new.mcap", TrackOptions())
    done = job(JobProgress(lambda *_: None))
    assert done.figures["compared"] > 200
    assert shows(summary(done), "track.settings_unused", file="old.mcap", settings="chain.warp")
    usual = track_job(old, tmp_path / "usual.mcap", TrackOptions(settings=USUAL))
    same = usual(JobProgress(lambda *_: None))
    assert same.figures["compared"] > 200 and "warp" not in summary(same)
    assert compare(tmp_path / "new.mcap", tmp_path / "usual.mcap")["identical"]


def test_a_file_put_into_the_folder_appears_automatically(library, recorded, qtbot):
    folder = library.selected().path.parent
    shutil.copy(recorded, folder / "brought.mcap")
    qtbot.waitUntil(lambda: library.table.rowCount() == 2)
    (folder / "brought.mcap").unlink()
    qtbot.waitUntil(lambda: library.table.rowCount() == 1)


@pytest.mark.styled
def test_the_reference_is_named_and_so_are_the_engines_in_the_columns(window, tmp_path):
    controls = window.hand.controls
    other = controls.reference.findData("other")
    assert not controls.reference.model().item(other).isEnabled()  # nothing is there to compare
    window.library.second_named.emit("vist")
    assert controls.reference.currentText() == "Reference: VIST"
    figures = {"identical": True, "compared": 3, "mean_mm": 0.0, "max_mm": 0.0, "rms_deg": 0.0}
    figures |= {"keypoints_mm": {}, "joints_rms_deg": {}}
    paths, errors = (tmp_path / "a.mcap", tmp_path / "a_vist.mcap"), ({"wrist": 1.0},) * 2
    names = [
        Comparison(*paths, figures, errors, engines).names
        for engines in (("chain", "vist"), ("chain", "chain"), ("", "vist"))
    ]
    assert names == [("Chain", "VIST"), ("a", "a_vist"), ("a", "a_vist")]
    dialog = CompareDialog(Comparison(*paths, figures, errors, ("chain", "vist")), window)
    table = dialog.table
    assert table.horizontalHeaderItem(3).text() == "Error of VIST"
    assert table.horizontalHeader().length() <= max(table.viewport().width(), 100 * 4)
