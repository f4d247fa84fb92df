"""The dialogs of the import and of the accuracy report in the window, by clicks and keys."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QDesktopServices

from app.window.main_window import MainWindow
from extensions.reference.importing import ReferenceImportOptions
from extensions.reference.tests.conftest import Wearer
from extensions.reference.tests.laboratory import FAULTY, write_c3d
from extensions.reference.window.accuracy_dialog import AccuracyDialog
from extensions.reference.window.import_dialog import ImportDialog, ImportForm
from tests.notices import shows
from tracker.messages import Array
from tracker.session.reader import SessionReader

PATIENCE_MS = 60_000


@pytest.fixture
def session(short: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(short, tmp_path / "take.mcap"))


@pytest.fixture
def replayed(window: MainWindow, session: Path, qtbot) -> MainWindow:
    """The window with the session of 20 s."""
    open_in(window, session, qtbot)
    return window


def open_in(window: MainWindow, path: Path, qtbot) -> None:
    window.sources.open_session(path)
    qtbot.waitUntil(lambda: replays(window, path), timeout=PATIENCE_MS)
    window.host.setup.player.pause_at(0.0)  # playing takes a core from what is waited for


def replays(window: MainWindow, path: Path) -> bool:
    setup = window.host.setup
    return setup is not None and setup.player is not None and setup.player.path == path


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Files that were opened in other programs."""
    paths: list[str] = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: paths.append(url.toLocalFile()))
    return paths


@pytest.fixture
def dialog(replayed: MainWindow) -> ImportDialog:
    """Opened from the menu."""
    replayed.run_command("reference_import")
    (made,) = replayed.findChildren(ImportDialog)
    assert made.isVisible()
    return made


@pytest.fixture(scope="module")
def x_L(wearer: Wearer) -> Array:
    """Markers of 19 s with the laboratory's faults, in L."""
    return FAULTY.record(wearer, 19.0)[1]


def choose(dialog: ImportDialog, path: Path, qtbot) -> str:
    """Chooses a reference and returns the dialog's text about it."""
    dialog.form.reference.setText(str(path))
    dialog.form.reference.editingFinished.emit()
    return what_is_read(dialog, qtbot)


def what_is_read(dialog: ImportDialog, qtbot) -> str:
    label = dialog.form.recognised
    qtbot.waitUntil(lambda: label.text() != "Reading the file…", timeout=PATIENCE_MS)
    return label.text()


def click(button, qtbot) -> None:
    assert button.isVisible() and button.isEnabled()
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_the_commands_need_a_replay(window: MainWindow, session: Path, qtbot) -> None:
    keys = ("reference_import", "reference_accuracy")
    assert not any(window.commands.actions[key].isEnabled() for key in keys)
    open_in(window, session, qtbot)
    assert all(window.commands.actions[key].isEnabled() for key in keys)


@pytest.mark.long
@pytest.mark.processes
def test_a_reference_is_imported_and_the_new_session_shows_it(
    dialog: ImportDialog, wearer: Wearer, x_L: Array, replayed: MainWindow, session: Path, qtbot
) -> None:
    """The faults that were put in are in the text: 37 ms, within 0.2 ms."""
    path = write_c3d(session.with_name("lab.c3d"), wearer.info.keypoint_names, x_L)
    assert not dialog.import_button.isEnabled()
    words = choose(dialog, path, qtbot)
    count = len(wearer.info.keypoint_names)
    assert words.startswith(f"C3D: 19.0 s at 120 Hz, {count} points, {count} of {count} keypoints.")
    click(dialog.import_button, qtbot)
    assert dialog.progress.isVisible() and not dialog.import_button.isEnabled()
    out = session.with_name("take_reference.mcap")
    qtbot.waitUntil(lambda: replays(replayed, out), timeout=PATIENCE_MS)
    lines = dialog.words.text().splitlines()
    assert "take_reference.mcap" in lines[0]
    offset = float(lines[1].split("Time offset ")[1].split(" ms")[0])
    assert offset == pytest.approx(37.0, abs=0.21)
    rows = dialog.table.rowCount()
    residuals = [float(dialog.table.item(row, 2).text()) for row in range(rows)]
    noise = 1e3 * np.sqrt(3 * (0.001**2 + 0.0003**2))  # of session and laboratory
    assert rows == count and np.allclose(residuals, noise, atol=0.2)
    setup = replayed.host.setup
    assert setup.truth.is_measured and replayed.hand.controls.shown().reference
    setup.player.pause_at(10.0)
    qtbot.waitUntil(lambda: setup.truth.at(0.0) is not None, timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: dialog.import_button.isEnabled(), timeout=PATIENCE_MS)
    assert not dialog.progress.isVisible()


