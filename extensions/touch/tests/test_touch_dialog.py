"""The dialog of the touch test in the window, by clicks."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from app.window.main_window import MainWindow
from extensions.touch.pose import SheetPose
from extensions.touch.protocol import cues_of, ruler_of
from extensions.touch.tests.test_guided_touch import POSE
from extensions.touch.window.dialog import TouchDialog
from extensions.touch.window.view_model import TouchPhase
from tests.gui.gui_fakes import MemoryRecorder, ScriptedEngine, scripted_setup
from tracker.messages import Event

PATIENCE_MS = 60_000


@pytest.fixture
def recorders() -> list[MemoryRecorder]:
    return []


@pytest.fixture
def dialog(
    window: MainWindow, recorders: list[MemoryRecorder], tmp_path: Path, qtbot
) -> TouchDialog:
    """Opened from the menu while a hand is tracked."""
    window.store.update(sessions_folder=str(tmp_path))
    window.host.adopt(scripted_setup(ScriptedEngine(), recorders))
    qtbot.waitUntil(lambda: window.host.running, timeout=PATIENCE_MS)
    window.run_command("touch_test")
    (made,) = window.findChildren(TouchDialog)
    assert made.isVisible()
    return made


def click(button, qtbot) -> None:
    assert button.isVisible() and button.isEnabled()
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_the_sheet_is_saved_and_failures_are_reported(dialog: TouchDialog, tmp_path: Path) -> None:
    path = tmp_path / "sheet.pdf"
    dialog.save_sheet(path)
    assert path.read_bytes().startswith(b"%PDF") and str(path) in dialog.how.text()
    dialog.save_sheet(tmp_path / "missing" / "sheet.pdf")
    assert "Sheet saved" not in dialog.how.text() and "missing" in dialog.how.text()


def test_without_a_sheet_in_view_nothing_is_recorded(
    dialog: TouchDialog, recorders: list[MemoryRecorder], qtbot
) -> None:
    before = dialog.how.text()
    click(dialog.start_button, qtbot)
    assert dialog.run.phase == TouchPhase.WAITING and recorders == []
    assert dialog.how.text() not in ("", before)


def test_it_leads_through_all_cues_and_records_them(
    dialog: TouchDialog,
    window: MainWindow,
    recorders: list[MemoryRecorder],
    monkeypatch: pytest.MonkeyPatch,
    qtbot,
) -> None:
    """Each touch is accepted by a click, one is repeated, and the last two cues are skipped."""

    def found(*_: object) -> SheetPose:
        return POSE

    monkeypatch.setattr("extensions.touch.window.dialog.find_sheet", found)
    dialog.ruler.setValue(261.0)
    click(dialog.start_button, qtbot)
    assert window.host.recording.request is not None and not dialog.sheet_button.isVisible()
    first = dialog.words.text()
    click(dialog.accept_button, qtbot)
    qtbot.waitUntil(lambda: dialog.words.text() != first, timeout=PATIENCE_MS)
    click(dialog.repeat_button, qtbot)
    qtbot.waitUntil(lambda: dialog.words.text() == first, timeout=PATIENCE_MS)
    touches = sum(cue.what == "touch" for cue in dialog.run.cues)
    for _ in range(touches):
        click(dialog.accept_button, qtbot)
    for _ in dialog.run.cues[touches:]:
        click(dialog.skip_button, qtbot)
    # the recording of a scripted engine contains no session, so it has no report
    qtbot.waitUntil(lambda: "No report was written" in dialog.words.text(), timeout=PATIENCE_MS)
    assert window.host.recording.request is None and dialog.start_button.isVisible()
    (recorder,) = recorders
    events = [m for m in recorder.messages if isinstance(m, Event)]
    cues = cues_of(events)
    assert len([c for c in cues if c.cue.what == "touch"]) == touches == 24
    assert ruler_of(events) == pytest.approx(0.261)


def test_closing_it_ends_the_recording(
    dialog: TouchDialog,
    window: MainWindow,
    monkeypatch: pytest.MonkeyPatch,
    qtbot,
) -> None:
    monkeypatch.setattr("extensions.touch.window.dialog.find_sheet", lambda *_: POSE)
    click(dialog.start_button, qtbot)
    assert window.host.recording.request is not None
    dialog.close()
    qtbot.waitUntil(lambda: window.host.recording.request is None, timeout=PATIENCE_MS)
    assert dialog.run.phase == TouchPhase.DONE
