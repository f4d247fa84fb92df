"""A study in the window, by clicks, with a scripted engine."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QDialog

from app.engines.protocols import RecordingRequest
from app.window.main_window import MainWindow
from extensions.study.command_runs import protocol_path
from extensions.study.conductor import TrialPhase
from extensions.study.folder import Study, start_study
from extensions.study.progress import ACCEPTED
from extensions.study.tests.studies import SHORT, write_protocol
from extensions.study.verdict import MeasuredRecording, TrialVerdict
from extensions.study.window.dialog import StudyDialog
from extensions.study.window.start import show_study
from tests.gui.gui_fakes import MemoryRecorder, ScriptedEngine, scripted_setup
from tests.notices import shows
from tracker.base.notices import warning
from tracker.messages import Event

PATIENCE_MS = 60_000
TEXT = (
    SHORT.replace("seed = 3", 'seed = 3\norder = "fixed"')
    .replace("participants = 2", "participants = 1")
    .replace("countdown = 1.5", "countdown = 0.0")
    .replace("duration = 6.0", "duration = 1.0")
    .replace("practice_duration = 2.0", "practice_duration = 1.0")
    .replace('"Fist", "Flat hand", "Point"', '"hand.png"')
)


@pytest.fixture
def study(tmp_path: Path) -> Study:
    """Its only cue is a picture."""
    image = QImage(40, 20, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.red)
    image.save(str(tmp_path / "hand.png"))
    return start_study(write_protocol(tmp_path, TEXT), tmp_path / "study")


@pytest.fixture
def recorders() -> list[MemoryRecorder]:
    return []


@pytest.fixture
def dialog(
    window: MainWindow, study: Study, recorders: list[MemoryRecorder], qtbot, monkeypatch
) -> StudyDialog:
    """Verdicts are those of ``verdicts``, since the recorder writes no file."""
    window.host.adopt(scripted_setup(ScriptedEngine(), recorders))
    qtbot.waitUntil(lambda: window.host.running, timeout=PATIENCE_MS)
    verdicts = [TrialVerdict(MeasuredRecording(), (warning("study.unfinished"),))]

    def verdict_job(path: Path, step, limits):
        return lambda progress: (
            verdicts.pop() if verdicts else TrialVerdict(MeasuredRecording(duration=1.0))
        )

    monkeypatch.setattr("extensions.study.window.dialog.verdict_job", verdict_job)
    show_study(window.context, study)
    (made,) = window.findChildren(StudyDialog)
    assert made.isVisible()
    return made


def click(button, qtbot) -> None:
    assert button.isVisible() and button.isEnabled()
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def reach(dialog: StudyDialog, phase: TrialPhase, qtbot) -> None:
    assert dialog.conductor is not None
    conductor = dialog.conductor
    qtbot.waitUntil(lambda: conductor.phase is phase, timeout=PATIENCE_MS)
    dialog.tick()


@pytest.mark.long
@pytest.mark.processes
def test_a_study_is_run_by_clicks(
    dialog: StudyDialog, study: Study, window: MainWindow, recorders: list[MemoryRecorder], qtbot
) -> None:
    """Practice, a trial that is repeated, a rest that is skipped, and a timed trial."""
    assert "Practice" in dialog.title.text() and "Copy each posture." in dialog.detail.text()
    click(dialog.next_button, qtbot)
    assert not dialog.cue.pixmap().isNull() and recorders == []
    reach(dialog, TrialPhase.READY, qtbot)
    click(dialog.next_button, qtbot)
    request = window.host.recording.request
    assert request is not None and request.participant == "P01" and request.task == "postures"
    assert request.path.name == "sub-P01_ses-free_task-postures_run-01.mcap"
    assert not dialog.participants.isEnabled()
    reach(dialog, TrialPhase.VERDICT, qtbot)
    assert dialog.cue.text() == "Not good" and dialog.exclude_button.isVisible()
    assert dialog.repeat_button.property("role") == "primary"
    click(dialog.repeat_button, qtbot)
    click(dialog.next_button, qtbot)
    reach(dialog, TrialPhase.VERDICT, qtbot)
    assert dialog.cue.text() == "Good" and dialog.next_button.property("role") == "primary"
    notes = [m for r in recorders for m in r.messages if isinstance(m, Event) and m.kind == "note"]
    assert [n.text for n in notes] == ["hand.png", "hand.png"]
    click(dialog.next_button, qtbot)
    assert dialog.title.text() == "Rest"
    click(dialog.next_button, qtbot)
    click(dialog.next_button, qtbot)
    assert dialog.next_button.text() == "&Finished"
    click(dialog.next_button, qtbot)
    reach(dialog, TrialPhase.VERDICT, qtbot)
    click(dialog.next_button, qtbot)
    assert dialog.title.text() == "Finished" and not dialog.next_button.isVisible()
    progress = study.progress("P01")
    assert {progress.entry(s).state for s in progress.trials} == {ACCEPTED}
    assert [len(progress.entry(s).tries) for s in progress.trials] == [2, 1]


def test_closing_the_dialog_interrupts_the_trial(
    dialog: StudyDialog, study: Study, window: MainWindow, qtbot
) -> None:
    click(dialog.next_button, qtbot)
    reach(dialog, TrialPhase.READY, qtbot)
    click(dialog.next_button, qtbot)
    assert window.host.recording.request is not None
    dialog.close()
    assert window.host.recording.request is None
    progress = study.progress("P01")
    progress.resume()
    step = progress.step
    assert step is not None and step.task == "postures"
    (one,) = progress.entry(step).tries
    assert one.outcome == "interrupted" and (progress.root / one.file).is_file()


def test_without_an_engine_no_trial_begins(window: MainWindow, study: Study, qtbot) -> None:
    show_study(window.context, study)
    (dialog,) = window.findChildren(StudyDialog)
    click(dialog.next_button, qtbot)
    reach(dialog, TrialPhase.READY, qtbot)
    click(dialog.next_button, qtbot)
    assert shows(dialog.detail.text(), "study.no_engine")
    dialog.close()


@pytest.mark.long
def test_a_touch_trial_is_the_windows_touch_test(
    window: MainWindow, tmp_path: Path, recorders: list[MemoryRecorder], qtbot, monkeypatch
) -> None:
    """Its recording becomes the trial's file, and remains where the touch test wrote it."""
    study = start_study(protocol_path("touch"), tmp_path / "study")
    window.host.adopt(scripted_setup(ScriptedEngine(), recorders))
    qtbot.waitUntil(lambda: window.host.running, timeout=PATIENCE_MS)
    monkeypatch.setattr(
        "extensions.study.window.dialog.verdict_job",
        lambda path, step, limits: lambda progress: TrialVerdict(MeasuredRecording(duration=300.0)),
    )
    show_study(window.context, study, "P02")
    (dialog,) = window.findChildren(StudyDialog)
    click(dialog.next_button, qtbot)
    reach(dialog, TrialPhase.RUNNING, qtbot)
    (touch,) = (d for d in window.findChildren(QDialog) if d.objectName() == "touch_test")
    assert touch.isVisible() and window.store.value.participant == "P02"
    assert window.host.recording.request is None, "the touch test records itself"
    own = tmp_path / "touch-test.mcap"
    assert window.host.recording.begin(RecordingRequest(own, "P02", "touch-test"))
    window.host.recording.end()
    reach(dialog, TrialPhase.VERDICT, qtbot)
    click(dialog.next_button, qtbot)
    progress = study.progress("P02")
    first = progress.trials[0]
    assert progress.entry(first).state == ACCEPTED and own.is_file()
    assert progress.path(first).samefile(own)