@pytest.mark.long
def test_errors_are_reported_before_the_import(
    dialog: ImportDialog, wearer: Wearer, x_L: Array, replayed: MainWindow, session: Path, qtbot
) -> None:
    """Files that cannot be read or lack points, and a mirrored one; nothing is imported."""
    garbage = session.with_name("notes.csv")
    garbage.write_text("a,b\n1,2\n")
    assert shows(choose(dialog, garbage, qtbot), "reference.unknown_format")
    two = write_c3d(session.with_name("two.c3d"), ("wrist", "B"), x_L[:, :2])
    assert shows(choose(dialog, two, qtbot), "reference.few_points", found=1)
    assert not dialog.import_button.isEnabled()
    mirrored = x_L * [1.0, -1.0, 1.0]
    path = write_c3d(session.with_name("m.c3d"), wearer.info.keypoint_names, mirrored)
    choose(dialog, path, qtbot)
    click(dialog.import_button, qtbot)
    qtbot.waitUntil(lambda: "is mirrored" in dialog.words.text(), timeout=PATIENCE_MS)
    assert replays(replayed, session)
    assert [p.name for p in session.parent.glob("*.mcap")] == ["take.mcap"]


@pytest.mark.long
def test_a_template_makes_an_unknown_csv_readable(
    dialog: ImportDialog, wearer: Wearer, x_L: Array, session: Path, opened: list[str], qtbot
) -> None:
    """Its columns are named by a scheme that no format has; the editor is closed with a change."""
    path, names = session.with_name("lab.csv"), wearer.info.keypoint_names
    t = np.arange(len(x_L)) / 120
    header = ["time", *(f"{n} {a}" for n in names for a in "XYZ")]
    table = np.column_stack([t, 1e3 * x_L.reshape(len(t), -1)])
    np.savetxt(path, table, delimiter=";", header=";".join(header), comments="", fmt="%.4f")
    assert shows(choose(dialog, path, qtbot), "reference.unknown_format")
    mapping = session.with_name("lab.toml")
    dialog.write_template(mapping)
    qtbot.waitUntil(lambda: opened == [str(mapping)], timeout=PATIENCE_MS)
    count = len(names)
    assert f"{count} of {count} keypoints" in what_is_read(dialog, qtbot)
    lines = mapping.read_text("utf-8").splitlines()
    some = [line for line in lines if not line.startswith(("little_tip =", '"little_tip" ='))]
    mapping.write_text("\n".join(some), "utf-8")
    os.utime(mapping, (1e9, 1e9))  # clocks of file systems are coarse
    dialog.event(activation())
    assert f"{count - 1} of {count} keypoints. Without: little tip." in what_is_read(dialog, qtbot)


def activation():
    from PySide6.QtCore import QEvent

    return QEvent(QEvent.Type.WindowActivate)


def test_each_alignment_method_has_its_field(replayed: MainWindow, session: Path, qtbot) -> None:
    form = ImportForm(replayed.host.setup, session)
    qtbot.addWidget(form)
    form.show()

    def choose_in(box, value: str) -> None:
        box.setCurrentIndex(box.findData(value))

    assert form.options() == ReferenceImportOptions()
    assert not (form.pulse.isVisible() or form.start.isVisible() or form.hand.isVisible())
    form.pulse.setText("Sync")
    form.start.setText("2026-03-31T14:05:09")
    choose_in(form.way, "pulse")
    assert form.pulse.isVisible() and form.options() == ReferenceImportOptions(
        by="pulse", pulse="Sync"
    )
    form.drift.setChecked(False)
    choose_in(form.registration, "none")
    choose_in(form.way, "clock")
    assert form.start.isVisible() and not form.drift.isEnabled()
    assert form.options() == ReferenceImportOptions(
        by="clock", start="2026-03-31T14:05:09", with_drift=False, register="none"
    )


def test_closing_the_dialog_cancels_the_import(
    dialog: ImportDialog, replayed: MainWindow, wearer: Wearer, x_L: Array, session: Path, qtbot
) -> None:
    path = write_c3d(session.with_name("lab.c3d"), wearer.info.keypoint_names, x_L)
    choose(dialog, path, qtbot)
    click(dialog.import_button, qtbot)
    dialog.close()
    qtbot.waitUntil(lambda: not replayed.tasks.tasks, timeout=PATIENCE_MS)
    assert not session.with_name("take_reference.mcap").exists() and replays(replayed, session)


@pytest.fixture
def with_reference(imported: Path, tmp_path: Path) -> Path:
    """24 s with a reference."""
    return Path(shutil.copy(imported, tmp_path / "P01.mcap"))


def report_of(window: MainWindow, qtbot) -> AccuracyDialog:
    """The opened dialog, with its report."""
    (dialog,) = window.findChildren(AccuracyDialog)
    click(dialog.write_button, qtbot)
    qtbot.waitUntil(lambda: dialog.table.isVisible(), timeout=PATIENCE_MS)
    return dialog


@pytest.mark.long
def test_a_report_lists_the_worst_instants_which_the_replay_shows(
    window: MainWindow, with_reference: Path, opened: list[str], qtbot
) -> None:
    open_in(window, with_reference, qtbot)
    window.run_command("reference_accuracy")
    dialog = report_of(window, qtbot)
    page = with_reference.with_name("P01_accuracy.html")
    assert opened == [str(page)] and dialog.words.text() in page.read_text("utf-8")
    errors = [float(dialog.table.item(row, 2).text()) for row in range(dialog.table.rowCount())]
    assert len(errors) == 10 and errors == sorted(errors, reverse=True)
    assert {dialog.table.item(row, 4).text() for row in range(10)} == {"1.0"}  # the claimed 1 mm
    dialog.table.setCurrentCell(3, 0)
    qtbot.keyClick(dialog.table, Qt.Key.Key_Return)
    assert_paused_at(window, dialog.worst[3].t, qtbot)
    place = dialog.table.visualItemRect(dialog.table.item(0, 1)).center()
    qtbot.mouseClick(dialog.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    qtbot.mouseDClick(dialog.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert_paused_at(window, dialog.worst[0].t, qtbot)
    assert opened == [str(page)], "Enter has written another report"
    commands = [line for line in page.read_text("utf-8").split("<td>") if "--at" in line]
    at = float(commands[0].split("--at ")[1].split("<")[0])
    assert len(commands) == 10 and dialog.worst[0].t <= at < dialog.worst[0].t + 0.001


def assert_paused_at(window: MainWindow, t: float, qtbot) -> None:
    """The replay shows the estimate of the instant."""
    setup = window.host.setup

    def shows() -> bool:
        hand = setup.tracked.latest_estimate()
        return hand is not None and abs(hand.t - setup.engine.start_t - t) < 1e-6

    qtbot.waitUntil(shows, timeout=PATIENCE_MS)
    assert setup.player.position == pytest.approx(t) and not setup.player.playing


@pytest.mark.long
def test_several_recordings_are_in_one_report(
    window: MainWindow, with_reference: Path, opened: list[str], qtbot
) -> None:
    """Chosen in the library; a row opens its own recording."""
    second = Path(shutil.copy(with_reference, with_reference.with_name("P02.mcap")))
    window.library._actions["reference_accuracy_of"].run([with_reference, second])
    dialog = report_of(window, qtbot)
    assert "2 simulated recordings" in dialog.words.text()
    assert opened == [str(with_reference.with_name("accuracy.html"))]
    names = [dialog.table.item(row, 6).text() for row in range(10)]
    assert {"P01", "P02"} == set(names) and not dialog.table.isColumnHidden(6)
    row = names.index("P02")
    dialog.show_instant(row)
    qtbot.waitUntil(lambda: replays(window, second), timeout=PATIENCE_MS)
    assert_paused_at(window, dialog.worst[row].t, qtbot)


def test_a_session_without_a_reference_is_named(replayed: MainWindow, opened, qtbot) -> None:
    replayed.run_command("reference_accuracy")
    (dialog,) = replayed.findChildren(AccuracyDialog)
    click(dialog.write_button, qtbot)
    qtbot.waitUntil(lambda: "does not contain a reference" in dialog.words.text(),
                    timeout=PATIENCE_MS)  # fmt: skip
    qtbot.waitUntil(dialog.write_button.isEnabled, timeout=PATIENCE_MS)
    dialog.sessions.item(0).setSelected(True)
    click(dialog.remove_button, qtbot)
    assert dialog.paths == [] and not dialog.write_button.isEnabled() and opened == []


def test_an_imported_session_remembers_its_residuals(imported: Path) -> None:
    with SessionReader(imported) as reader:
        text = reader.attachments["reference_right.json"]
    assert '"keypoint_residuals"' in text and '"covered"' in text
